#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/mppi/MppiCritics.h"

namespace sim2d::nav2 {

/// One critic asked about one batch.
struct MppiCritics::Round {
  const MppiScene& scene;
  const TrajectoryColumns& columns;
  TrajectoryBatch batch;
  std::vector<float>& costs;
  std::size_t critic;  // index
};

}  // namespace sim2d::nav2
