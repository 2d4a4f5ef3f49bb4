#pragma once

#include "metrics/Report.h"
#include "sim2d/trace/RecordedPoints.h"

namespace metrics {

/// The same as evaluate (Report.h) of a record whose source gives obstacle points: for people where
/// it gives some to any person, for the robot where it gives some to the robot, they take the place
/// of those worked out from the outlines. The clearance of the robot is that of the nearer one of
/// outlines and points.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                  const Selection& selection, const MetricParameters& parameters);

}  // namespace metrics
