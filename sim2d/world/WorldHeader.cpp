#include "sim2d/world/WorldHeader.h"

namespace sim2d {
namespace {

std::vector<std::pair<std::string, double>> parametersOf(const ResolvedHuman& person) {
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
  for (std::size_t i = 0; i < person.wait.size(); ++i) {
    parameters.emplace_back("wait_" + std::to_string(i), person.wait[i]);
  }
  return parameters;
}

TraceHuman traceHuman(const Person& person) {
  const ResolvedHuman& constants = person.constants;
  TraceHuman human;
  human.id = constants.id;
  human.name = constants.name;
  human.kind = personKindName(constants.kind);
  human.model = constants.model;
  human.radius = constants.radius;
  human.mass = constants.mass;
  human.desiredSpeed = constants.desiredSpeed;
  human.group = constants.groupId;
  human.behavior = static_cast<int>(constants.behavior);
  human.configuration = static_cast<int>(constants.configuration);
  human.cyclicGoals = constants.cyclicGoals;
  for (const GoalItem& goal : person.plan->goals) {
    human.goals.push_back({goal.id, goal.position, goal.radius});
  }
  human.parameters = parametersOf(constants);
  return human;
}

TraceRobot traceRobot(const ResolvedRobot& robot) {
  TraceRobot result;
  result.id = robot.id;
  result.name = robot.name;
  result.type = robot.type;
  result.planner = robot.planner;
  result.radius = robot.radius;
  result.mass = robot.mass;
  result.maxVel = robot.maxVel;
  result.maxAcc = robot.maxAcc;
  result.maxOmega = robot.maxOmega;
  result.maxAlpha = robot.maxAlpha;
  result.startTime = robot.startTime;
  for (std::size_t i = 0; i < robot.goals.size(); ++i) {
    result.goals.push_back({robot.goalIds[i], robot.goals[i], robot.goalRadius});
  }
  result.footprint = robot.footprint;
  return result;
}

/// Without the selection: its file is read elsewhere.
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
