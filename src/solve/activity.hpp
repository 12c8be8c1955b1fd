#pragma once
#include <array>
#include <chrono>
#include <utility>

#include "backend/backend.hpp"

namespace ashlar {

/// What a stage spends its time on; the same on every machine, however it fuses the phases of its steps.
enum class Activity {
  set_up,       ///< conditions, masses, coarse space
  search,       ///< conjugate gradients
  steps,        ///< of relaxation or of time
  events,       ///< cracks and load increments: what decides between two balances
  output,       ///< fields and histories, with the stress that they need
  checkpoints,
  count
};
inline const char* activity_name(Activity activity) {
  constexpr std::array names{"set-up", "conjugate gradients", "steps", "crack events", "output", "checkpoints"};
  static_assert(names.size() == static_cast<std::size_t>(Activity::count));
  return names[static_cast<std::size_t>(activity)];
}

/// Wall time of each activity. The machine is waited for wherever one ends.
class ActivityClock {
 public:
  explicit ActivityClock(Backend& backend) : backend_(backend) {}

  /// From now on; returns what went on before.
  Activity enter(Activity activity) {
    backend_.finish();
    const auto now = Clock::now();
    seconds_[static_cast<std::size_t>(now_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    return std::exchange(now_, activity);
  }
  using Seconds = std::array<double, static_cast<std::size_t>(Activity::count)>;
  const Seconds& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  Backend& backend_;
  Activity now_ = Activity::set_up;
  Clock::time_point since_ = Clock::now();
  Seconds seconds_{};
};

/// An activity for as long as it lives; then the one before goes on.
class During {
 public:
  During(ActivityClock& clock, Activity activity) : clock_(clock), before_(clock.enter(activity)) {}
  During(const During&) = delete;
  ~During() { clock_.enter(before_); }

 private:
  ActivityClock& clock_;
  Activity before_;
};

}  // namespace ashlar
