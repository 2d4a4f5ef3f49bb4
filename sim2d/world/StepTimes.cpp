#include "sim2d/world/StepTimes.h"

#include <chrono>
#include <ctime>
#include <numeric>

namespace sim2d {

const char* stepPhaseName(StepPhase phase) {
  static constexpr std::array<const char*, kStepPhaseCount> kNames = {
      "trees", "robots", "ways", "forces", "bodies", "contacts", "goals", "grid", "frame"};
  return kNames[static_cast<std::size_t>(phase)];
}

double secondsBy(StepClock clock) {
  if (clock == StepClock::Thread) {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double StepTimes::sum() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

}  // namespace sim2d
