#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

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
const char* stepPhaseName(StepPhase phase);

/// Wall time of each phase, summed over the steps [s].
struct StepTimes {
  std::array<double, kStepPhaseCount> seconds = {};
  std::int64_t steps = 0;
  double sum() const;
};

/// Splits the time of a step into phases. Without a place for the times it does nothing.
class StepWatch {
 public:
  explicit StepWatch(StepTimes* times) : times_(times) {
    if (times_ != nullptr) {
      last_ = Clock::now();
    }
  }
  /// Adds the time since the last call, or the making, to `phase`.
  void lap(StepPhase phase) {
    if (times_ != nullptr) {
      const Clock::time_point now = Clock::now();
      times_->seconds[static_cast<std::size_t>(phase)] +=
          std::chrono::duration<double>(now - last_).count();
      last_ = now;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  StepTimes* times_;
  Clock::time_point last_;
};

}  // namespace sim2d
