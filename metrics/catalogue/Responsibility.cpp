#include <algorithm>
#include <cmath>

#include "metrics/MetricRegistry.h"

/// Contributions of robot and people to the resolution of conflicts.
namespace metrics {

namespace {

constexpr double kNoise = 1e-3;  // [m/s] smaller changes are rounding errors

/// Two bodies that approach each other at constant velocities.
struct Encounter {
  Vec2 centres = Vec2::Zero();  // from the robot to the person
  double clear = 1.0;           // sufficient miss distance of the centres [m]

  /// Minimum distance of the centres, at most `clear`.
  double miss(const Vec2& robot, const Vec2& person) const {
    const Vec2 closing = robot - person;
    if (centres.dot(closing) <= 0.0) {
      return clear;
    }
    return std::min(std::fabs(base::cross(centres, closing)) / lengthOf(closing), clear);
  }
  bool isConflict(const Vec2& robot, const Vec2& person, double horizon) const {
    const Vec2 closing = robot - person;
    const double along = centres.dot(closing);
    return along > 0.0 && along <= horizon * closing.squaredNorm() && miss(robot, person) < clear;
  }
};

/// How much each side increases the miss distance of conflicts between two samples: the effect of
/// its change of velocity, averaged over both orders of the changes.
class ConflictResolution : public Accumulator {
 public:
  void add(const Instant& at) override {
    if (at.before == nullptr) {
      return;
    }
    std::size_t next = 0;
    bool isBusy = false;
    for (const Pedestrian& person : at.before->people) {
      const Pedestrian* const after = findInOrder(at.now.people, next, person.id);
      if (after != nullptr && !after->isNew) {
        isBusy = addPair(at, person, *after) || isBusy;
      }
    }
    time_ += isBusy ? at.step() : 0.0;
  }

  double share() const {
    return byRobot_ + byPeople_ > 0.0 ? 100.0 * byRobot_ / (byRobot_ + byPeople_) : kNaN;
  }
  double engagement() const { return time_ > 0.0 ? byRobot_ / time_ : kNaN; }

 private:
  bool addPair(const Instant& at, const Pedestrian& person, const Pedestrian& personAfter) {
    const Robot& robot = at.before->robot;
    const Robot& robotAfter = at.now.robot;
    Encounter pair;
    pair.centres = person.position - robot.position;
    pair.clear = robot.radius + person.radius + at.parameters.conflictMargin;
    const Vec2& v = robot.velocity;
    const Vec2& u = person.velocity;
    if (!pair.isConflict(v, u, at.parameters.conflictHorizon)) {
      return false;
    }
    const double none = pair.miss(v, u);
    const double robotOnly = pair.miss(robotAfter.velocity, u);
    const double personOnly = pair.miss(v, personAfter.velocity);
    const double both = pair.miss(robotAfter.velocity, personAfter.velocity);
    byRobot_ += widening(0.5 * ((robotOnly - none) + (both - personOnly)), at.step());
    byPeople_ += widening(0.5 * ((personOnly - none) + (both - robotOnly)), at.step());
    return true;
  }

  static double widening(double by, double time) { return by > kNoise * time ? by : 0.0; }

  double byRobot_ = 0.0, byPeople_ = 0.0;  // [m]
  double time_ = 0.0;                      // with a conflict [s]
};

constexpr char kResponsibilityMetrics[] = R"(
= Social Behavior|neutral|robot, people|after Wenzel and Probst 2025
responsibility|Responsibility of the robot|%|[0, 100]|100 W_r/(W_r + W_p). For each i > 0 and person present at i-1 and i without event enter since, with C, R
  and velocities v, u of i-1 and v', u' of i: clear = R + conflict_margin, miss(v, u) = min(|cross(C, V)|/|V|, clear) with V = v - u, clear if C V <= 0. A
  conflict is C V > 0, C V <= conflict_horizon |V|^2 and miss(v, u) < clear. In a conflict W_r grows by g = ((miss(v', u) - miss(v, u)) + (miss(v', u') -
  miss(v, u')))/2 if g > 0.001 dt_(i-1), W_p by the same with the parts of robot and person exchanged; undefined if neither grows
= Social Behavior|higher|robot, people|after Wenzel and Probst 2025
engagement|Engagement of the robot|m/s|[0, inf)|W_r of responsibility / sum of dt_(i-1) of the i with a conflict (conflict_horizon, conflict_margin)
  with a person; undefined without conflict
)";

}  // namespace

void addResponsibility(MetricRegistry& to) {
  to.add(kResponsibilityMetrics,
         {{"responsibility",
           metricOf<ConflictResolution>(&ConflictResolution::share, "no conflict was resolved")},
          {"engagement", metricOf<ConflictResolution>(&ConflictResolution::engagement,
                                                      "no conflict with a person")}});
}

}  // namespace metrics
