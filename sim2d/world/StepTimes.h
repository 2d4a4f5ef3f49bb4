#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <numeric>

namespace sim2d {

/// Parts of a step, in the order of their beginning.
enum class StepPhase : std::uint8_t {
  Trees,     // people decide
  Robots,    // observation and planner
  Ways,      // where people head
  Forces,    // of people and walls on people, wanted velocities
  Bodies,    // kept apart, Box2D
  Contacts,  // events of touching
  Goals,     // reached goals, who comes and goes, doors
  Grid,      // who is near
  Frame,     // the picture of the step
};
constexpr std::size_t kStepPhaseCount = 9;
inline const char* stepPhaseName(StepPhase phase) {
  constexpr std::array<const char*, kStepPhaseCount> kNames = {
      "trees", "robots", "ways", "forces", "bodies", "contacts", "goals", "grid", "frame"};
  return kNames[static_cast<std::size_t>(phase)];
}

enum class StepClock : std::uint8_t {
  Wall,
  Thread  // only while the calling thread runs: what else the machine does counts less
};
/// Seconds since some moment that stays the same.
inline double secondsBy(StepClock clock) {
  if (clock == StepClock::Thread) {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Time of each phase, summed over the steps [s].
struct StepTimes {
  StepClock clock = StepClock::Wall;
  std::array<double, kStepPhaseCount> seconds = {};
  std::int64_t steps = 0;
  double sum() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
};

/// Splits the time of a step into phases. Without a place for the times it does nothing.
class StepWatch {
 public:
  explicit StepWatch(StepTimes* times) : times_(times) {
    if (times_ != nullptr) {
      last_ = secondsBy(times_->clock);
    }
  }
  /// Adds the time since the last call, or the making, to `phase`.
  void lap(StepPhase phase) {
    if (times_ != nullptr) {
      const double now = secondsBy(times_->clock);
      times_->seconds[static_cast<std::size_t>(phase)] += now - last_;
      last_ = now;
    }
  }

 private:
  StepTimes* times_;
  double last_ = 0.0;
};

}  // namespace sim2d
