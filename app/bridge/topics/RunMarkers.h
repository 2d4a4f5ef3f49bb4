#pragma once

#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/trace/Trace.h"

/// Visualization markers of a run for RViz and Foxglove. Pure functions; thread-safe.
namespace bridge {

/// Markers of all people and robots: a body, a velocity arrow, a name; robots also have their
/// footprint. The first marker deletes the previous ones, so each message is complete. Reuses the
/// memory of `to`, which is a previous message or empty.
void setBodyMarkers(const sim2d::TraceHeader& header, const sim2d::Frame& frame,
                    visualization_msgs::MarkerArray& to);
/// Outlines of the obstacles other than the map's walls, with doors as in the frame. `seconds`:
/// time stamp.
visualization_msgs::MarkerArray obstacleMarkersOf(const sim2d::TraceHeader& header,
                                                  const sim2d::Frame& frame, double seconds);

}  // namespace bridge
