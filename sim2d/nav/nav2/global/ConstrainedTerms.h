#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/DualNumber.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"

/// The residuals of the constrained smoother and their derivatives. Private to this folder.
namespace sim2d::nav2 {

/// By x and y of the pose before, the pose itself and the one after it.
using SmoothNumber = DualNumber<6>;
struct SmoothPoint {
  SmoothNumber x, y;

  friend SmoothPoint operator+(const SmoothPoint& a, const SmoothPoint& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend SmoothPoint operator-(const SmoothPoint& a, const SmoothPoint& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend SmoothPoint operator*(const SmoothNumber& factor, const SmoothPoint& a) {
    return {factor * a.x, factor * a.y};
  }
};

/// What is known of an inner pose beside its place.
struct SmoothTerm {
  Vec2 given = Vec2::Zero();  // where the path had it [m]
  double ratio = 1.0;         // of the stretch before it and that after it; below 0: a cusp
  bool isReversing = false;   // the robot comes backward
  double costWeight = 0.0;
};

constexpr std::size_t kSmoothResiduals = 4;
using SmoothResiduals = std::array<SmoothNumber, kSmoothResiduals>;

/// Smoothness, curvature, distance and cost of a pose between two others.
SmoothResiduals smoothResiduals(const SmoothTerm& term,
                                const ConstrainedSmootherParameters& parameters,
                                const Costmap& costmap, const Vec2& before, const Vec2& at,
                                const Vec2& after);

/// The direction of the arc through three points at the second one, of either sign; with a cusp
/// there the third is mirrored first.
Vec2 arcDirection(const Vec2& before, const Vec2& at, const Vec2& after, bool isCusp);

}  // namespace sim2d::nav2
