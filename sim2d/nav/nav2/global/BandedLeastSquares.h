#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

/// Nonlinear least squares whose residuals depend on neighbouring variables. Private to this
/// folder.
namespace sim2d::nav2 {

/// Residuals in groups, each of which depends on a few variables.
class LeastSquares {
 public:
  /// Values of one group and their derivatives, row by row.
  struct Group {
    std::vector<std::size_t> variables;  // by their numbers
    std::vector<double> values;
    std::vector<double> slopes;  // values x variables
  };
  virtual ~LeastSquares() = default;
  /// Every group at a point; numbers of variables within a group differ by less than `bandwidth`.
  virtual std::vector<Group> groups(const std::vector<double>& point) const = 0;
  virtual std::size_t bandwidth() const = 0;
};

struct LeastSquaresLimits {
  int mostIterations = 100;
  double functionTolerance = 1e-7;    // relative change of the cost
  double gradientTolerance = 1e-10;   // greatest component
  double parameterTolerance = 1e-15;  // relative length of a step
};

struct LeastSquaresEnd {
  double firstCost = 0.0, lastCost = 0.0;  // half the sum of squares
  int iterations = 0;
  bool isConverged = false;
};

/// Minimises by Levenberg and Marquardt with the rules of Ceres Solver 2.1 (trust_region_minimizer,
/// levenberg_marquardt_strategy): columns scaled once, diagonal between 1e-6 and 1e32, radius from
/// 1e4. `point` becomes the best one that was found.
LeastSquaresEnd minimise(const LeastSquares& problem, const LeastSquaresLimits& limits,
                         std::vector<double>& point);

}  // namespace sim2d::nav2
