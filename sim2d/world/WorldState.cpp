#include "sim2d/world/WorldState.h"

#include <algorithm>
#include <cmath>

#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/Variation.h"

namespace sim2d {

Vec2 PeriodicCorridor::inside(const Vec2& place) const {
  const double turns = isClosed() ? std::floor((place.x() - low) / length) : 0.0;
  return {place.x() - turns * length, place.y()};
}

Vec2 PeriodicCorridor::shift(const Vec2& place, const Vec2& seenFrom) const {
  const double turns = isClosed() ? std::round((seenFrom.x() - place.x()) / length) : 0.0;
  return {turns * length, 0.0};
}

void WorldState::append(const Person& person) {
  present.push_back(0);
  positions.push_back(person.constants.start.position);
  velocities.emplace_back(0.0, 0.0);
  heading.push_back(person.constants.start.heading);
  omega.push_back(0.0);
  active.push_back(0);
  held.push_back(0);
  HumanControl control;
  control.goals = person.plan->goals;
  control.group = person.constants.groupId;
  controls.push_back(std::move(control));
}

ResolvedHuman resolvePerson(const WorldModel& world, const Human& human) {
  const Environment& scenario = *world.environment;
  const bool isOriginal = world.compatibility.hunav2();
  ResolvedHuman person = resolveHuman(scenario, human, static_cast<long long>(world.seed));
  if (isOriginal && !scenario.desktop.model && !human.ours.model) {
    person.model = "sfm-hunav2";
    person.modelParameters = modelParametersOf(scenario, person.model);
  }
  if (isOriginal && !scenario.desktop.route && !human.ours.route) {
    person.route = Route::Direct;
  }
  person.radius = bodyRadiusOverride(*world.registries, person).value_or(person.radius);
  const VariationSettings& variation = scenario.desktop.variation;
  person.isVaried = isVaried(variation);
  if (person.isVaried) {
    PersonVariation(variation, static_cast<long long>(world.seed), person.id, person.groupId)
        .apply(person);
  }
  return person;
}

RobotBody bodyOf(const ResolvedRobot& robot) {
  RobotBody body;
  body.kinematics = robot.kinematics;
  body.footprint = {robot.radius, robot.footprint};
  body.limits.maxVel = robot.maxVel;
  body.limits.maxReverse = robot.maxReverse;
  body.limits.turningRadius = robot.turningRadius;
  body.limits.maxAcc = robot.maxAcc;
  body.limits.maxOmega = robot.maxOmega;
  body.limits.maxAlpha = robot.maxAlpha;
  body.mass = robot.mass;
  return body;
}

double circumscribedRadius(const ResolvedRobot& robot) {
  return circumscribedRadius(Footprint{robot.radius, robot.footprint});
}

Obstacles::Point nearestPointOf(const ResolvedRobot& robot, const Pose2& pose, const Vec2& point) {
  Obstacles::Point nearest;
  const Vec2 local = pose.toLocal(point);
  if (robot.footprint.empty()) {
    const double distance = local.norm();
    const Vec2 outwards = distance > 1e-9 ? Vec2(local / distance) : Vec2(1.0, 0.0);
    nearest.position = pose.toWorld(robot.radius * outwards);
    nearest.inside = distance < robot.radius;
  } else {
    double best = 1e300;
    for (std::size_t i = 0; i < robot.footprint.size(); ++i) {
      const Vec2& next = robot.footprint[(i + 1) % robot.footprint.size()];
      const Vec2 foot = closestOnSegment({robot.footprint[i], next}, local);
      if ((foot - local).squaredNorm() < best) {
        best = (foot - local).squaredNorm();
        nearest.position = pose.toWorld(foot);
      }
    }
    nearest.inside = isInside(robot.footprint, local);
  }
  nearest.distance = (nearest.position - point).norm();
  return nearest;
}

}  // namespace sim2d
