#pragma once

#include "metrics/MetricRegistry.h"

namespace metrics {

/// Of one sample alone; NaN = undefined there.
using SampleTerm = std::function<double(const Sample& sample, const MetricParameters& parameters)>;
/// Makes the value of the terms of all samples.
using Reduction =
    std::function<MetricValue(const std::vector<double>& terms, const Recording& recording,
                              const MetricParameters& parameters)>;

/// Adds a metric whose costly part depends on each sample alone. Terms that are plain functions are
/// computed once for all metrics that are made of them.
void addSeriesMetric(MetricRegistry& to, MetricInfo info, SampleTerm term, Reduction reduce);

/// Mean weighted with the time after each sample, of the samples with a term; NaN: no time.
double timeMean(const std::vector<double>& terms, const Recording& recording);
/// Largest defined term; NaN: none.
double largestTerm(const std::vector<double>& terms);

double closestGapTerm(const Sample& sample, const MetricParameters& parameters);  // NaN: nobody
/// Soonest collision with anybody [s]; NaN: on no collision course.
double collisionTerm(const Sample& sample, const MetricParameters& parameters);

}  // namespace metrics
