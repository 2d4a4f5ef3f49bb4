#pragma once

#include <vector>

#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

/// What an eye sees of the ground: within `range` [m], `halfAngle` [rad] to each side of its
/// heading, up to the nearest wall. Corners in the world frame, counter-clockwise, beginning with
/// the eye unless it sees all around. Exact at walls but for rounding; the arc at the range has a
/// corner every 3 degrees.
std::vector<base::Vec2> sightPolygon(const base::Pose2& eye, double halfAngle, double range,
                                     const std::vector<sim2d::Segment>& walls);

/// Edges of walls, obstacles and closed doors of a run that come within the range of a place.
/// `doorOpen`: of the doors in their order, as in frames; those that it lacks are as at the start.
std::vector<sim2d::Segment> wallsAround(const sim2d::TraceHeader& header,
                                        const std::vector<char>& doorOpen, const base::Vec2& place,
                                        double range);

}  // namespace metrics
