#include <cmath>

#include "metrics/Motion.h"

/// How it ended, and contacts on the way.
namespace metrics {

namespace {

/// What the original decides for one person in contact at one sample.
struct Blame {
  bool robot = false, person = false;
};

Blame originalBlame(const Robot& robot, const Person& person) {
  const base::Pose2 personPose{person.position, person.heading};
  const base::Pose2 robotPose{robot.position, robot.heading};
  const Vec2 robotInPerson = personPose.toLocal(robot.position);
  const Vec2 personInRobot = robotPose.toLocal(person.position);
  const double toRobot = std::fabs(std::atan2(robotInPerson.y(), robotInPerson.x()));
  // The arguments are swapped there, so straight ahead gives pi/2.
  const double toPerson = std::fabs(std::atan2(personInRobot.x(), personInRobot.y()));
  const bool differ = robot.speed != person.speed;
  const bool tie = toRobot == toPerson && !differ;
  return {(toRobot < toPerson && differ) || tie, (toRobot > toPerson && differ) || tie};
}

/// Of the original: per sample and person in contact; the series is 0 or 1.
class OriginalContacts {
 public:
  void add(const Instant& at) {
    const Sample& sample = at.now;
    bool byRobot = false;
    bool byPerson = false;
    for (const Person& person : sample.people) {
      if (gap(sample.robot, person) < at.parameters.contactDistance) {
        const Blame blame = originalBlame(sample.robot, person);
        robot_ += blame.robot ? 1.0 : 0.0;
        person_ += blame.person ? 1.0 : 0.0;
        byRobot = byRobot || blame.robot;
        byPerson = byPerson || blame.person;
      }
    }
    robotSeries_.add(at, byRobot ? 1.0 : 0.0);
    personSeries_.add(at, byPerson ? 1.0 : 0.0);
  }
  MetricValue value(bool ofRobot) const {
    return withSeries(countValue(ofRobot ? robot_ : person_),
                      (ofRobot ? robotSeries_ : personSeries_).values(), Kind::Count);
  }

 private:
  double robot_ = 0.0, person_ = 0.0;
  SeriesColumn robotSeries_, personSeries_;
};

class Contacts : public Accumulator {
 public:
  explicit Contacts(const MetricParameters& parameters) : events_(parameters.contactDistance) {}

  void add(const Instant& at) override {
    if (at.isOriginal()) {
      original_.add(at);
    } else {
      events_.add(at);
    }
  }
  MetricValue byRobot(const Instant& last) const { return value(true, last); }
  MetricValue byPerson(const Instant& last) const { return value(false, last); }

 private:
  MetricValue value(bool ofRobot, const Instant& last) const {
    if (last.isOriginal()) {
      return original_.value(ofRobot);
    }
    const SeriesSum& sum = ofRobot ? events_.byRobot() : events_.byPerson();
    return withSeries(countValue(sum.sum()), sum.terms(), Kind::Count);
  }

  ContactEvents events_;
  OriginalContacts original_;
};

void addContacts(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  to.add(
      {"robot_on_person_collision", "Robot runs into a person", "", Category::Safety, Better::Lower,
       needs, "contacts (gap < contact_distance begins) in which the robot closes in faster",
       source, "0, 1, ...", Kind::Count, 16},
      streamOf<Contacts>(&Contacts::byRobot));
  to.add({"person_on_robot_collision", "Person runs into the robot", "", Category::Safety,
          Better::Lower, needs,
          "contacts (gap < contact_distance begins) in which the person closes in faster", source,
          "0, 1, ...", Kind::Count, 17},
         streamOf<Contacts>(&Contacts::byPerson));
}

bool isTimeout(const Instant& last) {
  return last.elapsed() >= last.parameters.timeLimit;
}

class Collisions : public Accumulator {
 public:
  explicit Collisions(const MetricParameters& parameters) : people_(parameters.contactDistance) {}
  void add(const Instant& at) override {
    people_.add(at);
    const Robot& robot = at.now.robot;
    const bool touches = robot.obstacleDistance && *robot.obstacleDistance - robot.radius <= 0.0;
    obstacles_ += touches && !touches_ ? 1.0 : 0.0;
    touches_ = touches;
  }
  MetricValue success(const Instant& last) const {
    const bool touched = people_.count() > 0.0 || obstacles_ > 0.0;
    return booleanValue(isCompleted(last) && !touched && !isTimeout(last));
  }
  MetricValue obstacles(const Instant& /*last*/) const { return countValue(obstacles_); }

 private:
  ContactEvents people_;
  double obstacles_ = 0.0;
  bool touches_ = false;  // an obstacle at the newest sample
};

MetricValue totalTime(const Instant& last) {
  return numberValue(last.elapsed());
}

MetricValue timeout(const Instant& last) {
  return booleanValue(isTimeout(last));
}

void addOwnOutcome(MetricRegistry& to) {
  to.add({"success", "Success", "", Category::Navigation, Better::Higher,
          Needs{true, true, false, true, true},
          "completed, no contact with a person or an obstacle, no timeout",
          "Francis et al. 2025; SocNavBench; CrowdNav; Arena", "0 or 1", Kind::Boolean},
         streamOf<Collisions>(&Collisions::success));
  to.add({"total_time", "Duration of the record", "s", Category::Navigation, Better::Lower,
          Needs{false}, "T = t_(N-1) - t_0", "all benchmarks"},
         streamOfLast(totalTime));
  to.add({"timeout", "Timeout", "", Category::Navigation, Better::Lower, Needs{false},
          "T >= time_limit", "Arena; CrowdNav", "0 or 1", Kind::Boolean},
         streamOfLast(timeout));
  to.add({"obstacle_collisions", "Robot runs into an obstacle", "", Category::Safety, Better::Lower,
          Needs{true, false, false, true},
          "number of times the clearance of the robot falls to 0 or below",
          "SEAN 2.0; SocNavBench; Arena", "0, 1, ...", Kind::Count},
         streamOf<Collisions>(&Collisions::obstacles));
}

}  // namespace

void addOutcome(MetricRegistry& to) {
  addContacts(to);
  addOwnOutcome(to);
}

}  // namespace metrics
