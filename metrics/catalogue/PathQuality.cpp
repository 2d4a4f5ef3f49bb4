#include <algorithm>
#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoGoal[] = "the robot has no goal";
constexpr char kNoWay[] = "the robot did not move";
constexpr double kSameplace = 1e-9;  // [m]

const Vec2& startOf(const Recording& recording) {
  return recording.samples.front().robot.position;
}
const Vec2& endOf(const Recording& recording) {
  return recording.samples.back().robot.position;
}

/// best / max(best, actual); 1 when both are 0.
double ratioToBest(double best, double actual) {
  const double larger = std::max(best, actual);
  return larger > 0.0 ? best / larger : 1.0;
}

double shortestToGoal(const Recording& recording) {
  return lengthOf(shortestPath(recording, startOf(recording), recording.goals.front().position));
}

MetricValue successByLength(const Recording& recording, const MetricParameters& parameters) {
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  return numberValue(isCompleted(recording, parameters)
                         ? ratioToBest(shortestToGoal(recording), pathLength(recording))
                         : 0.0);
}

MetricValue successByTime(const Recording& recording, const MetricParameters& parameters) {
  if (recording.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  if (!(recording.robotMaxSpeed > 0.0)) {
    return undefinedValue("the robot has no largest speed");
  }
  return numberValue(
      isCompleted(recording, parameters)
          ? ratioToBest(shortestToGoal(recording) / recording.robotMaxSpeed, recording.duration())
          : 0.0);
}

MetricValue pathEfficiency(const Recording& recording, const MetricParameters& /*parameters*/) {
  const double length = pathLength(recording);
  if (length <= 0.0) {
    return undefinedValue(kNoWay);
  }
  return numberValue(lengthOf(shortestPath(recording, startOf(recording), endOf(recording))) /
                     length);
}

/// Turning along a path, the first alignment included.
double neededTurning(const std::vector<Vec2>& path, double heading) {
  double turning = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Vec2 leg = path[k] - path[k - 1];
    if (lengthOf(leg) < kSameplace) {
      continue;
    }
    const double direction = std::atan2(leg.y(), leg.x());
    turning += std::fabs(base::angleDiff(direction, heading));
    heading = direction;
  }
  return turning;
}

MetricValue pathIrregularity(const Recording& recording, const MetricParameters& /*parameters*/) {
  const double length = pathLength(recording);
  if (length <= 0.0) {
    return undefinedValue(kNoWay);
  }
  const std::vector<Vec2> path = shortestPath(recording, startOf(recording), endOf(recording));
  const double needed = neededTurning(path, recording.samples.front().robot.heading);
  return numberValue(std::max(sumOf(headingChanges(recording)) - needed, 0.0) / length);
}

MetricValue angleOverLength(const Recording& recording, const MetricParameters& /*parameters*/) {
  const double length = pathLength(recording);
  return length > 0.0 ? numberValue(sumOf(headingChanges(recording)) / length)
                      : undefinedValue(kNoWay);
}

/// Three positions in a row.
struct Triple {
  double curvature = 0.0;  // Menger [1/m]
  double roughness = 0.0;
};

std::vector<Triple> triplesOf(const Recording& recording) {
  std::vector<Triple> triples;
  for (std::size_t i = 2; i < recording.size(); ++i) {
    const Vec2& a = recording.samples[i - 2].robot.position;
    const Vec2& b = recording.samples[i - 1].robot.position;
    const Vec2& c = recording.samples[i].robot.position;
    const double twiceArea = std::fabs(base::cross(b - a, c - a));
    const double ab = lengthOf(b - a);
    const double bc = lengthOf(c - b);
    const double ca = lengthOf(a - c);
    Triple triple;
    triple.curvature = ab * bc * ca > 0.0 ? 2.0 * twiceArea / (ab * bc * ca) : 0.0;
    triple.roughness = ca > 0.0 ? twiceArea / (ca * ca) : 0.0;
    triples.push_back(triple);
  }
  return triples;
}

MetricValue meanOfTriples(const Recording& recording, double Triple::*member) {
  const std::vector<Triple> triples = triplesOf(recording);
  if (triples.empty()) {
    return undefinedValue("needs three samples");
  }
  double sum = 0.0;
  for (const Triple& triple : triples) {
    sum += triple.*member;
  }
  return numberValue(sum / static_cast<double>(triples.size()));
}

MetricValue averageCurvature(const Recording& recording, const MetricParameters& /*parameters*/) {
  return meanOfTriples(recording, &Triple::curvature);
}

MetricValue averageRoughness(const Recording& recording, const MetricParameters& /*parameters*/) {
  return meanOfTriples(recording, &Triple::roughness);
}

MetricValue largestCurvature(const Recording& recording, const MetricParameters& /*parameters*/) {
  const std::vector<Triple> triples = triplesOf(recording);
  if (triples.empty()) {
    return undefinedValue("needs three samples");
  }
  double largest = 0.0;
  for (const Triple& triple : triples) {
    largest = std::max(largest, triple.curvature);
  }
  return numberValue(largest);
}

void addShapes(MetricRegistry& to) {
  const char arena[] = "Arena; bench-mr";
  to.add({"angle_over_length", "Turning per metre", "rad/m", Category::Motion, Better::Lower,
          Needs{}, "cumulative_heading_changes / L", arena, "[0, inf)", Kind::Number, 0, ""},
         angleOverLength);
  to.add({"curvature_avg", "Mean curvature", "1/m", Category::Motion, Better::Lower, Needs{},
          "mean over triples of positions of 4A/(d01 d12 d20)", arena, "[0, inf)", Kind::Number, 0,
          ""},
         averageCurvature);
  to.add(
      {"curvature_max", "Largest curvature", "1/m", Category::Motion, Better::Lower, Needs{},
       "max over triples of positions of 4A/(d01 d12 d20)", arena, "[0, inf)", Kind::Number, 0, ""},
      largestCurvature);
  to.add({"roughness_avg", "Mean roughness", "", Category::Motion, Better::Lower, Needs{},
          "mean over triples of positions of 2A/d20^2", arena, "[0, inf)", Kind::Number, 0, ""},
         averageRoughness);
}

}  // namespace

void addPathQuality(MetricRegistry& to) {
  const Needs goal{true, false, false, false, true};
  to.add({"spl", "Success weighted by path length", "", Category::Navigation, Better::Higher, goal,
          "completed ? L*/max(L, L*) : 0, L* = shortest way to the goal",
          "Anderson et al. 2018; Francis et al. 2025", "[0, 1]", Kind::Number, 0, ""},
         successByLength);
  to.add(
      {"stl", "Success weighted by time", "", Category::Navigation, Better::Higher, goal,
       "completed ? T*/max(T, T*) : 0, T* = L*/v_max", "SocNavGym", "[0, 1]", Kind::Number, 0, ""},
      successByTime);
  to.add({"path_efficiency", "Path efficiency", "", Category::Navigation, Better::Higher, Needs{},
          "shortest way from start to final position / L", "SEAN 2.0; Arena", "[0, 1]",
          Kind::Number, 0, ""},
         pathEfficiency);
  to.add({"path_irregularity", "Path irregularity", "rad/m", Category::Navigation, Better::Lower,
          Needs{}, "max(0, cumulative_heading_changes - turning of the shortest way)/L",
          "Guzzi et al. 2013; SocNavBench; SEAN 2.0", "[0, inf)", Kind::Number, 0, ""},
         pathIrregularity);
  addShapes(to);
}

}  // namespace metrics
