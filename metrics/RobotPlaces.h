#pragma once

#include "metrics/Report.h"

/// Places on the robot's way, taken from the same samples as its metrics. If the record has no
/// robot of the selection's id: of its first.
namespace metrics {

/// The part of the robot's way that its metrics look at, times from its begin; empty: none is.
TimedWay wayOf(const sim2d::Trace& trace, const Selection& selection,
               const MetricParameters& parameters);

/// A contact of the robot that began.
struct RobotContact {
  double time = 0.0;            // of the record [s]
  Vec2 place = Vec2::Zero();    // where the robot was then
  std::optional<int> person{};  // with whom; null: with an obstacle
};

/// Those that `success` counts, in order: with people, whose gap falls below contact_distance, and
/// with obstacles.
std::vector<RobotContact> contactsOf(const sim2d::Trace& trace, const Selection& selection,
                                     const MetricParameters& parameters);

}  // namespace metrics
