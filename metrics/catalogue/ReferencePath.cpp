#include <algorithm>
#include <iterator>
#include <limits>

#include "metrics/RobotMotion.h"
#include "sim2d/map/PathPlanner.h"

/// Compares the robot with a reference: a recorded run, otherwise the shortest path to its goal at
/// maximum speed.
namespace metrics {

namespace {

constexpr char kNoReference[] = "there is no goal and no reference";
constexpr std::size_t kMostPoints = 800;  // limit for pairwise comparison, besides the last

/// Empty without a reference. `first`: the first sample of the run.
std::vector<Vec2> referencePath(const RunContext& context, const Sample& first) {
  std::vector<Vec2> path;
  for (const auto& [time, place] : context.reference) {
    path.push_back(place);
  }
  if (path.empty() && !context.goals.empty()) {
    path = shortestPath(context, first.robot.position, context.goals.front().position);
  }
  return path;
}

/// The point at this arc length of the path; its end beyond.
Vec2 pointAt(const std::vector<Vec2>& path, double length) {
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double part = (path[k] - path[k - 1]).norm();
    if (length <= part && part > 0.0) {
      return path[k - 1] + (length / part) * (path[k] - path[k - 1]);
    }
    length -= part;
  }
  return path.back();
}

/// Position in the recorded run; its ends before and after.
Vec2 recordedPlace(const TimedPath& reference, double time) {
  const auto after =
      std::upper_bound(reference.begin(), reference.end(), time,
                       [](double wanted, const auto& point) { return wanted < point.first; });
  if (after == reference.begin() || after == reference.end()) {
    return after == reference.end() ? reference.back().second : reference.front().second;
  }
  const auto& [begin, from] = *std::prev(after);
  return from + (time - begin) / (after->first - begin) * (after->second - from);
}

double distanceToPath(const std::vector<Vec2>& path, const Vec2& point) {
  double nearest = (point - path.front()).norm();
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Vec2 edge = path[k] - path[k - 1];
    const double squared = edge.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp(edge.dot(point - path[k - 1]) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (point - path[k - 1] - share * edge).norm());
  }
  return nearest;
}

/// Evenly spaced points along the path, both ends included.
std::vector<Vec2> spread(const std::vector<Vec2>& path, std::size_t count) {
  const double length = sim2d::polylineLength(path);
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0.0;
    points.push_back(pointAt(path, share * length));
  }
  return points;
}

/// Dynamic time warping of two paths, divided by the number of points of the first.
double dynamicTimeWarping(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto count = static_cast<Eigen::Index>(b.size());
  Eigen::ArrayXd x(count), y(count), distances(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    x[k] = b[static_cast<std::size_t>(k)].x();
    y[k] = b[static_cast<std::size_t>(k)].y();
  }
  std::vector<double> before(b.size() + 1, kInfinity);
  std::vector<double> now(b.size() + 1, kInfinity);
  before[0] = 0.0;
  for (const Vec2& point : a) {
    distances = ((point.x() - x).square() + (point.y() - y).square()).sqrt();
    now[0] = kInfinity;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      now[k] = distances[static_cast<Eigen::Index>(k - 1)] +
               std::min({before[k], now[k - 1], before[k - 1]});
    }
    before.swap(now);
  }
  return before.back() / static_cast<double>(a.size());
}

/// The positions of every 2^k-th sample, as many as fit into the limit.
class ThinnedPath {
 public:
  void add(std::size_t index, const Vec2& place) {
    if (index % stride_ == 0 && places_.size() == kMostPoints) {
      for (std::size_t k = 0; 2 * k < places_.size(); ++k) {
        places_[k] = places_[2 * k];
      }
      places_.resize((places_.size() + 1) / 2);
      stride_ *= 2;
    }
    isNewestIn_ = index % stride_ == 0;
    if (isNewestIn_) {
      places_.push_back(place);
    }
  }
  /// Always includes the newest position.
  std::vector<Vec2> upTo(const Vec2& newest) const {
    std::vector<Vec2> way = places_;
    if (!isNewestIn_) {
      way.push_back(newest);
    }
    return way;
  }

 private:
  std::vector<Vec2> places_;
  std::size_t stride_ = 1;
  bool isNewestIn_ = false;
};

class ReferenceComparison : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (at.before == nullptr) {
      path_ = referencePath(at.context, at.now);
    }
    if (path_.empty()) {
      return;
    }
    const Vec2& driven = at.now.robot.position;
    const Vec2 place = at.context.reference.empty()
                           ? pointAt(path_, at.context.robotMaxSpeed * at.elapsed())
                           : recordedPlace(at.context.reference, at.elapsed());
    displacement_ = lengthOf(driven - place);
    displacements_.add(at, displacement_);
    deviations_.add(at, distanceToPath(path_, driven));
    way_.add(at.index, driven);
  }
  /// Relative to the position of the reference at the same time.
  MetricValue meanDisplacement(const Instant& last) const { return meanOf(displacements_, last); }
  double finalDisplacement() const { return displacement_; }
  MetricValue meanDeviation(const Instant& last) const { return meanOf(deviations_, last); }
  double warping(const Instant& last) const {
    if (path_.empty()) {
      return kNaN;
    }
    const std::vector<Vec2> driven = way_.upTo(last.now.robot.position);
    if (last.context.reference.empty()) {
      return dynamicTimeWarping(driven, spread(path_, driven.size()));
    }
    ThinnedPath recorded;  // thinned like the driven path, so that equal runs give 0
    for (std::size_t k = 0; k < path_.size(); ++k) {
      recorded.add(k, path_[k]);
    }
    return dynamicTimeWarping(driven, recorded.upTo(path_.back()));
  }

 private:
  MetricValue meanOf(const SeriesSum& sum, const Instant& last) const {
    return path_.empty() ? kNaN
                         : withSeries(sum.sum() / static_cast<double>(last.count()), sum.terms());
  }

  std::vector<Vec2> path_;
  double displacement_ = kNaN;  // newest value [m]
  SeriesSum displacements_, deviations_;
  ThinnedPath way_;
};

constexpr char kReferencePathMetrics[] = R"(
= Navigation Performance|lower|robot, goal|Gao and Huang 2022
ade|Mean displacement from the reference|m|[0, inf)|mean over i of |p_i - b_i|, b_i = position of the recorded reference (--reference, the samples of its
  evaluation interval, linear between them, constant beyond its ends) at t_i - t_0, else the point v_max (t_i - t_0) metres along the shortest path from
  p_0 to the first goal, or its end
fde|Final displacement from the reference|m|[0, inf)||p_(N-1) - b_(N-1)|, b as in ade
dtw|DTW distance from the reference|m|[0, inf)|dynamic time warping of the positions p_i (of more than 800 samples every 2nd, 4th ... from the first on, as often as
  needed for at most 800, then the last if it is not among them) and those of the recorded reference, selected in the same way, else as many points as these positions, evenly along the shortest path of ade, ends
  included: D(0, 0) = 0, D(j, k) = distance + min(D(j-1, k), D(j, k-1), D(j-1, k-1)), last D / number of positions
= Navigation Performance|lower|robot, goal|HuNavSim Desktop
path_deviation|Mean distance from the reference path|m|[0, inf)|mean over i of the distance of p_i from the polyline of the reference (its positions, else the
  shortest path of ade)
)";

}  // namespace

void addReferencePath(MetricRegistry& to) {
  to.add(
      kReferencePathMetrics,
      {{"ade", metricOf<ReferenceComparison>(&ReferenceComparison::meanDisplacement, kNoReference)},
       {"fde",
        metricOf<ReferenceComparison>(&ReferenceComparison::finalDisplacement, kNoReference)},
       {"dtw", metricOf<ReferenceComparison>(&ReferenceComparison::warping, kNoReference)},
       {"path_deviation",
        metricOf<ReferenceComparison>(&ReferenceComparison::meanDeviation, kNoReference)}});
}

}  // namespace metrics
