#include <cmath>

#include "metrics/RobotMotion.h"

/// Outcome of the run, and contacts.
namespace metrics {

namespace {

/// Decision of HuNavSim's evaluator for one person in contact at one sample.
struct ContactBlame {
  bool robot = false, person = false;
};

ContactBlame originalBlame(const Robot& robot, const Pedestrian& person) {
  const base::Pose2 personPose{person.position, person.heading};
  const base::Pose2 robotPose{robot.position, robot.heading};
  const Vec2 robotInPerson = personPose.toLocal(robot.position);
  const Vec2 personInRobot = robotPose.toLocal(person.position);
  const double toRobot = std::fabs(std::atan2(robotInPerson.y(), robotInPerson.x()));
  // The evaluator swaps the arguments, so straight ahead gives pi/2.
  const double toPerson = std::fabs(std::atan2(personInRobot.x(), personInRobot.y()));
  const bool differ = robot.speed != person.speed;
  const bool tie = toRobot == toPerson && !differ;
  return {(toRobot < toPerson && differ) || tie, (toRobot > toPerson && differ) || tie};
}

bool isTimeout(const Instant& last) {
  return last.elapsed() >= last.parameters.timeLimit;
}

/// Contacts with people and obstacles. HuNavSim's evaluator counts a person at each sample in
/// contact; its series is 0 or 1.
class Collisions : public ContactsWithin<&MetricParameters::contactDistance> {
 public:
  using ContactsWithin::ContactsWithin;

  void add(const Instant& at) override {
    ContactsWithin::add(at);
    obstacles_.add(at);
    if (at.usesHunavProfile()) {
      addOriginal(at);
    }
  }
  MetricValue ofRobot(const Instant& last) const {
    return last.usesHunavProfile() ? valueOf(originalOfRobot_) : byRobot();
  }
  MetricValue ofPerson(const Instant& last) const {
    return last.usesHunavProfile() ? valueOf(originalOfPerson_) : byPerson();
  }
  double success(const Instant& last) const {
    if (last.context.goals.empty()) {
      return kNaN;
    }
    const bool touched = count() > 0.0 || obstacles_.count() > 0.0;
    return isCompleted(last) && !touched && !isTimeout(last) ? 1.0 : 0.0;
  }
  double obstacles(const Instant& last) const {
    return last.context.hasObstacles ? obstacles_.count() : kNaN;
  }

 private:
  struct Original {
    double contacts = 0.0;
    SeriesColumn series;
  };
  static MetricValue valueOf(const Original& original) {
    return withSeries(original.contacts, original.series.values(), Kind::Count);
  }

  void addOriginal(const Instant& at) {
    ContactBlame any;
    for (const Pedestrian& person : at.now.people) {
      if (gap(at.now.robot, person) < at.parameters.contactDistance) {
        const ContactBlame blame = originalBlame(at.now.robot, person);
        originalOfRobot_.contacts += blame.robot ? 1.0 : 0.0;
        originalOfPerson_.contacts += blame.person ? 1.0 : 0.0;
        any = {any.robot || blame.robot, any.person || blame.person};
      }
    }
    originalOfRobot_.series.add(at, any.robot ? 1.0 : 0.0);
    originalOfPerson_.series.add(at, any.person ? 1.0 : 0.0);
  }

  Original originalOfRobot_, originalOfPerson_;
  ObstacleContacts obstacles_;
};

constexpr char kOutcomeMetrics[] = R"(
= Safety & Collisions|lower|robot, people|Tsoi et al., SEAN 2.0, RA-L 2022
16 robot_on_person_collision|Robot runs into a person||0, 1, ...|number of contacts (gap < contact_distance begins) caused by the robot or by both, according to
  who approaches faster (METRICS.md, Distances and zones)
17 person_on_robot_collision|Person runs into the robot||0, 1, ...|number of contacts (gap < contact_distance begins) caused by the person or by both, according
  to who approaches faster
= Navigation Performance|higher|robot, people, obstacles, goal|Francis et al. 2025; SocNavBench; CrowdNav; Arena
success|Success||0 or 1|1 if completed, no contact with a person (gap < contact_distance), obstacle_collisions = 0 (or no obstacles) and not timeout;
  else 0; undefined without goal
= Navigation Performance|lower|nothing|all benchmarks
total_time|Duration of the record|s|[0, inf)|T of the whole record, not of the evaluation interval
= Navigation Performance|lower|robot|Arena; CrowdNav
timeout|Timeout||0 or 1|1 if T >= time_limit, T of the evaluation interval
= Safety & Collisions|lower|robot, obstacles|SEAN 2.0; SocNavBench; Arena
obstacle_collisions|Robot runs into an obstacle||0, 1, ...|number of i at which the clearance is <= 0 and was not at i-1, the first sample included
)";

}  // namespace

void addOutcome(MetricRegistry& to) {
  to.add(kOutcomeMetrics,
         {{"robot_on_person_collision", metricOf<Collisions>(&Collisions::ofRobot)},
          {"person_on_robot_collision", metricOf<Collisions>(&Collisions::ofPerson)},
          {"success", metricOf<Collisions>(&Collisions::success, kNoGoal)},
          {"total_time", metricOfLast(&Instant::elapsed)},
          {"timeout", metricOfLast(isTimeout)},
          {"obstacle_collisions", metricOf<Collisions>(&Collisions::obstacles, kNoObstacles)}});
}

}  // namespace metrics
