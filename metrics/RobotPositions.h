#pragma once

#include "metrics/Report.h"

/// Positions on the robot's path, from the same samples as its metrics. If the record has no robot
/// with the selected id, its first robot is used.
namespace metrics {

/// The part of the robot's path that its metrics use, with times from its start; empty: none.
TimedPath robotPathOf(const sim2d::Trace& trace, const Selection& selection,
                      const MetricParameters& parameters);

/// The start of a contact of the robot.
struct RobotContact {
  double time = 0.0;            // in the record [s]
  Vec2 place = Vec2::Zero();    // position of the robot
  std::optional<int> person{};  // null: an obstacle
};

/// The contacts that `success` counts, in order: with people whose gap falls below
/// contact_distance, and with obstacles.
std::vector<RobotContact> robotContacts(const sim2d::Trace& trace, const Selection& selection,
                                        const MetricParameters& parameters);

}  // namespace metrics
