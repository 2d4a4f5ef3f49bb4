#include <algorithm>
#include <cmath>

#include "metrics/MetricRegistry.h"

/// The situation in which a run ends: who is near the robot, and where.
namespace metrics {

namespace {

constexpr char kNoPerson[] = "no person at the end";

/// The person with the smallest gap to the robot; null: there are no people.
const Pedestrian* nearestPerson(const Sample& sample) {
  const auto nearest = std::min_element(sample.people.begin(), sample.people.end(),
                                        [&](const Pedestrian& a, const Pedestrian& b) {
                                          return gap(sample.robot, a) < gap(sample.robot, b);
                                        });
  return nearest == sample.people.end() ? nullptr : &*nearest;
}

double finalBearing(const Instant& last) {
  const Pedestrian* const person = nearestPerson(last.now);
  if (person == nullptr) {
    return kNaN;
  }
  const Robot& robot = last.now.robot;
  const Vec2 inRobot = base::Pose2{robot.position, robot.heading}.toLocal(person->position);
  return std::atan2(inRobot.y(), inRobot.x());
}

double finalGap(const Instant& last) {
  const Pedestrian* const person = nearestPerson(last.now);
  return person == nullptr ? kNaN : gap(last.now.robot, *person);
}

double finalSpeed(const Instant& last) {
  const Pedestrian* const person = nearestPerson(last.now);
  return person == nullptr ? kNaN : person->speed;
}

double finalPeopleNear(const Instant& last) {
  const auto isNear = [&last](const Pedestrian& person) {
    return gap(last.now.robot, person) < last.parameters.socialDistance;
  };
  return static_cast<double>(std::count_if(last.now.people.begin(), last.now.people.end(), isNear));
}

/// Computes a value of the last sample.
template <class Read>
MetricComputation finalValue(Read read, const char* why = nullptr) {
  return metricOf<Accumulator>(
      [read](const Accumulator& /*none*/, const Instant& last) { return read(last); }, why);
}

constexpr char kFinalSituationMetrics[] = R"(
= Social Behavior|neutral|robot, people|this program, descriptors of failures
final_bearing_to_person|Direction of the nearest person at the end|rad|(-pi, pi]|atan2(y, x) of the position (x, y) of the person with the smallest gap at the last sample in
  the frame of the robot: 0 ahead, positive to the left; undefined without people
final_distance_to_person|Distance of the nearest person at the end|m|(-inf, inf)|gap of this person at the last sample (not cut at 0); undefined without people
final_person_speed|Speed of the nearest person at the end|m/s|[0, inf)|speed of this person at the last sample; undefined without people
final_people_near|People near the robot at the end||0, 1, ...|number of people with a gap < social_distance at the last sample
)";

}  // namespace

void addFinalSituation(MetricRegistry& to) {
  to.add(kFinalSituationMetrics, {{"final_bearing_to_person", finalValue(finalBearing, kNoPerson)},
                                  {"final_distance_to_person", finalValue(finalGap, kNoPerson)},
                                  {"final_person_speed", finalValue(finalSpeed, kNoPerson)},
                                  {"final_people_near", finalValue(finalPeopleNear)}});
}

}  // namespace metrics
