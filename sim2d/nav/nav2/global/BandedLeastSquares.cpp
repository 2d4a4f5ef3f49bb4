#include "sim2d/nav/nav2/global/BandedLeastSquares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d::nav2 {
namespace {

constexpr double kFirstRadius = 1e4, kGreatestRadius = 1e16, kLeastRadius = 1e-32;
constexpr double kLeastDiagonal = 1e-6, kGreatestDiagonal = 1e32;
constexpr double kLeastDecrease = 1e-3;  // of a step, relative to what the model expects
constexpr int kMostInvalidSteps = 5;     // in a row

using ResidualGroups = std::vector<LeastSquares::Group>;

double halfSquares(const ResidualGroups& groups) {
  double sum = 0.0;
  for (const LeastSquares::Group& group : groups) {
    for (const double value : group.values) {
      sum += value * value;
    }
  }
  return 0.5 * sum;
}

/// A symmetric matrix of which only entries near the diagonal are not 0: the lower half by rows.
class BandMatrix {
 public:
  BandMatrix(std::size_t size, std::size_t bandwidth)
      : size_(size), width_(bandwidth), cells_(size * bandwidth, 0.0) {}

  double& at(std::size_t row, std::size_t column) {  // column <= row < column + bandwidth
    return cells_[row * width_ + (row - column)];
  }
  std::size_t size() const { return size_; }

  /// Solves for a right side by Cholesky's method; false: it is not positive definite.
  bool solve(std::vector<double>& side) {
    if (!factorise()) {
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
  bool factorise() {
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
class Minimiser {
 public:
  Minimiser(const LeastSquares& problem, const LeastSquaresLimits& limits,
            std::vector<double>& point)
      : problem_(problem), limits_(limits), point_(point) {}

  LeastSquaresEnd run() {
    groups_ = problem_.groups(point_);
    end_.firstCost = end_.lastCost = halfSquares(groups_);
    linearise();
    scale_ = columnNorms_;
    for (double& each : scale_) {
      each = 1.0 / (1.0 + std::sqrt(each));
    }
    int invalid = 0;
    bool isDone = !std::isfinite(end_.firstCost) || isFlat();
    while (!isDone && end_.iterations < limits_.mostIterations && radius_ > kLeastRadius) {
      ++end_.iterations;
      if (findStep()) {
        invalid = 0;
        isDone = takeStep();
      } else {
        reject();
        isDone = ++invalid >= kMostInvalidSteps;
      }
    }
    return end_;
  }

 private:
  /// Gradient and squared lengths of the Jacobian's columns.
  void linearise() {
    gradient_.assign(point_.size(), 0.0);
    columnNorms_.assign(point_.size(), 0.0);
    for (const LeastSquares::Group& group : groups_) {
      const std::size_t count = group.variables.size();
      for (std::size_t r = 0; r < group.values.size(); ++r) {
        for (std::size_t v = 0; v < count; ++v) {
          const double slope = group.slopes[r * count + v];
          gradient_[group.variables[v]] += slope * group.values[r];
          columnNorms_[group.variables[v]] += slope * slope;
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

  /// The step of the damped model, and by how much it lowers the model's cost.
  bool findStep() {
    BandMatrix normal(point_.size(), problem_.bandwidth());
    for (const LeastSquares::Group& group : groups_) {
      addNormal(group, normal);
    }
    if (!keepsDiagonal_) {
      diagonal_ = columnNorms_;
      for (std::size_t i = 0; i < diagonal_.size(); ++i) {
        diagonal_[i] =
            std::clamp(diagonal_[i] * scale_[i] * scale_[i], kLeastDiagonal, kGreatestDiagonal);
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
          change += group.slopes[r * count + v] * step_[group.variables[v]];
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
            normal.at(row, column) += group.slopes[r * count + v] * scale_[row] *
                                      group.slopes[r * count + w] * scale_[column];
          }
        }
      }
    }
  }

  /// Whether the search has come to its end.
  bool takeStep() {
    std::vector<double> candidate = point_;
    double stepSquare = 0.0, pointSquare = 0.0;
    for (std::size_t i = 0; i < point_.size(); ++i) {
      candidate[i] += step_[i];
      stepSquare += step_[i] * step_[i];
      pointSquare += point_[i] * point_[i];
    }
    ResidualGroups groups = problem_.groups(candidate);
    const double cost = halfSquares(groups), change = end_.lastCost - cost;
    const double tolerance = limits_.parameterTolerance;
    const bool isShort =
        hasMoved_ && std::sqrt(stepSquare) <= tolerance * (std::sqrt(pointSquare) + tolerance);
    if (isShort || std::abs(change) <= limits_.functionTolerance * end_.lastCost) {
      end_.isConverged = true;
      return true;
    }
    const double quality = change / modelChange_;
    if (!(quality > kLeastDecrease)) {
      reject();
      return false;
    }
    point_ = std::move(candidate);
    groups_ = std::move(groups);
    end_.lastCost = cost;
    hasMoved_ = true;
    linearise();
    const double curve = 2.0 * quality - 1.0;
    radius_ = std::min(radius_ / std::max(1.0 / 3.0, 1.0 - curve * curve * curve), kGreatestRadius);
    shrinking_ = 2.0;
    keepsDiagonal_ = false;
    return isFlat();
  }

  void reject() {
    radius_ /= shrinking_;
    shrinking_ *= 2.0;
    keepsDiagonal_ = true;
  }

  const LeastSquares& problem_;
  LeastSquaresLimits limits_;
  std::vector<double>& point_;
  LeastSquaresEnd end_;
  ResidualGroups groups_;  // at the point
  std::vector<double> gradient_, columnNorms_, scale_, diagonal_, step_;
  double radius_ = kFirstRadius, shrinking_ = 2.0, modelChange_ = 0.0;
  bool keepsDiagonal_ = false, hasMoved_ = false;
};

}  // namespace

LeastSquaresEnd minimise(const LeastSquares& problem, const LeastSquaresLimits& limits,
                         std::vector<double>& point) {
  return Minimiser(problem, limits, point).run();
}

}  // namespace sim2d::nav2
