#pragma once

#include "metrics/statistics/Summary.h"

/// Options with several metrics: which are worth a look.
namespace statistics {

enum class Sense { Lower, Higher };  // what is better

/// Which points no other point beats: none is at least as good in both and better in one (Pareto).
/// Equal points stand together; a point with an undefined number never belongs to it.
std::vector<bool> paretoFront(const Numbers& x, Sense xSense, const Numbers& y, Sense ySense);

/// One number per option from several metrics, with weights that somebody has chosen:
/// Σ w s / Σ w in [0, 1], s being each metric's place between its worst (0) and best (1) value over
/// the options compared, so that it says nothing about other options; 1 when all are equal.
struct Criterion {
  Numbers values;  // one per option
  Sense sense = Sense::Lower;
  double weight = 1.0;  // >= 0
};
/// An option with an undefined value: NaN. No weight at all: NaN.
Numbers composite(const std::vector<Criterion>& criteria);

}  // namespace statistics
