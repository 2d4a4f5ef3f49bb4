#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace sim2d::nav2 {

/// A value with its derivatives with respect to N variables (forward-mode differentiation).
template <std::size_t N>
struct DualNumber {
  using Derivatives = Eigen::Matrix<double, static_cast<int>(N), 1>;
  double value = 0.0;
  Derivatives derivatives = Derivatives::Zero();

  DualNumber() = default;
  DualNumber(double constant) : value(constant) {}  // NOLINT: numbers are constants
  DualNumber(double at, const Derivatives& given) : value(at), derivatives(given) {}
  static DualNumber variable(double at, std::size_t index) {
    return {at, Derivatives::Unit(static_cast<int>(index))};
  }
  /// f(x), given its value and derivative.
  DualNumber applyChainRule(double f, double derivative) const {
    return {f, derivative * derivatives};
  }
  DualNumber operator-() const { return applyChainRule(-value, -1.0); }
  friend DualNumber operator+(const DualNumber& a, const DualNumber& b) {
    return {a.value + b.value, a.derivatives + b.derivatives};
  }
  friend DualNumber operator-(const DualNumber& a, const DualNumber& b) { return a + (-b); }
  friend DualNumber operator*(const DualNumber& a, const DualNumber& b) {
    return {a.value * b.value, a.derivatives * b.value + a.value * b.derivatives};
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

/// Nonlinear least squares whose residuals depend on neighbouring variables.

/// Residuals in groups, each of which depends on a few variables.
class LeastSquares {
 public:
  /// Residuals of one group and their Jacobian, row-major.
  struct Group {
    std::vector<std::size_t> variables;  // indices
    std::vector<double> values;
    std::vector<double> derivatives;  // Jacobian, values x variables
  };
  virtual ~LeastSquares() = default;
  /// All groups at a point; the indices of variables in a group differ by less than `bandwidth`.
  virtual std::vector<Group> groups(const std::vector<double>& point) const = 0;
  virtual std::size_t bandwidth() const = 0;
};

struct LeastSquaresLimits {
  int maxIterations = 100;
  double functionTolerance = 1e-7;    // relative change of the cost
  double gradientTolerance = 1e-10;   // maximum component
  double parameterTolerance = 1e-15;  // relative step length
};

struct LeastSquaresResult {
  double firstCost = 0.0, lastCost = 0.0;  // half the sum of squares
  int iterations = 0;
  bool isConverged = false;
};

/// Minimizes by Levenberg-Marquardt with the rules of Ceres Solver 2.1 (trust_region_minimizer,
/// levenberg_marquardt_strategy): columns scaled once, diagonal between 1e-6 and 1e32, initial
/// radius 1e4. `point` is replaced by the best point found.
LeastSquaresResult minimizeLeastSquares(const LeastSquares& problem,
                                        const LeastSquaresLimits& limits,
                                        std::vector<double>& point);

}  // namespace sim2d::nav2
