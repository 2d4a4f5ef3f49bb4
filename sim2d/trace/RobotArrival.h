#pragma once

#include "sim2d/trace/Frame.h"

namespace sim2d {

/// Text of the event `arrived` when a robot reaches a position given by the input `goal` instead of
/// a goal of the scenario.
constexpr char kOrderText[] = "order";

/// Whether the robot has reached the last of its own goals.
inline bool isRobotArrival(const Event& event, int robotId) {
  return event.kind == EventKind::Arrived && event.hasId && event.id == robotId &&
         event.text != kOrderText;
}

}  // namespace sim2d
