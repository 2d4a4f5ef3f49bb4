#include "sim2d/world/StepTimes.h"

#include <numeric>

namespace sim2d {

const char* stepPhaseName(StepPhase phase) {
  static constexpr std::array<const char*, kStepPhaseCount> kNames = {
      "trees", "robots", "ways", "forces", "bodies", "contacts", "goals", "grid", "frame"};
  return kNames[static_cast<std::size_t>(phase)];
}

double StepTimes::sum() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

}  // namespace sim2d
