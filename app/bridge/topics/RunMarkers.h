#pragma once

#include "app/bridge/messages/MarkerMessages.h"
#include "sim2d/trace/Trace.h"

/// A run as RViz and Foxglove draw it. Pure functions; any thread.
namespace bridge {

/// Everybody: a body, an arrow along the velocity, a name; robots with their footprints. The first
/// marker takes away those of before, so one message is all there is to see.
visualization_msgs::MarkerArray bodyMarkersOf(const sim2d::TraceHeader& header,
                                              const sim2d::Frame& frame);
/// Outlines of what stands beside the map's walls; doors as they are in the frame. `seconds`: its
/// stamp.
visualization_msgs::MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header,
                                                  const sim2d::Frame& frame, double seconds);

}  // namespace bridge
