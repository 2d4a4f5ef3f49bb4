#include "app/studies/ContactList.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/studies/Manoeuvres.h"
#include "sim2d/base/Math.h"

namespace app {

namespace {

bool isInView(const base::Pose2& eye, const base::Vec2& place, double range, double field) {
  const base::Vec2 towards = place - eye.position;
  if (towards.norm() > range) {
    return false;
  }
  const double bearing = base::atan2(towards.y(), towards.x());
  return std::fabs(base::angleDiff(bearing, eye.heading)) <= 0.5 * field;
}

/// The detector of a robot of the scenario; that of the generic robot if there is none.
sim2d::DetectorParameters detectorOf(const sim2d::Scenario& scenario, int robotId) {
  int id = 0;
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed && --id == robotId) {
      return sim2d::resolveRobot(scenario, robot, id).detector;
    }
  }
  return sim2d::idealDetector();
}

}  // namespace

std::vector<AvoidableContact> contactsIn(const sim2d::Recording& recording) {
  std::vector<AvoidableContact> contacts;
  std::map<std::pair<int, int>, double> lastTouch;  // of a pair [s]
  for (const sim2d::ContactMark& mark : sim2d::contactMarks(recording)) {
    if (mark.id >= 0 || mark.other.value_or(-1) < 0) {
      continue;
    }
    const auto [last, isNew] = lastTouch.try_emplace({mark.id, *mark.other}, mark.time);
    const bool isSame = !isNew && mark.time - last->second <= kSameContact;
    last->second = mark.time;
    if (isSame) {
      continue;
    }
    AvoidableContact& contact = contacts.emplace_back();
    contact.step = mark.step;
    contact.time = mark.time;
    contact.robot = mark.id;
    contact.person = *mark.other;
    contact.position = mark.position;
    contact.cause = mark.cause;
  }
  return contacts;
}

MutualSight::MutualSight(const Bundle& run, int robot, int person)
    : robotId_(robot), personId_(person) {
  const sim2d::DetectorParameters detector = detectorOf(*run.scenario, robot);
  range_ = detector.range;
  field_ = detector.field;
  isOccluded_ = detector.isOccluded;
}

bool MutualSight::Sight::update(bool isInSight, double time, double gap) {
  if (!isInSight) {
    if (begin && time - last > gap) {
      begin.reset();
    }
    return false;
  }
  last = time;
  if (begin) {
    return false;
  }
  begin = time;
  return true;
}

bool MutualSight::update(const sim2d::Frame& frame, const sim2d::Obstacles& obstacles) {
  const std::optional<BodyState> robot = bodyStateIn(frame, robotId_);
  const std::optional<BodyState> person = bodyStateIn(frame, personId_);
  bool seesPerson = false, seesRobot = false;
  if (robot && person) {
    const bool isVisible = obstacles.isVisible(robot->pose.position, person->pose.position);
    seesPerson =
        (isVisible || !isOccluded_) && isInView(robot->pose, person->pose.position, range_, field_);
    seesRobot =
        isVisible && isInView(person->pose, robot->pose.position, kPersonSight, kPersonField);
  }
  person_.update(seesRobot, frame.time, kPersonMemory);
  return robot_.update(seesPerson, frame.time, kSightGap);
}

}  // namespace app
