#include <algorithm>
#include <cmath>

#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"
#include "sim2d/map/PathPlanner.h"

/// The robot's path: length, directness, curvature.
namespace metrics {

namespace {

constexpr char kNoWay[] = "the robot did not move";
constexpr char kNoTriple[] = "at least three samples are needed";
constexpr double kSameplace = 1e-9;  // [m]

/// best / max(best, actual); 1 if both are 0.
double ratioToBest(double best, double actual) {
  const double larger = std::max(best, actual);
  return larger > 0.0 ? best / larger : 1.0;
}

double shortestToGoal(const Vec2& start, const Instant& last) {
  return sim2d::polylineLength(
      shortestPath(last.context, start, last.context.goals.front().position));
}

double successByLength(const RobotPath& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return kNaN;
  }
  return isCompleted(last) ? ratioToBest(shortestToGoal(way.start(), last), way.length()) : 0.0;
}

/// Arrival time and start position.
class ArrivalPath : public ArrivalTime {
 public:
  void add(const Instant& at) override {
    start_ = at.before == nullptr ? at.now.robot.position : start_;
    ArrivalTime::add(at);
  }
  const Vec2& start() const { return start_; }

 private:
  Vec2 start_ = Vec2::Zero();
};

/// HuNavSim's profile uses the duration of the record.
MetricValue successByTime(const ArrivalPath& way, const Instant& last) {
  if (last.context.goals.empty()) {
    return undefinedValue(kNoGoal);
  }
  const double fastest = last.context.robotMaxSpeed;
  if (!(fastest > 0.0)) {
    return undefinedValue("the robot has no maximum speed");
  }
  const std::optional<double> arrival = way.time(last);
  if (!arrival) {
    return 0.0;
  }
  return ratioToBest(shortestToGoal(way.start(), last) / fastest,
                     last.usesHunavProfile() ? last.elapsed() : *arrival);
}

std::vector<Vec2> shortestToEnd(const RobotPath& way, const Instant& last) {
  return shortestPath(last.context, way.start(), last.now.robot.position);
}

double pathEfficiency(const RobotPath& way, const Instant& last) {
  return way.length() > 0.0
             ? ratioToBest(sim2d::polylineLength(shortestToEnd(way, last)), way.length())
             : kNaN;
}

/// Turning along a path, including the initial alignment.
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

double pathIrregularity(const RobotPath& way, const Instant& last) {
  if (way.length() <= 0.0) {
    return kNaN;
  }
  const double needed = neededTurning(shortestToEnd(way, last), way.startHeading());
  return std::max(way.turning() - needed, 0.0) / way.length();
}

double angleOverLength(const RobotPath& way) {
  return way.length() > 0.0 ? way.turning() / way.length() : kNaN;
}

/// Whether the robot moved before and after the middle one of the three newest positions: a turn on
/// the spot has no curvature.
bool isMotion(const Instant& at) {
  const double slowest = at.parameters.stopLinearSpeed;
  return at.earlier != nullptr && distance(at.now.robot, at.before->robot) >= slowest * at.step() &&
         at.step() > 0.0 &&
         distance(at.before->robot, at.earlier->robot) >=
             slowest * (at.before->time - at.earlier->time);
}

/// The triangle of the three newest positions.
struct Triple {
  explicit Triple(const Instant& at)
      : a(at.earlier->robot.position), b(at.before->robot.position), c(at.now.robot.position) {}
  double twiceArea() const { return std::fabs(base::cross(b - a, c - a)); }

  const Vec2 &a, &b, &c;
};

/// Menger curvature.
double curvature(const Instant& at) {
  if (!isMotion(at)) {
    return kNaN;
  }
  const Triple bend(at);
  const double sides =
      lengthOf(bend.b - bend.a) * lengthOf(bend.c - bend.b) * lengthOf(bend.a - bend.c);
  return sides > 0.0 ? 2.0 * bend.twiceArea() / sides : 0.0;
}

/// 0 for a robot that never moves.
template <double (TermStatistics::*kRead)() const>
double bend(const TermStatistics& bends, const Instant& last) {
  return bends.count() > 0.0 || last.count() < 3 ? (bends.*kRead)() : 0.0;
}

/// Uses the longest side: for a reversal the end points are close to each other.
double roughness(const Instant& at) {
  if (!isMotion(at)) {
    return kNaN;
  }
  const Triple bend(at);
  const double longest =
      std::max({lengthOf(bend.a - bend.c), lengthOf(bend.b - bend.a), lengthOf(bend.c - bend.b)});
  return longest > 0.0 ? bend.twiceArea() / (longest * longest) : 0.0;
}

constexpr char kPathQualityMetrics[] = R"(
= Navigation Performance|lower|robot|Perez-Higueras, Caballero, Merino, IJSR 2018
2 path_length|Path length|m|[0, inf)|L = sum of |p_(i+1) - p_i|
= Motion Analysis|lower|robot|Perez-Higueras, Caballero, Merino, IJSR 2018
3 cumulative_heading_changes|Cumulative heading changes|rad|[0, inf)|sum of |wrap(psi_(i+1) - psi_i)|
= Navigation Performance|higher|robot, goal|Anderson et al. 2018; Francis et al. 2025
spl|Success weighted by path length||[0, 1]|completed ? L*/max(L, L*) : 0, L* = length of the shortest path from p_0 to the centre of the first goal, L =
  path_length; 1 if both are 0
= Navigation Performance|higher|robot, goal|SocNavGym
stl|Success weighted by time||[0, 1]|completed ? T*/max(T*, time_to_reach_goal) : 0, T* = L*/v_max, L* as in spl; 1 if both are 0; undefined if v_max
  is not above 0
= Navigation Performance|higher|robot|SEAN 2.0; Arena
path_efficiency|Path efficiency||[0, 1]|S/max(S, L), S = length of the shortest path from p_0 to p_(N-1), L = path_length; undefined if L = 0
= Navigation Performance|lower|robot|Guzzi et al. 2013; SocNavBench; SEAN 2.0
path_irregularity|Path irregularity|rad/m|[0, inf)|max(0, cumulative_heading_changes - turning of the shortest path from p_0 to p_(N-1), without legs
  below 1e-9 m)/L; turning: sum of the absolute changes of direction, from psi_0 to the first leg and from leg to leg, without the turn from the last
  leg to psi_(N-1); undefined if L = path_length = 0
= Motion Analysis|lower|robot|Arena; bench-mr
angle_over_length|Turning per metre|rad/m|[0, inf)|cumulative_heading_changes / path_length; undefined if the latter is 0
curvature_avg|Mean curvature|1/m|[0, inf)|mean over the i with 0 < i < N-1, dt_i > 0, d01 >= stop_linear_speed dt_(i-1) and d12 >= stop_linear_speed
  dt_i of 4A/(d01 d12 d20), A = area of the triangle p_(i-1), p_i, p_(i+1) with these sides; 0 where a side is 0, and if there is no such i; undefined
  if N < 3
curvature_max|Largest curvature|1/m|[0, inf)|max over the i of curvature_avg of the same, 0 if there is no such i; undefined if N < 3
roughness_avg|Mean roughness||[0, 0.87]|mean over the i of curvature_avg of 2A/max(d01, d12, d20)^2, A and sides as there; 0 where all sides are 0,
  and if there is no such i; undefined if N < 3
)";

}  // namespace

void addPathQuality(MetricRegistry& to) {
  to.add(kPathQualityMetrics,
         {{"path_length", metricOf<RobotPath>(&RobotPath::length)},
          {"cumulative_heading_changes", metricOf<RobotPath>(&RobotPath::headingChanges)},
          {"spl", metricOf<RobotPath>(successByLength, kNoGoal)},
          {"stl", metricOf<ArrivalPath>(successByTime)},
          {"path_efficiency", metricOf<RobotPath>(pathEfficiency, kNoWay)},
          {"path_irregularity", metricOf<RobotPath>(pathIrregularity, kNoWay)},
          {"angle_over_length", metricOf<RobotPath>(angleOverLength, kNoWay)},
          {"curvature_avg", statisticsOf<curvature>(bend<&TermStatistics::mean>, kNoTriple)},
          {"curvature_max", statisticsOf<curvature>(bend<&TermStatistics::largest>, kNoTriple)},
          {"roughness_avg", statisticsOf<roughness>(bend<&TermStatistics::mean>, kNoTriple)}});
}

}  // namespace metrics
