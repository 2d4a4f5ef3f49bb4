#include <cmath>

#include "metrics/ContactEvents.h"

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
  void add(const Sample& sample, double limit) {
    bool byRobot = false;
    bool byPerson = false;
    for (const Person& person : sample.people) {
      if (gap(sample.robot, person) < limit) {
        const Blame blame = originalBlame(sample.robot, person);
        robot_ += blame.robot ? 1.0 : 0.0;
        person_ += blame.person ? 1.0 : 0.0;
        byRobot = byRobot || blame.robot;
        byPerson = byPerson || blame.person;
      }
    }
    robotSeries_.push_back(byRobot ? 1.0 : 0.0);
    personSeries_.push_back(byPerson ? 1.0 : 0.0);
  }
  MetricValue value(bool ofRobot) const {
    return withSeries(countValue(ofRobot ? robot_ : person_),
                      ofRobot ? robotSeries_ : personSeries_, Kind::Count);
  }

 private:
  double robot_ = 0.0, person_ = 0.0;
  std::vector<double> robotSeries_, personSeries_;
};

class Contacts : public Accumulator {
 public:
  explicit Contacts(const MetricParameters& parameters)
      : parameters_(parameters), events_(parameters.contactDistance) {}

  void add(const Recording& recording, std::size_t sample) override {
    if (isOriginal()) {
      original_.add(recording.samples[sample], parameters_.contactDistance);
    } else {
      events_.add(recording, sample);
    }
  }
  MetricValue value(bool ofRobot) const {
    if (isOriginal()) {
      return original_.value(ofRobot);
    }
    const std::vector<double>& series = ofRobot ? events_.byRobot() : events_.byPerson();
    return withSeries(countValue(sumOf(series)), series, Kind::Count);
  }

 private:
  bool isOriginal() const { return parameters_.profile == Profile::Hunav2; }

  MetricParameters parameters_;
  ContactEvents events_;
  OriginalContacts original_;
};

void addContact(MetricRegistry& to, MetricInfo info, bool ofRobot) {
  to.addStream(
      std::move(info),
      streamOf<Contacts>(
          "contacts",
          [ofRobot](const Contacts& contacts, const Recording& /*recording*/,
                    const MetricParameters& /*parameters*/) { return contacts.value(ofRobot); },
          [](const MetricParameters& parameters) {
            return std::make_unique<Contacts>(parameters);
          }));
}

}  // namespace

void addContacts(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  addContact(
      to,
      {"robot_on_person_collision", "Robot runs into a person", "", Category::Safety, Better::Lower,
       needs, "contacts (gap < contact_distance begins) in which the robot closes in faster",
       source, "0, 1, ...", Kind::Count, 16, ""},
      true);
  addContact(to,
             {"person_on_robot_collision", "Person runs into the robot", "", Category::Safety,
              Better::Lower, needs,
              "contacts (gap < contact_distance begins) in which the person closes in faster",
              source, "0, 1, ...", Kind::Count, 17, ""},
             false);
}

}  // namespace metrics
