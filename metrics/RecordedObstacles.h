#pragma once

#include "metrics/Report.h"
#include "sim2d/trace/RecordedPoints.h"

namespace metrics {

/// Like evaluate (Report.h), for a record whose source contains obstacle points. If any person has
/// points, the recorded points of people replace those computed from the outlines; likewise for the
/// robot. The clearance of the robot is the smaller of those to outlines and to points.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                  const Selection& selection, const MetricParameters& parameters);

}  // namespace metrics
