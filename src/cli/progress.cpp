#include "cli/progress.hpp"

#include "cli/interrupt.hpp"
#include "cli/wording.hpp"

namespace ashlar {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string clock_text(double seconds) {
  const long whole = static_cast<long>(seconds + 0.5);
  return whole < 3600 ? text("%02ld:%02ld", whole / 60, whole % 60) : duration_text(seconds);
}

}  // namespace

void ProgressLines::stage_begins(int number, const std::string& name, const std::string& kind) {
  stage_start_ = last_plain_line_ = Clock::now();
  increment_ = 0;
  events_ = 0;
  if (!live_) print(text("stage %d %s: %s", number, name.c_str(), kind.c_str()));
}

std::string ProgressLines::line_of(const Progress& p) const {
  std::string line = text("stage %d/%d %s", p.stage_number, p.stage_count, p.stage.c_str());
  if (p.increments > 0) line += text("  increment %d/%d", p.increment, p.increments);
  line += text("  step %ld", p.step);
  if (p.target > 0) line += text("  ratio %.1e -> %.0e", p.ratio, p.target);
  if (events_ > 0) line += "  " + counted(events_, "crack event");
  if (p.cracked_fraction > 0) line += text("  broken %.1f %%", 100 * p.cracked_fraction);
  if (p.fraction > 0.01 && p.fraction < 1)
    line += "  ETA " + clock_text(seconds_since(stage_start_) * (1 - p.fraction) / p.fraction);
  return line;
}

void ProgressLines::progress(const Progress& p) {
  if (live_) {
    std::fprintf(out_, "\r\033[K%s", line_of(p).c_str());
    std::fflush(out_);
    live_line_shown_ = true;
    return;
  }
  // A pipe gets a line per increment, and one now and then while a long stage goes on.
  if (p.increment == increment_ && seconds_since(last_plain_line_) < 60) return;
  increment_ = p.increment;
  last_plain_line_ = Clock::now();
  print(line_of(p));
}

void ProgressLines::crack(const std::string& stage, const CrackEvent& event) {
  if (++events_ > 1) return;  // the log has them all, the summary counts them
  const std::string when =
      event.seconds > 0 ? "after " + time_text(event.seconds) : text("at load factor %.4f", event.load_factor);
  print(text("stage %s: first crack %s, %s, in %s, at %s", stage.c_str(), when.c_str(), event.interface.c_str(),
             event.mode.c_str(), place_in_metres(event.place).c_str()));
}

void ProgressLines::stage_ends(const StageResult& result) {
  if (result.kind == "dynamic")
    return print(text("stage %s: %s after %s, energy drift %.1e, %s", result.name.c_str(), result.stop_reason.c_str(),
                      counted(result.steps, "step").c_str(), result.energy.drift,
                      duration_text(result.wall_seconds).c_str()));
  print(text("stage %s: %s after %s, ratio %.1e, %s", result.name.c_str(), result.stop_reason.c_str(),
             counted(result.steps, "step").c_str(), result.ratio, duration_text(result.wall_seconds).c_str()));
}

bool ProgressLines::interrupted() {
  if (!interrupt_requested()) return false;
  if (!interrupt_told_) print("interrupted: finishing the step and writing the results so far (again: stop at once)");
  interrupt_told_ = true;
  return true;
}

void ProgressLines::print(const std::string& line) {
  clear_live_line();
  std::fprintf(out_, "%s\n", line.c_str());
  std::fflush(out_);
}

void ProgressLines::clear_live_line() {
  if (live_line_shown_) std::fprintf(out_, "\r\033[K");
  live_line_shown_ = false;
}

}  // namespace ashlar
