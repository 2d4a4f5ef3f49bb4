#include <algorithm>
#include <cmath>

#include "metrics/Motion.h"
#include "metrics/TermSums.h"

/// The robot's way: how long, how direct, how bent.
namespace metrics {

namespace {

constexpr char kNoWay[] = "the robot did not move";
constexpr char kNoTriple[] = "needs three samples";
constexpr double kSameplace = 1e-9;  // [m]

/// best / max(best, actual); 1 when both are 0.
double ratioToBest(double best, double actual) {
  const double larger = std::max(best, actual);
  return larger > 0.0 ? best / larger : 1.0;
}

double shortestToGoal(const RobotWay& way, const Instant& last) {
  return sim2d::lengthOfWay(
      shortestPath(last.context, way.start(), last.context.goals.front().position));
}

double successByLength(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return kNaN;
  }
  return isCompleted(last) ? ratioToBest(shortestToGoal(way, last), way.length()) : 0.0;
}

MetricValue successByTime(const RobotWay& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double fastest = last.context.robotMaxSpeed;
  if (!(fastest > 0.0)) {
    return undefinedValue("the robot has no largest speed");
  }
  return isCompleted(last) ? ratioToBest(shortestToGoal(way, last) / fastest, last.elapsed()) : 0.0;
}

std::vector<Vec2> shortestToEnd(const RobotWay& way, const Instant& last) {
  return shortestPath(last.context, way.start(), last.now.robot.position);
}

double pathEfficiency(const RobotWay& way, const Instant& last) {
  return way.length() > 0.0 ? sim2d::lengthOfWay(shortestToEnd(way, last)) / way.length() : kNaN;
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

double pathIrregularity(const RobotWay& way, const Instant& last) {
  if (way.length() <= 0.0) {
    return kNaN;
  }
  const double needed = neededTurning(shortestToEnd(way, last), way.startHeading());
  return std::max(way.turning() - needed, 0.0) / way.length();
}

double angleOverLength(const RobotWay& way) {
  return way.length() > 0.0 ? way.turning() / way.length() : kNaN;
}

/// The triangle of the three newest positions.
struct Triple {
  explicit Triple(const Instant& at)
      : a(at.earlier->robot.position), b(at.before->robot.position), c(at.now.robot.position) {}
  double twiceArea() const { return std::fabs(base::cross(b - a, c - a)); }

  const Vec2 &a, &b, &c;
};

/// After Menger.
double curvature(const Instant& at) {
  if (at.earlier == nullptr) {
    return kNaN;
  }
  const Triple bend(at);
  const double sides =
      lengthOf(bend.b - bend.a) * lengthOf(bend.c - bend.b) * lengthOf(bend.a - bend.c);
  return sides > 0.0 ? 2.0 * bend.twiceArea() / sides : 0.0;
}

double roughness(const Instant& at) {
  if (at.earlier == nullptr) {
    return kNaN;
  }
  const Triple bend(at);
  const double span = lengthOf(bend.a - bend.c);
  return span > 0.0 ? bend.twiceArea() / (span * span) : 0.0;
}

void addShapes(MetricRegistry& to) {
  const MetricFamily shapes{to, Category::Motion, Better::Lower, {}, "Arena; bench-mr"};
  shapes.add("angle_over_length", "Turning per metre", "rad/m", "cumulative_heading_changes / L",
             streamOf<RobotWay>(angleOverLength, kNoWay));
  shapes.add("curvature_avg", "Mean curvature", "1/m",
             "mean over triples of positions of 4A/(d01 d12 d20)",
             figuresOf<curvature>(&Figures::mean, kNoTriple));
  shapes.add("curvature_max", "Largest curvature", "1/m",
             "max over triples of positions of 4A/(d01 d12 d20)",
             figuresOf<curvature>(&Figures::largest, kNoTriple));
  shapes.add("roughness_avg", "Mean roughness", "", "mean over triples of positions of 2A/d20^2",
             figuresOf<roughness>(&Figures::mean, kNoTriple));
}

}  // namespace

void addPathQuality(MetricRegistry& to) {
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"path_length", "Path length", "m", Category::Navigation, Better::Lower, Needs{},
          "sum of |p_(i+1) - p_i|", source, "[0, inf)", Kind::Number, 2},
         streamOf<RobotWay>(&RobotWay::length));
  to.add({"cumulative_heading_changes", "Cumulative heading changes", "rad", Category::Motion,
          Better::Lower, Needs{}, "sum of |wrap(psi_(i+1) - psi_i)|", source, "[0, inf)",
          Kind::Number, 3},
         streamOf<RobotWay>(&RobotWay::headingChanges));
  const Needs goal{true, false, false, false, true};
  to.add({"spl", "Success weighted by path length", "", Category::Navigation, Better::Higher, goal,
          "completed ? L*/max(L, L*) : 0, L* = shortest way to the goal",
          "Anderson et al. 2018; Francis et al. 2025", "[0, 1]"},
         streamOf<RobotWay>(successByLength, kNoGoal));
  to.add({"stl", "Success weighted by time", "", Category::Navigation, Better::Higher, goal,
          "completed ? T*/max(T, T*) : 0, T* = L*/v_max", "SocNavGym", "[0, 1]"},
         streamOf<RobotWay>(successByTime));
  to.add({"path_efficiency", "Path efficiency", "", Category::Navigation, Better::Higher, Needs{},
          "shortest way from start to final position / L", "SEAN 2.0; Arena", "[0, 1]"},
         streamOf<RobotWay>(pathEfficiency, kNoWay));
  to.add({"path_irregularity", "Path irregularity", "rad/m", Category::Navigation, Better::Lower,
          Needs{}, "max(0, cumulative_heading_changes - turning of the shortest way)/L",
          "Guzzi et al. 2013; SocNavBench; SEAN 2.0"},
         streamOf<RobotWay>(pathIrregularity, kNoWay));
  addShapes(to);
}

}  // namespace metrics
