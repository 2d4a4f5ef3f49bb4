#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

/// A value with its derivatives with respect to N variables (forward-mode differentiation).
template <std::size_t N>
struct DualNumber {
  double value = 0.0;
  std::array<double, N> derivatives = {};

  DualNumber() = default;
  DualNumber(double constant) : value(constant) {}  // NOLINT: numbers are constants
  static DualNumber variable(double at, std::size_t index) {
    DualNumber number(at);
    number.derivatives[index] = 1.0;
    return number;
  }
  /// f(x), given its value and derivative.
  DualNumber applyChainRule(double f, double derivative) const {
    DualNumber result(f);
    for (std::size_t i = 0; i < N; ++i) {
      result.derivatives[i] = derivative * derivatives[i];
    }
    return result;
  }
  DualNumber operator-() const { return applyChainRule(-value, -1.0); }
  friend DualNumber operator+(DualNumber a, const DualNumber& b) {
    a.value += b.value;
    for (std::size_t i = 0; i < N; ++i) {
      a.derivatives[i] += b.derivatives[i];
    }
    return a;
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) { return a + (-b); }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    DualNumber result(a.value * b.value);
    for (std::size_t i = 0; i < N; ++i) {
      result.derivatives[i] = a.derivatives[i] * b.value + a.value * b.derivatives[i];
    }
    return result;
  }
  friend DualNumber operator/(const DualNumber& a, const DualNumber& b) {
    return a * b.applyChainRule(1.0 / b.value, -1.0 / (b.value * b.value));
  }
};

template <std::size_t N>
DualNumber<N> sqrt(const DualNumber<N>& x) {
  const double root = std::sqrt(x.value);
  return x.applyChainRule(root, root > 0.0 ? 0.5 / root : 0.0);
}

/// Residuals of the constrained smoother and their derivatives. Private to this folder.

/// Derivatives with respect to x and y of the previous pose, the pose and the next pose.
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

/// The data of an inner pose apart from its position.
struct SmoothTerm {
  Vec2 given = Vec2::Zero();  // position in the given path [m]
  double ratio = 1.0;         // length before / after the pose; negative: a cusp
  bool isReversing = false;   // the robot arrives in reverse
  double costWeight = 0.0;
};

constexpr std::size_t kSmoothResiduals = 4;
using SmoothResiduals = std::array<SmoothNumber, kSmoothResiduals>;

/// Residuals of smoothness, curvature, distance and cost of a pose between two others.
SmoothResiduals smoothResiduals(const SmoothTerm& term,
                                const ConstrainedSmootherParameters& parameters,
                                const Costmap& costmap, const Vec2& before, const Vec2& at,
                                const Vec2& after);

/// The direction, of either sign, of the arc through three points at the second one; at a cusp the
/// third point is mirrored first.
Vec2 arcDirection(const Vec2& before, const Vec2& at, const Vec2& after, bool isCusp);

}  // namespace sim2d::nav2
