#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

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

MetricValue originalContacts(const Recording& recording, const MetricParameters& parameters,
                             bool Blame::*culprit) {
  std::vector<double> series;
  double count = 0.0;
  for (const Sample& sample : recording.samples) {
    bool any = false;
    for (const Person& person : sample.people) {
      if (gap(sample.robot, person) < parameters.contactDistance &&
          originalBlame(sample.robot, person).*culprit) {
        count += 1.0;
        any = true;
      }
    }
    series.push_back(any ? 1.0 : 0.0);
  }
  return withSeries(countValue(count), std::move(series), Kind::Count);
}

MetricValue contacts(const Recording& recording, const MetricParameters& parameters,
                     std::vector<double> ContactEvents::*culprit) {
  ContactEvents events = contactEvents(recording, parameters.contactDistance);
  const double count = sumOf(events.*culprit);
  return withSeries(countValue(count), std::move(events.*culprit), Kind::Count);
}

MetricValue robotOnPerson(const Recording& recording, const MetricParameters& parameters) {
  return parameters.profile == Profile::Hunav2
             ? originalContacts(recording, parameters, &Blame::robot)
             : contacts(recording, parameters, &ContactEvents::robotOnPerson);
}

MetricValue personOnRobot(const Recording& recording, const MetricParameters& parameters) {
  return parameters.profile == Profile::Hunav2
             ? originalContacts(recording, parameters, &Blame::person)
             : contacts(recording, parameters, &ContactEvents::personOnRobot);
}

}  // namespace

void addContacts(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Tsoi et al., SEAN 2.0, RA-L 2022";
  to.add(
      {"robot_on_person_collision", "Robot runs into a person", "", Category::Safety, Better::Lower,
       needs, "contacts (gap < contact_distance begins) in which the robot closes in faster",
       source, "0, 1, ...", Kind::Count, 16, ""},
      robotOnPerson);
  to.add({"person_on_robot_collision", "Person runs into the robot", "", Category::Safety,
          Better::Lower, needs,
          "contacts (gap < contact_distance begins) in which the person closes in faster", source,
          "0, 1, ...", Kind::Count, 17, ""},
         personOnRobot);
}

}  // namespace metrics
