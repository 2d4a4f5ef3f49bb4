#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/nav/nav2/global/ConstrainedResiduals.h"

namespace sim2d::nav2 {
namespace {

constexpr double kInitialRadius = 1e4, kMaxRadius = 1e16, kMinRadius = 1e-32;
constexpr double kMinDiagonal = 1e-6, kMaxDiagonal = 1e32;
constexpr double kMinDecrease = 1e-3;  // of a step, relative to the model's prediction
constexpr int kMaxInvalidSteps = 5;    // consecutive

using ResidualGroups = std::vector<LeastSquares::Group>;

double halfSquaredNorm(const ResidualGroups& groups) {
  double sum = 0.0;
  for (const LeastSquares::Group& group : groups) {
    for (const double value : group.values) {
      sum += value * value;
    }
  }
  return 0.5 * sum;
}

/// A symmetric band matrix; stores the lower half by rows.
class BandMatrix {
 public:
  BandMatrix(std::size_t size, std::size_t bandwidth)
      : size_(size), width_(bandwidth), cells_(size * bandwidth, 0.0) {}

  double& at(std::size_t row, std::size_t column) {  // column <= row < column + bandwidth
    return cells_[row * width_ + (row - column)];
  }
  std::size_t size() const { return size_; }

  /// Solves for a right-hand side by Cholesky factorization; false if it is not positive definite.
  bool solve(std::vector<double>& side) {
    if (!factorize()) {
      return false;
    }
    for (std::size_t row = 0; row < size_; ++row) {
      for (std::size_t k = firstOf(row); k < row; ++k) {
        side[row] -= at(row, k) * side[k];
      }
      side[row] /= at(row, row);
    }
    for (std::size_t row = size_; row-- > 0;) {
      for (std::size_t k = row + 1; k < std::min(size_, row + width_); ++k) {
        side[row] -= at(k, row) * side[k];
      }
      side[row] /= at(row, row);
    }
    return true;
  }

 private:
  bool factorize() {
    for (std::size_t row = 0; row < size_; ++row) {
      for (std::size_t column = firstOf(row); column <= row; ++column) {
        double sum = at(row, column);
        for (std::size_t k = std::max(firstOf(row), firstOf(column)); k < column; ++k) {
          sum -= at(row, k) * at(column, k);
        }
        if (row == column && !(sum > 0.0 && std::isfinite(sum))) {
          return false;
        }
        at(row, column) = row == column ? std::sqrt(sum) : sum / at(column, column);
      }
    }
    return true;
  }
  std::size_t firstOf(std::size_t row) const { return row + 1 > width_ ? row + 1 - width_ : 0; }

  std::size_t size_, width_;
  std::vector<double> cells_;
};

/// One run of the algorithm.
class LevenbergMarquardt {
 public:
  LevenbergMarquardt(const LeastSquares& problem, const LeastSquaresLimits& limits,
                     std::vector<double>& point)
      : problem_(problem), limits_(limits), point_(point) {}

  LeastSquaresResult run() {
    groups_ = problem_.groups(point_);
    end_.firstCost = end_.lastCost = halfSquaredNorm(groups_);
    linearize();
    scale_ = columnNorms_;
    for (double& each : scale_) {
      each = 1.0 / (1.0 + std::sqrt(each));
    }
    int invalid = 0;
    bool isDone = !std::isfinite(end_.firstCost) || isFlat();
    while (!isDone && end_.iterations < limits_.maxIterations && radius_ > kMinRadius) {
      ++end_.iterations;
      if (findStep()) {
        invalid = 0;
        isDone = takeStep();
      } else {
        reject();
        isDone = ++invalid >= kMaxInvalidSteps;
      }
    }
    return end_;
  }

 private:
  /// Computes the gradient and the squared norms of the Jacobian's columns.
  void linearize() {
    gradient_.assign(point_.size(), 0.0);
    columnNorms_.assign(point_.size(), 0.0);
    for (const LeastSquares::Group& group : groups_) {
      const std::size_t count = group.variables.size();
      for (std::size_t r = 0; r < group.values.size(); ++r) {
        for (std::size_t v = 0; v < count; ++v) {
          const double derivative = group.derivatives[r * count + v];
          gradient_[group.variables[v]] += derivative * group.values[r];
          columnNorms_[group.variables[v]] += derivative * derivative;
        }
      }
    }
  }

  bool isFlat() {
    const bool isFlat = std::all_of(gradient_.begin(), gradient_.end(), [this](double each) {
      return std::abs(each) <= limits_.gradientTolerance;
    });
    end_.isConverged = end_.isConverged || isFlat;
    return isFlat;
  }

  /// Computes the damped step and the predicted decrease of the cost.
  bool findStep() {
    BandMatrix normal(point_.size(), problem_.bandwidth());
    for (const LeastSquares::Group& group : groups_) {
      addNormal(group, normal);
    }
    if (!reusesDiagonal_) {
      diagonal_ = columnNorms_;
      for (std::size_t i = 0; i < diagonal_.size(); ++i) {
        diagonal_[i] = std::clamp(diagonal_[i] * scale_[i] * scale_[i], kMinDiagonal, kMaxDiagonal);
      }
    }
    step_.resize(point_.size());
    for (std::size_t i = 0; i < point_.size(); ++i) {
      normal.at(i, i) += diagonal_[i] / radius_;
      step_[i] = -gradient_[i] * scale_[i];
    }
    if (!normal.solve(step_)) {
      return false;
    }
    for (std::size_t i = 0; i < step_.size(); ++i) {
      step_[i] *= scale_[i];
    }
    modelChange_ = 0.0;
    for (const LeastSquares::Group& group : groups_) {
      const std::size_t count = group.variables.size();
      for (std::size_t r = 0; r < group.values.size(); ++r) {
        double change = 0.0;
        for (std::size_t v = 0; v < count; ++v) {
          change += group.derivatives[r * count + v] * step_[group.variables[v]];
        }
        modelChange_ -= change * (group.values[r] + 0.5 * change);
      }
    }
    return modelChange_ > 0.0 && std::isfinite(modelChange_);
  }

  void addNormal(const LeastSquares::Group& group, BandMatrix& normal) const {
    const std::size_t count = group.variables.size();
    for (std::size_t r = 0; r < group.values.size(); ++r) {
      for (std::size_t v = 0; v < count; ++v) {
        const std::size_t row = group.variables[v];
        for (std::size_t w = 0; w < count; ++w) {
          const std::size_t column = group.variables[w];
          if (column <= row) {
            normal.at(row, column) += group.derivatives[r * count + v] * scale_[row] *
                                      group.derivatives[r * count + w] * scale_[column];
          }
        }
      }
    }
  }

  /// Applies the step; returns whether the search has ended.
  bool takeStep() {
    std::vector<double> candidate = point_;
    double stepSquare = 0.0, pointSquare = 0.0;
    for (std::size_t i = 0; i < point_.size(); ++i) {
      candidate[i] += step_[i];
      stepSquare += step_[i] * step_[i];
      pointSquare += point_[i] * point_[i];
    }
    ResidualGroups groups = problem_.groups(candidate);
    const double cost = halfSquaredNorm(groups), change = end_.lastCost - cost;
    const double tolerance = limits_.parameterTolerance;
    const bool isShort =
        hasMoved_ && std::sqrt(stepSquare) <= tolerance * (std::sqrt(pointSquare) + tolerance);
    if (isShort || std::abs(change) <= limits_.functionTolerance * end_.lastCost) {
      end_.isConverged = true;
      return true;
    }
    const double quality = change / modelChange_;
    if (!(quality > kMinDecrease)) {
      reject();
      return false;
    }
    point_ = std::move(candidate);
    groups_ = std::move(groups);
    end_.lastCost = cost;
    hasMoved_ = true;
    linearize();
    const double curve = 2.0 * quality - 1.0;
    radius_ = std::min(radius_ / std::max(1.0 / 3.0, 1.0 - curve * curve * curve), kMaxRadius);
    decreaseFactor_ = 2.0;
    reusesDiagonal_ = false;
    return isFlat();
  }

  void reject() {
    radius_ /= decreaseFactor_;
    decreaseFactor_ *= 2.0;
    reusesDiagonal_ = true;
  }

  const LeastSquares& problem_;
  LeastSquaresLimits limits_;
  std::vector<double>& point_;
  LeastSquaresResult end_;
  ResidualGroups groups_;  // at the current point
  std::vector<double> gradient_, columnNorms_, scale_, diagonal_, step_;
  double radius_ = kInitialRadius, decreaseFactor_ = 2.0, modelChange_ = 0.0;
  bool reusesDiagonal_ = false, hasMoved_ = false;
};

}  // namespace

LeastSquaresResult minimizeLeastSquares(const LeastSquares& problem,
                                        const LeastSquaresLimits& limits,
                                        std::vector<double>& point) {
  return LevenbergMarquardt(problem, limits, point).run();
}

}  // namespace sim2d::nav2
