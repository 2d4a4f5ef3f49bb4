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
