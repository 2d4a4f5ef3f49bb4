#pragma once

#include "sim2d/trace/Frame.h"

namespace sim2d {

/// Text of the event `arrived` of a robot that reached a place to which it was sent from outside
/// instead of a goal of the scenario.
constexpr char kAtOrder[] = "order";

/// The robot has reached the last of its own goals.
inline bool isRobotsArrival(const Event& event, int robotId) {
  return event.kind == EventKind::Arrived && event.hasId && event.id == robotId &&
         event.text != kAtOrder;
}

}  // namespace sim2d
