#pragma once
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "backend/backend.hpp"

namespace ashlar {

/// The machine on which the heat of coupled stages marches, while that of the stress looks for equilibrium. Beside it,
/// from a thread of its own that alone uses the machine, or in turns with it, which gives the same bits.
class Lane {
 public:
  using Clock = std::chrono::steady_clock;

  Lane(const std::function<std::unique_ptr<Backend>()>& make, bool beside);
  ~Lane();
  Lane(const Lane&) = delete;

  bool beside() const { return thread_.joinable(); }
  /// Begins work, when the last one has been waited for; with no thread it has ended when this returns.
  void start(std::function<void()> work);
  /// Until the work has ended; calls `meanwhile` every tenth of a second. Throws what the work threw.
  void wait(const std::function<void()>& meanwhile = {});
  void run(std::function<void()> work) {
    start(std::move(work));
    wait();
  }
  /// For work; for others while there is none.
  Backend& backend() const { return *backend_; }
  /// When the last work began and ended.
  Clock::time_point began() const { return began_; }
  Clock::time_point ended() const { return ended_; }

 private:
  void serve();
  void do_work();
  void close();

  std::unique_ptr<Backend> backend_;
  std::function<void()> work_;
  bool busy_ = false, closing_ = false;
  std::exception_ptr error_;
  Clock::time_point began_, ended_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

}  // namespace ashlar
