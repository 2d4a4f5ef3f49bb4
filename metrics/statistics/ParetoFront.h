#pragma once

#include "metrics/statistics/Summary.h"

/// Comparison of options by several metrics.
namespace statistics {

enum class Sense { Lower, Higher };  // which direction is better

/// Pareto front: points that no other point dominates, that is, is at least as good in both values
/// and better in one. Equal points are treated equally; points with an undefined value are
/// excluded.
std::vector<bool> paretoFront(const Numbers& x, Sense xSense, const Numbers& y, Sense ySense);

/// Composite score of each option from several metrics with user-defined weights: Σ w s / Σ w in
/// [0, 1], where s is the position of each metric between its worst (0) and best (1) value over the
/// compared options, so it is relative to these options; 1 if all are equal.
struct Criterion {
  Numbers values;  // one per option
  Sense sense = Sense::Lower;
  double weight = 1.0;  // >= 0
};
/// NaN for an option with an undefined value, and for all options if the sum of weights is 0.
Numbers composite(const std::vector<Criterion>& criteria);

}  // namespace statistics
