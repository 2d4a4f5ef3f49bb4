#include "sim2d/world/WorldState.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/StepBuffers.h"
#include "sim2d/world/WorldInternal.h"

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

/// Frames and the header of the recording.
namespace {

bool precedes(const Event& a, const Event& b) {
  return std::make_tuple(a.kind, a.hasId ? a.id : 0) < std::make_tuple(b.kind, b.hasId ? b.id : 0);
}

/// Removes the entries of people who are not present; those who entered after the step have zeros.
void removeAbsent(const std::vector<char>& present, std::vector<Vec2>& column) {
  column.resize(present.size(), Vec2::Zero());
  std::size_t count = 0;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i] == 0) {
      continue;
    }
    if (count != i) {  // avoids self-assignment in the common case
      column[count] = column[i];
    }
    ++count;
  }
  column.resize(count);
}

void appendPerson(const WorldModel& model, const WorldState& state, std::size_t i,
                  HumanColumns& humans) {
  const HumanControl& control = state.controls[i];
  const bool hasGoal = !control.goals.empty() && control.goals.front().id > 0;
  humans.add(model.people[i].constants.id, state.pose(i), state.velocity(i), state.omega[i],
             hasGoal ? control.goals.front().id : kNoGoal);
  humans.group.push_back(control.group >= 0 ? control.group : -1);
  humans.state.push_back(static_cast<std::uint8_t>(state.active[i]));
}

void appendRobot(const ResolvedRobot& constants, const RobotState& robot, RobotColumns& robots) {
  const bool isOnList = !robot.externalGoal && robot.goal < constants.goals.size();
  const int goal = isOnList ? constants.goalIds[robot.goal] : 0;
  robots.add(constants.id, robot.pose, robot.velocity, robot.omega, goal > 0 ? goal : kNoGoal);
}

std::vector<std::pair<std::string, double>> traceParameters(const ResolvedHuman& person) {
  std::vector<std::pair<std::string, double>> parameters = {
      {"max_vel", person.desiredSpeed},
      {"radius", person.radius},
      {"mass", person.mass},
      {"goal_radius", person.goalRadius},
      {"start_time", person.startTime},
      {"dist", person.noticeDistance},
      {"duration", person.reactionDuration},
      {"once", person.reactionOnce ? 1.0 : 0.0},
      {"vel", person.reactionSpeed},
      {"safe_distance", person.safeDistance},
      {"stop_dist", person.stopDistance},
      {"front_dist", person.frontDistance},
      {"goal_force_factor", person.goalFactor},
      {"obstacle_force_factor", person.obstacleFactor},
      {"social_force_factor", person.socialFactor},
      {"other_force_factor", person.otherFactor}};
  if (person.isVaried) {
    const Pose2& start = person.start;
    parameters.insert(parameters.end(), {{"start_x", start.position.x()},
                                         {"start_y", start.position.y()},
                                         {"start_h", start.heading},
                                         {"reaction_time", person.reactionTime}});
  }
  for (std::size_t i = 0; i < person.wait.size(); ++i) {
    parameters.emplace_back("wait_" + std::to_string(i), person.wait[i]);
  }
  for (const auto& [name, value] : person.modelParameters) {
    parameters.emplace_back("model_parameters." + name, value);
  }
  return parameters;
}

TraceHuman traceHuman(const Person& person) {
  const ResolvedHuman& of = person.constants;
  std::vector<TraceGoal> goals;
  for (const GoalItem& goal : person.plan->goals) {
    goals.push_back({goal.id, goal.position, goal.radius});
  }
  return {of.id,
          of.name,
          personKindName(of.kind),
          of.model,
          of.radius,
          of.mass,
          of.desiredSpeed,
          of.groupId,
          static_cast<int>(of.behavior),
          static_cast<int>(of.configuration),
          of.cyclicGoals,
          std::move(goals),
          traceParameters(of)};
}

TraceRobot traceRobot(const ResolvedRobot& robot) {
  std::vector<TraceGoal> goals;
  for (std::size_t i = 0; i < robot.goals.size(); ++i) {
    goals.push_back({robot.goalIds[i], robot.goals[i], robot.goalRadius});
  }
  return {robot.id,        robot.name,
          robot.type,      robot.planner,
          robot.radius,    robot.mass,
          robot.maxVel,    robot.maxAcc,
          robot.maxOmega,  robot.maxAlpha,
          robot.startTime, std::move(goals),
          robot.footprint, kinematicsName(robot.kinematics)};
}

/// Without the selection, whose file is read elsewhere.
TraceMetrics traceMetrics(const MetricsSettings& settings) {
  TraceMetrics metrics;
  metrics.from = settings.from.value_or(metrics.from);
  metrics.until = settings.until.value_or(metrics.until);
  metrics.frequency = settings.frequency.value_or(metrics.frequency);
  metrics.tag = settings.tag.value_or(metrics.tag);
  metrics.runId = settings.runId.value_or(metrics.runId);
  metrics.parameters = settings.parameters;
  return metrics;
}

}  // namespace

void fillFrame(const WorldModel& model, WorldState& state, Frame& frame) {
  frame.step = state.step;
  frame.time = state.time;
  forEachColumn(frame.humans, [](auto& column) { column.clear(); });
  forEachColumn(frame.robots, [](auto& column) { column.clear(); });
  if (frame.humans.id.capacity() == 0) {
    // Growing by doubling would need three times the memory.
    forEachColumn(frame.humans, [&](auto& column) { column.reserve(model.people.size()); });
  }
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    if (state.present[i] != 0) {
      appendPerson(model, state, i, frame.humans);
    }
  }
  if (state.step > 0) {
    forEachColumn(frame.forces,
                  [&](std::vector<Vec2>& column) { removeAbsent(state.present, column); });
  }
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    appendRobot(model.robots[i], state.robots[i], frame.robots);
  }
  std::swap(frame.events, state.events);
  sortStably(frame.events, precedes);
  frame.doorOpen = state.doorOpen;
}

TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings) {
  TraceHeader header;
  const Environment& scenario = *model.environment;
  header.scenario = scenario.yamlBaseName.value_or("");
  header.dt = model.dt;
  header.recordEvery = scenario.desktop.recordEvery.value_or(1);
  header.seed = static_cast<long long>(model.seed);
  for (const Person& person : model.people) {
    header.humans.push_back(traceHuman(person));
  }
  for (const ResolvedRobot& robot : model.robots) {
    header.robots.push_back(traceRobot(robot));
  }
  const std::vector<std::string> names = partNames(scenario);
  for (int part = 0; part < surroundings.obstacles.partCount(); ++part) {
    TraceObstacle obstacle;
    obstacle.name = names[static_cast<std::size_t>(part)];
    obstacle.isDoor = part >= surroundings.firstDoorPart;
    if (obstacle.isDoor) {
      const Door& door = *model.doors[static_cast<std::size_t>(part - surroundings.firstDoorPart)];
      obstacle.open = door.open.value_or(true);
      obstacle.toggles = door.toggles;
    }
    obstacle.outlines = surroundings.obstacles.outlines(part);
    header.obstacles.push_back(std::move(obstacle));
  }
  header.obstaclePoints = model.obstaclePoints == ObstaclePoints::Rays ? "rays" : "boundary";
  if (model.ring.isClosed()) {
    header.wrapX = scenario.desktop.wrapX;
  }
  header.map = surroundings.grid;
  header.metrics = traceMetrics(scenario.desktop.metrics);
  return header;
}

std::vector<std::string> partNames(const Environment& scenario) {
  std::vector<std::string> names = {"map"};
  for (const Obstacle& obstacle : scenario.obstacles) {
    if (obstacle.listed) {
      names.push_back(obstacle.name);
    }
  }
  for (const Door& door : scenario.doors) {
    if (door.listed) {
      names.push_back(door.name);
    }
  }
  return names;
}

}  // namespace sim2d
