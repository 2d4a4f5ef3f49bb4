#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/ConstrainedResiduals.h"

namespace sim2d::nav2 {
namespace {

constexpr double kMinSegment = 1e-4;      // minimum length of a segment [m]
constexpr double kPosesPerSecond = 1e6;   // moved by iterations
constexpr double kMaxFitDuration = 60.0;  // [s], upper limit of maxDuration
constexpr double kControlPoints = 0.4;    // distance of control points / segment length
constexpr std::size_t kFixed = std::numeric_limits<std::size_t>::max();  // index of fixed poses

/// A pose of the optimization: position and direction of the following movement.
struct ConstrainedPose {
  Vec2 position = Vec2::Zero();  // [m]
  double direction = 1.0;        // 1 forward, -1 backward
};

/// An inner pose with its neighbours, as indices of the path.
struct InnerPose {
  std::size_t before, at, after;
  SmoothTerm term;
};

/// The poses that are kept, and the terms of the inner ones.
class SmoothProblem final : public LeastSquares {
 public:
  SmoothProblem(const std::vector<ConstrainedPose>& path, const Costmap& costmap,
                const ConstrainedSmootherParameters& parameters)
      : path_(path), costmap_(costmap), parameters_(parameters), isKept_(path.size(), false) {
    selectKeptPoses();
    assignVariableIndices();
  }

  std::size_t variables() const { return count_; }
  const std::vector<bool>& kept() const { return isKept_; }

  std::vector<double> firstPoint() const {
    std::vector<double> point(count_);
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (variableIndices_[i] != kFixed) {
        point[variableIndices_[i]] = path_[i].position.x();
        point[variableIndices_[i] + 1] = path_[i].position.y();
      }
    }
    return point;
  }
  Vec2 placeOf(std::size_t i, const std::vector<double>& point) const {
    return variableIndices_[i] == kFixed
               ? path_[i].position
               : Vec2(point[variableIndices_[i]], point[variableIndices_[i] + 1]);
  }

  std::size_t bandwidth() const override { return 6; }
  std::vector<Group> groups(const std::vector<double>& point) const override {
    std::vector<Group> all;
    all.reserve(inner_.size());
    for (const InnerPose& pose : inner_) {
      all.push_back(groupOf(pose, point));
    }
    return all;
  }

 private:
  /// Poses at cusps are kept regardless of the downsampling factor.
  bool isSkipped(std::size_t i, std::size_t last, bool isCusp) const {
    const std::size_t first = parameters_.keepStartOrientation ? 1 : 0;
    const std::size_t end = parameters_.keepGoalOrientation ? 2 : 1;
    return !isCusp && i > first && i + end < path_.size() &&
           i - last < static_cast<std::size_t>(parameters_.pathDownsamplingFactor);
  }

  /// The cost weight at a distance from a cusp.
  double cuspWeight(double distance) const {
    const double half = parameters_.cuspZoneLength / 2.0;
    const double cusp = parameters_.wCost * parameters_.wCostCuspMultiplier;
    return cusp * (1.0 - distance / half) + parameters_.wCost * distance / half;
  }

  /// Raises the cost weights before the cusp that follows; `length`: distance to the cusp.
  void raiseWeightsBefore(double length) {
    const double cusp = parameters_.wCost * parameters_.wCostCuspMultiplier;
    for (std::size_t i = nearby_.size(); i-- > 0;) {
      SmoothTerm& term = inner_[nearby_[i].second].term;
      const double weight = cuspWeight(length);
      if (std::abs(weight - cusp) < std::abs(term.costWeight - cusp)) {
        term.costWeight = weight;
      }
      length += nearby_[i].first;
    }
    nearby_.clear();
    nearbyLength_ = 0.0;
  }

  void dropFarPoses() {
    while (!nearby_.empty() && nearbyLength_ > parameters_.cuspZoneLength / 2.0) {
      nearbyLength_ -= nearby_.front().first;
      nearby_.pop_front();
    }
  }

  void selectKeptPoses() {
    std::size_t before = kFixed, last = 0;
    double direction = path_[0].direction, lastLength = kMinSegment;
    double sinceCusp = std::numeric_limits<double>::infinity();
    bool wasCusp = false, wasReversing = false;
    isKept_[0] = true;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      bool isCusp = false;
      if (i + 1 != path_.size()) {
        isCusp = path_[i].direction * direction < 0.0;
        direction = path_[i].direction;
        if (isSkipped(i, last, isCusp)) {
          continue;
        }
      }
      const double length = (path_[i].position - path_[last].position).norm();
      nearbyLength_ += length;
      dropFarPoses();
      if (isCusp) {
        raiseWeightsBefore(length);
        sinceCusp = 0.0;
      }
      isKept_[i] = true;
      if (before != kFixed) {
        const bool isNear = sinceCusp <= parameters_.cuspZoneLength / 2.0;
        SmoothTerm term;
        term.given = path_[last].position;
        term.ratio = (wasCusp ? -1.0 : 1.0) * lastLength / std::max(length, kMinSegment);
        term.isReversing = wasReversing;
        term.costWeight = isNear ? cuspWeight(sinceCusp) : parameters_.wCost;
        nearby_.emplace_back(length, inner_.size());
        inner_.push_back({before, last, i, term});
      }
      wasCusp = isCusp;
      wasReversing = direction < 0.0;
      before = last;
      last = i;
      sinceCusp += lastLength;
      lastLength = std::max(kMinSegment, length);
    }
  }

  /// The ends are fixed, as are the poses beside them if their orientations must be kept.
  void assignVariableIndices() {
    variableIndices_.assign(path_.size(), kFixed);
    const std::size_t last = path_.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
      const bool isHeld = (i == 1 && parameters_.keepStartOrientation) ||
                          (i + 1 == last && parameters_.keepGoalOrientation);
      if (isKept_[i] && !isHeld) {
        variableIndices_[i] = count_;
        count_ += 2;
      }
    }
  }

  Group groupOf(const InnerPose& pose, const std::vector<double>& point) const {
    const std::array<std::size_t, 3> places = {pose.before, pose.at, pose.after};
    const SmoothResiduals residuals =
        smoothResiduals(pose.term, parameters_, costmap_, placeOf(pose.before, point),
                        placeOf(pose.at, point), placeOf(pose.after, point));
    Group group;
    std::vector<std::size_t> slots;  // columns of the Jacobian
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (variableIndices_[places[k]] != kFixed) {
        group.variables.insert(group.variables.end(),
                               {variableIndices_[places[k]], variableIndices_[places[k]] + 1});
        slots.insert(slots.end(), {2 * k, 2 * k + 1});
      }
    }
    for (const SmoothNumber& residual : residuals) {
      group.values.push_back(residual.value);
      for (const std::size_t slot : slots) {
        group.derivatives.push_back(residual.derivatives[static_cast<Eigen::Index>(slot)]);
      }
    }
    return group;
  }

  const std::vector<ConstrainedPose>& path_;
  const Costmap& costmap_;
  const ConstrainedSmootherParameters& parameters_;
  std::vector<bool> isKept_;
  std::vector<InnerPose> inner_;
  std::vector<std::size_t> variableIndices_;  // index of a pose's first variable
  std::size_t count_ = 0;
  std::deque<std::pair<double, std::size_t>> nearby_;  // lengths and inner poses before a cusp
  double nearbyLength_ = 0.0;
};

/// The poses with the direction of the movement after each.
std::vector<ConstrainedPose> posesOf(const Path& path, const ConstrainedSmootherParameters& p) {
  std::vector<ConstrainedPose> poses;
  poses.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    double direction = poses.empty() ? 1.0 : poses.back().direction;
    if (i + 1 < path.size()) {
      const Vec2 way = path[i + 1].position - path[i].position;
      const bool isReversing = p.reversingEnabled && path[i].direction().dot(way) < 0.0;
      direction = isReversing ? -1.0 : 1.0;
    }
    poses.push_back({path[i].position, direction});
  }
  if (poses.size() > 2 && !p.keepStartOrientation) {
    poses[0].direction = poses[1].direction;
  }
  return poses;
}

Vec2 bezier(const std::array<Vec2, 4>& points, double t) {
  const double s = 1.0 - t;
  return s * s * s * points[0] + 3.0 * s * s * t * points[1] + 3.0 * s * t * t * points[2] +
         t * t * t * points[3];
}

/// The vector or its opposite, whichever points in the direction of `way`.
Vec2 alignedWith(const Vec2& vector, const Vec2& way) {
  return vector.dot(way) >= 0.0 ? vector : Vec2(-vector);
}

/// Assembles the smoothed path with curves between the poses that were kept.
class PathAssembly {
 public:
  PathAssembly(const std::vector<ConstrainedPose>& poses, const std::vector<bool>& kept,
               const ConstrainedSmootherParameters& parameters)
      : poses_(poses), kept_(kept), parameters_(parameters) {}

  Path assemble(const Vec2& startDirection, const Vec2& endDirection) {
    std::size_t before = kFixed, last = 0;
    Vec2 beforeDirection = startDirection;
    for (std::size_t i = 1; i <= poses_.size(); ++i) {
      if (i < poses_.size() && !kept_[i]) {
        continue;
      }
      if (before == kFixed) {
        const Vec2 way = (poses_[i].position - poses_[0].position) * poses_[0].direction;
        beforeDirection =
            parameters_.keepStartOrientation ? startDirection : Vec2(way.normalized());
        path_.push_back({poses_[0].position, base::headingOf(beforeDirection)});
      } else {
        const Vec2 direction = directionAt(before, last, i, endDirection);
        addCurve(before, last, beforeDirection, direction);
        beforeDirection = direction;
      }
      before = last;
      last = i;
    }
    return std::move(path_);
  }

 private:
  Vec2 directionAt(std::size_t before, std::size_t last, std::size_t next,
                   const Vec2& endDirection) const {
    const ConstrainedPose& a = poses_[before];
    const ConstrainedPose& b = poses_[last];
    if (next < poses_.size()) {
      const Vec2 tangent = arcDirection(a.position, b.position, poses_[next].position,
                                        a.direction * b.direction < 0.0);
      return alignedWith(tangent, (poses_[next].position - b.position) * b.direction).normalized();
    }
    return parameters_.keepGoalOrientation
               ? endDirection
               : Vec2(((b.position - a.position) * b.direction).normalized());
  }

  void addCurve(std::size_t before, std::size_t last, const Vec2& from, const Vec2& to) {
    const ConstrainedPose& a = poses_[before];
    const ConstrainedPose& b = poses_[last];
    const auto count = static_cast<int>(last - before) * parameters_.pathUpsamplingFactor - 1;
    const double length = kControlPoints * (b.position - a.position).norm() * a.direction;
    const std::array<Vec2, 4> points = {a.position, a.position + from * length,
                                        b.position - to * length, b.position};
    const std::size_t first = path_.size();
    for (int i = 1; i <= count; ++i) {
      path_.push_back({bezier(points, static_cast<double>(i) / (count + 1)), 0.0});
    }
    path_.push_back({b.position, base::headingOf(to)});
    for (std::size_t i = first; i + 1 < path_.size(); ++i) {
      const Vec2 tangent =
          arcDirection(path_[i - 1].position, path_[i].position, path_[i + 1].position, false);
      path_[i].heading = base::headingOf(
          alignedWith(tangent, (path_[i + 1].position - path_[i].position) * a.direction));
    }
  }

  const std::vector<ConstrainedPose>& poses_;
  const std::vector<bool>& kept_;
  const ConstrainedSmootherParameters& parameters_;
  Path path_;
};

}  // namespace

SmoothResult smoothPath(const ConstrainedSmootherParameters& parameters, Distro /*distro*/,
                        const Path& path, const Costmap& costmap, double maxDuration) {
  SmoothResult result;
  if (path.size() < 2 || costmap.costs().empty()) {
    result.error = path.empty() ? SmoothError::InvalidPath : SmoothError::FailedToSmoothPath;
    return result;
  }
  std::vector<ConstrainedPose> poses = posesOf(path, parameters);
  const SmoothProblem problem(poses, costmap, parameters);
  std::vector<double> point = problem.firstPoint();
  if (problem.variables() > 0) {
    LeastSquaresLimits limits;
    const double allowed = std::clamp(maxDuration, 0.0, kMaxFitDuration) * kPosesPerSecond /
                           static_cast<double>(problem.variables());
    limits.maxIterations = static_cast<int>(std::min<double>(parameters.maxIterations, allowed));
    limits.functionTolerance = parameters.fnTol;
    limits.gradientTolerance = parameters.gradientTol;
    limits.parameterTolerance = parameters.paramTol;
    const LeastSquaresResult end = minimizeLeastSquares(problem, limits, point);
    if (!std::isfinite(end.lastCost) || end.lastCost > end.firstCost) {
      result.error = SmoothError::FailedToSmoothPath;
      return result;
    }
    result.wasCompleted = end.isConverged;
  }
  std::vector<ConstrainedPose> smoothed = poses;
  for (std::size_t i = 0; i < smoothed.size(); ++i) {
    smoothed[i].position = problem.placeOf(i, point);
  }
  result.path = PathAssembly(smoothed, problem.kept(), parameters)
                    .assemble(path.front().direction(), path.back().direction());
  return result;
}

}  // namespace sim2d::nav2
