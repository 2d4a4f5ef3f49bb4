#include <tuple>

#include "sim2d/world/StepBuffers.h"
#include "sim2d/world/WorldInternal.h"

namespace sim2d {
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
