#include <algorithm>
#include <cmath>

#include "metrics/Motion.h"

/// The robot's way: how long, how direct, how bent.
namespace metrics {

namespace {

MetricValue pathLength(const RobotWay& way, const Instant& /*last*/) {
  return numberValue(way.length());
}

MetricValue cumulativeHeadingChanges(const RobotWay& way, const Instant& /*last*/) {
  return withSeries(numberValue(way.turning().sum()), way.turning().terms());
}

void addRobotPath(MetricRegistry& to) {
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"path_length", "Path length", "m", Category::Navigation, Better::Lower, Needs{},
          "sum of |p_(i+1) - p_i|", source, "[0, inf)", Kind::Number, 2},
         streamOf<RobotWay>(pathLength));
  to.add({"cumulative_heading_changes", "Cumulative heading changes", "rad", Category::Motion,
          Better::Lower, Needs{}, "sum of |wrap(psi_(i+1) - psi_i)|", source, "[0, inf)",
          Kind::Number, 3},
         streamOf<RobotWay>(cumulativeHeadingChanges));
}

constexpr char kNoWay[] = "the robot did not move";
constexpr double kSameplace = 1e-9;  // [m]

/// best / max(best, actual); 1 when both are 0.
double ratioToBest(double best, double actual) {
  const double larger = std::max(best, actual);
  return larger > 0.0 ? best / larger : 1.0;
}

double shortestToGoal(const RobotWay& way, const Instant& last) {
  return lengthOf(shortestPath(last.context, way.start(), last.context.goals.front().position));
}

MetricValue successByLength(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  return numberValue(isCompleted(last) ? ratioToBest(shortestToGoal(way, last), way.length())
                                       : 0.0);
}

MetricValue successByTime(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double fastest = last.context.robotMaxSpeed;
  if (!(fastest > 0.0)) {
    return undefinedValue("the robot has no largest speed");
  }
  return numberValue(
      isCompleted(last) ? ratioToBest(shortestToGoal(way, last) / fastest, last.elapsed()) : 0.0);
}

std::vector<Vec2> shortestToEnd(const RobotWay& way, const Instant& last) {
  return shortestPath(last.context, way.start(), last.now.robot.position);
}

MetricValue pathEfficiency(const RobotWay& way, const Instant& last) {
  return way.length() > 0.0 ? numberValue(lengthOf(shortestToEnd(way, last)) / way.length())
                            : undefinedValue(kNoWay);
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

MetricValue pathIrregularity(const RobotWay& way, const Instant& last) {
  if (way.length() <= 0.0) {
    return undefinedValue(kNoWay);
  }
  const double needed = neededTurning(shortestToEnd(way, last), way.startHeading());
  return numberValue(std::max(way.turning().sum() - needed, 0.0) / way.length());
}

MetricValue angleOverLength(const RobotWay& way, const Instant& /*last*/) {
  return way.length() > 0.0 ? numberValue(way.turning().sum() / way.length())
                            : undefinedValue(kNoWay);
}

/// Bends of the three positions of every three samples in a row.
class Bends : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (at.index >= 2) {
      addTriple(first_, at.before->robot.position, at.now.robot.position);
      count_ += 1.0;
    }
    first_ = at.before != nullptr ? at.before->robot.position : at.now.robot.position;
  }
  MetricValue averageCurvature(const Instant& /*last*/) const {
    return ofTriples(curvature_ / count_);
  }
  MetricValue largestCurvature(const Instant& /*last*/) const { return ofTriples(largest_); }
  MetricValue averageRoughness(const Instant& /*last*/) const {
    return ofTriples(roughness_ / count_);
  }

 private:
  void addTriple(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double twiceArea = std::fabs(base::cross(b - a, c - a));
    const double ab = lengthOf(b - a);
    const double bc = lengthOf(c - b);
    const double ca = lengthOf(a - c);
    const double curvature = ab * bc * ca > 0.0 ? 2.0 * twiceArea / (ab * bc * ca) : 0.0;  // Menger
    curvature_ += curvature;
    largest_ = std::max(largest_, curvature);
    roughness_ += ca > 0.0 ? twiceArea / (ca * ca) : 0.0;
  }
  MetricValue ofTriples(double value) const {
    return count_ > 0.0 ? numberValue(value) : undefinedValue("needs three samples");
  }

  Vec2 first_ = Vec2::Zero();                                 // position two samples ago
  double curvature_ = 0.0, largest_ = 0.0, roughness_ = 0.0;  // sums; curvature in 1/m
  double count_ = 0.0;
};

void addShapes(MetricRegistry& to) {
  const char arena[] = "Arena; bench-mr";
  to.add({"angle_over_length", "Turning per metre", "rad/m", Category::Motion, Better::Lower,
          Needs{}, "cumulative_heading_changes / L", arena},
         streamOf<RobotWay>(angleOverLength));
  to.add({"curvature_avg", "Mean curvature", "1/m", Category::Motion, Better::Lower, Needs{},
          "mean over triples of positions of 4A/(d01 d12 d20)", arena},
         streamOf<Bends>(&Bends::averageCurvature));
  to.add({"curvature_max", "Largest curvature", "1/m", Category::Motion, Better::Lower, Needs{},
          "max over triples of positions of 4A/(d01 d12 d20)", arena},
         streamOf<Bends>(&Bends::largestCurvature));
  to.add({"roughness_avg", "Mean roughness", "", Category::Motion, Better::Lower, Needs{},
          "mean over triples of positions of 2A/d20^2", arena},
         streamOf<Bends>(&Bends::averageRoughness));
}

void addOwnPathQuality(MetricRegistry& to) {
  const Needs goal{true, false, false, false, true};
  to.add({"spl", "Success weighted by path length", "", Category::Navigation, Better::Higher, goal,
          "completed ? L*/max(L, L*) : 0, L* = shortest way to the goal",
          "Anderson et al. 2018; Francis et al. 2025", "[0, 1]"},
         streamOf<RobotWay>(successByLength));
  to.add({"stl", "Success weighted by time", "", Category::Navigation, Better::Higher, goal,
          "completed ? T*/max(T, T*) : 0, T* = L*/v_max", "SocNavGym", "[0, 1]"},
         streamOf<RobotWay>(successByTime));
  to.add({"path_efficiency", "Path efficiency", "", Category::Navigation, Better::Higher, Needs{},
          "shortest way from start to final position / L", "SEAN 2.0; Arena", "[0, 1]"},
         streamOf<RobotWay>(pathEfficiency));
  to.add({"path_irregularity", "Path irregularity", "rad/m", Category::Navigation, Better::Lower,
          Needs{}, "max(0, cumulative_heading_changes - turning of the shortest way)/L",
          "Guzzi et al. 2013; SocNavBench; SEAN 2.0"},
         streamOf<RobotWay>(pathIrregularity));
  addShapes(to);
}

}  // namespace

void addPathQuality(MetricRegistry& to) {
  addRobotPath(to);
  addOwnPathQuality(to);
}

}  // namespace metrics
