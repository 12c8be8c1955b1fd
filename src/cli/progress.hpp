#pragma once
#include <chrono>
#include <cstdio>
#include <string>

#include "solve/observer.hpp"

namespace ashlar {

/// Tells a person how a run goes: one live line on a terminal, else a line per stage, increment and first crack.
class ProgressLines : public Observer {
 public:
  /// @param live whether `out` is a terminal on which a line can be rewritten
  ProgressLines(std::FILE* out, bool live) : out_(out), live_(live) {}
  ~ProgressLines() override { clear_live_line(); }

  void stage_begins(int number, const std::string& name, const std::string& kind) override;
  void progress(const Progress& progress) override;
  void crack(const std::string& stage, const CrackEvent& event) override;
  void stage_ends(const StageResult& result) override;
  bool interrupted() override;

 private:
  using Clock = std::chrono::steady_clock;
  std::string line_of(const Progress& progress) const;
  void print(const std::string& line);
  void clear_live_line();

  std::FILE* out_;
  bool live_;
  bool live_line_shown_ = false;
  bool interrupt_told_ = false;
  int increment_ = 0;
  long events_ = 0;
  Clock::time_point stage_start_, last_plain_line_;
};

}  // namespace ashlar
