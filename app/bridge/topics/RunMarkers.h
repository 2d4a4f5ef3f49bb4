#pragma once

#include "app/bridge/messages/MarkerMessages.h"
#include "sim2d/trace/Trace.h"

/// A run as RViz and Foxglove draw it. Pure functions; any thread.
namespace bridge {

/// Everybody: a body, an arrow along the velocity, a name; robots with their footprints. The first
/// marker takes away those of before, so one message is all there is to see. Into the message of a
/// state before, whose memory is used again, or into an empty one.
void setBodyMarkers(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                    visualization_msgs::MarkerArray& to);
/// Outlines of what stands beside the map's walls; doors as they are in the frame. `seconds`: its
/// stamp.
visualization_msgs::MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header,
                                                  const sim2d::Frame& frame, double seconds);

}  // namespace bridge
