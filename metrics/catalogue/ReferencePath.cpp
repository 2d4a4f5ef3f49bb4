#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

/// The robot against a reference: a recorded run, else the shortest way to its goal, driven at full
/// speed.
namespace metrics {

namespace {

constexpr char kNoGoal[] = "there is no goal and no reference";
constexpr std::size_t kMostPoints = 400;  // of a comparison of all with all

bool hasReference(const Recording& recording) {
  return !recording.reference.empty() || !recording.goals.empty();
}

std::vector<Vec2> referencePath(const Recording& recording) {
  if (!recording.reference.empty()) {
    std::vector<Vec2> path;
    for (const auto& [time, place] : recording.reference) {
      path.push_back(place);
    }
    return path;
  }
  return shortestPath(recording, recording.samples.front().robot.position,
                      recording.goals.front().position);
}

/// The point of the way after this length; its end beyond.
Vec2 pointAt(const std::vector<Vec2>& path, double length) {
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double part = lengthOf(path[k] - path[k - 1]);
    if (length <= part && part > 0.0) {
      return path[k - 1] + (length / part) * (path[k] - path[k - 1]);
    }
    length -= part;
  }
  return path.back();
}

/// Where the recorded run was; its ends before and after.
Vec2 recordedPlace(const std::vector<std::pair<double, Vec2>>& reference, double time) {
  const auto after =
      std::upper_bound(reference.begin(), reference.end(), time,
                       [](double wanted, const auto& point) { return wanted < point.first; });
  if (after == reference.begin() || after == reference.end()) {
    return after == reference.end() ? reference.back().second : reference.front().second;
  }
  const auto& [begin, from] = *std::prev(after);
  return from + (time - begin) / (after->first - begin) * (after->second - from);
}

std::vector<double> displacements(const Recording& recording) {
  const std::vector<Vec2> path = referencePath(recording);
  std::vector<double> values;
  for (const Sample& sample : recording.samples) {
    const double time = sample.time - recording.samples.front().time;
    const Vec2 place = recording.reference.empty() ? pointAt(path, recording.robotMaxSpeed * time)
                                                   : recordedPlace(recording.reference, time);
    values.push_back(lengthOf(sample.robot.position - place));
  }
  return values;
}

MetricValue averageDisplacement(const Recording& recording, const MetricParameters& /*p*/) {
  if (!hasReference(recording)) {
    return undefinedValue(kNoGoal);
  }
  std::vector<double> values = displacements(recording);
  const double mean = sumOf(values) / static_cast<double>(values.size());
  return withSeries(numberValue(mean), std::move(values));
}

MetricValue finalDisplacement(const Recording& recording, const MetricParameters& /*p*/) {
  return hasReference(recording) ? numberValue(displacements(recording).back())
                                 : undefinedValue(kNoGoal);
}

double distanceToPath(const std::vector<Vec2>& path, const Vec2& point) {
  double nearest = lengthOf(point - path.front());
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Vec2 edge = path[k] - path[k - 1];
    const double squared = edge.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp(edge.dot(point - path[k - 1]) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, lengthOf(point - path[k - 1] - share * edge));
  }
  return nearest;
}

MetricValue pathDeviation(const Recording& recording, const MetricParameters& /*p*/) {
  if (!hasReference(recording)) {
    return undefinedValue(kNoGoal);
  }
  const std::vector<Vec2> path = referencePath(recording);
  std::vector<double> values;
  for (const Sample& sample : recording.samples) {
    values.push_back(distanceToPath(path, sample.robot.position));
  }
  const double mean = sumOf(values) / static_cast<double>(values.size());
  return withSeries(numberValue(mean), std::move(values));
}

/// Evenly along the way, both ends included.
std::vector<Vec2> spread(const std::vector<Vec2>& path, std::size_t count) {
  const double length = lengthOf(path);
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0.0;
    points.push_back(pointAt(path, share * length));
  }
  return points;
}

/// Cheapest pairing of two ways in order, divided by the number of points of the first.
double warped(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> before(b.size() + 1, kInfinity);
  std::vector<double> now(b.size() + 1, kInfinity);
  before[0] = 0.0;
  for (const Vec2& point : a) {
    now[0] = kInfinity;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      now[k] = (point - b[k - 1]).norm() + std::min({before[k], now[k - 1], before[k - 1]});
    }
    before.swap(now);
  }
  return before.back() / static_cast<double>(a.size());
}

MetricValue dynamicTimeWarping(const Recording& recording, const MetricParameters& /*p*/) {
  if (!hasReference(recording)) {
    return undefinedValue(kNoGoal);
  }
  const std::size_t count = std::min(recording.size(), kMostPoints);
  std::vector<Vec2> driven;
  for (std::size_t k = 0; k < count; ++k) {
    driven.push_back(recording.samples[k * recording.size() / count].robot.position);
  }
  return numberValue(warped(driven, spread(referencePath(recording), count)));
}

}  // namespace

void addReferencePath(MetricRegistry& to) {
  const Needs needs{true, false, false, false, true};
  const char source[] = "Gao and Huang 2022";
  to.add({"ade", "Mean displacement from the reference", "m", Category::Navigation, Better::Lower,
          needs,
          "mean of |p_i - b_i|, b_i = point of the recorded reference at t_i, else of the shortest "
          "way to the first goal after v_max t_i",
          source, "[0, inf)", Kind::Number, 0, ""},
         averageDisplacement);
  to.add({"fde", "Final displacement from the reference", "m", Category::Navigation, Better::Lower,
          needs, "|p_(N-1) - b_(N-1)|", source, "[0, inf)", Kind::Number, 0, ""},
         finalDisplacement);
  to.add(
      {"dtw", "Warped distance from the reference", "m", Category::Navigation, Better::Lower, needs,
       "dynamic time warping of the positions and as many points spread over the way of the "
       "reference, per position (at most 400)",
       source, "[0, inf)", Kind::Number, 0, ""},
      dynamicTimeWarping);
  to.add(
      {"path_deviation", "Mean distance from the way of the reference", "m", Category::Navigation,
       Better::Lower, needs, "mean of the distance from p_i to the way of the reference", "ours",
       "[0, inf)", Kind::Number, 0, ""},
      pathDeviation);
}

}  // namespace metrics
