#include "app/python/CrowdEnvironment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sim2d/nav/Lidar.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/Runner.h"
#include "sim2d/world/WorldState.h"

namespace python {

namespace {

/// The index of the robot of this name among the listed robots.
std::size_t indexOf(const sim2d::Scenario& scenario, const std::string& name) {
  std::size_t index = 0;
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed && robot.name == name) {
      return index;
    }
    index += robot.listed ? 1 : 0;
  }
  throw std::invalid_argument("the scenario has no robot '" + name + "'");
}

std::vector<std::string> robotsOrFirst(const sim2d::Scenario& scenario,
                                       std::vector<std::string> robots) {
  const auto first = std::find_if(scenario.robots.begin(), scenario.robots.end(),
                                  [](const sim2d::Robot& robot) { return robot.listed; });
  if (first == scenario.robots.end()) {
    throw std::invalid_argument("the scenario has no robot");
  }
  return robots.empty() ? std::vector{first->name} : std::move(robots);
}

/// The scenario with these robots driven from outside.
std::shared_ptr<sim2d::Scenario> drivenScenario(const sim2d::Scenario& scenario,
                                                const std::vector<std::string>& robots) {
  auto driven = std::make_shared<sim2d::Scenario>(scenario);
  for (sim2d::Robot& robot : driven->robots) {
    if (std::find(robots.begin(), robots.end(), robot.name) != robots.end()) {
      robot.planner = "teleop";
      robot.plannerParameters = {};
    }
  }
  return driven;
}

sim2d::LidarParameters lidarOf(const EnvironmentOptions& options, double dt) {
  sim2d::LidarParameters lidar;
  lidar.beams = options.beams;
  lidar.range = sim2d::kPolicyLidarRange;
  lidar.rate = 1.0 / dt;
  return lidar;
}

}  // namespace

/// One copy of the scenario with its episode.
struct CrowdEnvironment::Copy {
  std::unique_ptr<sim2d::World> world;
  std::vector<sim2d::Lidar> lidars;  // per driven robot; none without beams
  std::vector<base::Vec2> goals;     // current goal per driven robot
  std::vector<std::vector<base::Vec2>> goalLists;
  std::vector<std::size_t> nextGoals;
  std::vector<double> distances;  // to the goal, before the action [m]
  std::vector<double> speeds;     // last commanded speed [m/s]
  std::vector<EpisodeEnd> ends;   // of this episode
  std::vector<double> gaps;       // to the nearest person, in the last step [m]
  std::vector<sim2d::SensedBody> bodies;
  std::vector<sim2d::TrackedBody> tracks;  // the same bodies, as a policy observes them
  sim2d::LaserScan scan;
  bool isOver = true;
};

CrowdEnvironment::CrowdEnvironment(app::Bundle bundle, EnvironmentOptions options)
    : bundle_(std::move(bundle)), options_(std::move(options)) {
  options_.robots = robotsOrFirst(*bundle_.scenario, options_.robots);
  for (const std::string& name : options_.robots) {
    indices_.push_back(indexOf(*bundle_.scenario, name));
  }
  bundle_.scenario = drivenScenario(*bundle_.scenario, options_.robots);
  app::Verdict verdict = app::check(bundle_, app::CheckDepth::Meaning);
  problems_ = std::move(verdict.wrongOptions);
  base::append(problems_, verdict.problems);
  dt_ = bundle_.scenario->desktop.dt.value_or(dt_);
  std::size_t index = 0;
  int id = -1;
  for (const sim2d::Robot& robot : bundle_.scenario->robots) {
    if (robot.listed) {
      const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(*bundle_.scenario, robot, id--);
      if (std::find(indices_.begin(), indices_.end(), index++) != indices_.end()) {
        bodies_.push_back(sim2d::bodyOf(resolved));
      }
    }
  }
  const std::size_t rows = options_.count * robots();
  copies_.resize(options_.count);
  observations_.state.resize(rows * kStateColumns);
  observations_.people.resize(rows * options_.people * kPersonColumns);
  observations_.lidar.resize(rows * static_cast<std::size_t>(options_.beams));
  observations_.grid.resize(rows * options_.gridCells * options_.gridCells);
  rewards_.resize(rows);
  ends_.resize(rows);
  episodes_.assign(options_.count, -1);
}

CrowdEnvironment::~CrowdEnvironment() = default;

std::uint64_t CrowdEnvironment::seedOf(std::size_t copy) const {
  // Positive, as seeds of scenarios are; different for each copy and episode.
  const auto number = static_cast<std::uint64_t>(episodes_[copy]) * options_.count + copy;
  return (options_.seed * 1'000'003 + number) % (std::uint64_t{1} << 53) + 1;
}

void CrowdEnvironment::start(std::size_t copy) {
  ++episodes_[copy];
  auto scenario = std::make_shared<sim2d::Scenario>(*bundle_.scenario);
  scenario->desktop.seed = static_cast<long long>(seedOf(copy));
  app::Bundle bundle = bundle_;
  bundle.scenario = scenario;
  app::Verdict verdict = app::check(bundle, app::CheckDepth::World);
  if (!verdict.world) {
    throw std::runtime_error(verdict.problems.empty() ? "the world cannot be made"
                                                      : verdict.problems.back().text());
  }
  auto made = std::make_unique<Copy>();
  made->world = std::move(verdict.world);
  made->isOver = false;
  int id = -1;
  std::size_t index = 0;
  for (const sim2d::Robot& robot : scenario->robots) {
    if (!robot.listed) {
      continue;
    }
    const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(*scenario, robot, id--);
    if (std::find(indices_.begin(), indices_.end(), index++) != indices_.end()) {
      made->goalLists.push_back(resolved.goals);
      if (options_.beams > 0) {
        made->lidars.emplace_back(lidarOf(options_, dt_), seedOf(copy), resolved.id);
      }
    }
  }
  const std::size_t driven = robots();
  made->nextGoals.assign(driven, 0);
  made->speeds.assign(driven, 0.0);
  made->gaps.assign(driven, sim2d::kPolicyPeopleRange);
  made->ends.assign(driven, EpisodeEnd::None);
  made->goals.resize(driven, base::Vec2::Zero());
  made->distances.resize(driven, 0.0);
  for (std::size_t robot = 0; robot < driven; ++robot) {
    const base::Vec2 place =
        made->world->view().robotPose(static_cast<int>(indices_[robot])).position;
    made->goals[robot] = made->goalLists[robot].empty() ? place : made->goalLists[robot].front();
    made->distances[robot] = (made->goals[robot] - place).norm();
  }
  copies_[copy] = std::move(made);
}

void CrowdEnvironment::reset(std::uint64_t seed) {
  options_.seed = seed;
  episodes_.assign(options_.count, -1);
  std::fill(rewards_.begin(), rewards_.end(), 0.0);
  std::fill(ends_.begin(), ends_.end(), EpisodeEnd::None);
  for (std::size_t copy = 0; copy < options_.count; ++copy) {
    start(copy);
    observe(copy);
  }
}

void CrowdEnvironment::step(const float* actions, std::size_t columns) {
  std::fill(rewards_.begin(), rewards_.end(), 0.0);
  std::fill(ends_.begin(), ends_.end(), EpisodeEnd::None);
  for (std::size_t copy = 0; copy < options_.count; ++copy) {
    if (copies_[copy] == nullptr || copies_[copy]->isOver) {
      start(copy);
    } else {
      advance(copy, actions + copy * robots() * columns, columns);
    }
    observe(copy);
  }
}

void CrowdEnvironment::noteEvents(Copy& of) {
  for (const sim2d::Event& event : of.world->frame().events) {
    for (std::size_t robot = 0; robot < robots(); ++robot) {
      const int id = -1 - static_cast<int>(indices_[robot]);
      const bool isOwn = event.hasId && event.id == id;
      const bool isOther = event.hasOther && event.other == id;
      EpisodeEnd& end = of.ends[robot];
      if (end != EpisodeEnd::None) {
        continue;
      }
      if (event.kind == sim2d::EventKind::Contact && (isOwn || isOther)) {
        end = EpisodeEnd::Collided;
      } else if (sim2d::isRobotArrival(event, id)) {
        end = EpisodeEnd::Arrived;
      } else if (event.kind == sim2d::EventKind::Goal && isOwn &&
                 of.nextGoals[robot] + 1 < of.goalLists[robot].size()) {
        of.goals[robot] = of.goalLists[robot][++of.nextGoals[robot]];
        const base::Vec2 place =
            of.world->view().robotPose(static_cast<int>(indices_[robot])).position;
        of.distances[robot] = (of.goals[robot] - place).norm();
      }
    }
  }
}

double CrowdEnvironment::rewardOf(Copy& of, std::size_t robot, double speed) {
  const RewardWeights& weights = options_.weights;
  const double elapsed = dt_ * options_.repeat;
  const base::Vec2 place = of.world->view().robotPose(static_cast<int>(indices_[robot])).position;
  const double distance = (of.goals[robot] - place).norm();
  const double closeness = std::max(0.0, options_.personalDistance - of.gaps[robot]) * elapsed;
  const double jerk = std::fabs(speed - of.speeds[robot]);
  const double reward = weights.arrival * (of.ends[robot] == EpisodeEnd::Arrived ? 1.0 : 0.0) +
                        weights.collision * (of.ends[robot] == EpisodeEnd::Collided ? 1.0 : 0.0) +
                        weights.progress * (of.distances[robot] - distance) +
                        weights.closeness * closeness + weights.time * elapsed +
                        weights.jerk * jerk;
  of.distances[robot] = distance;
  of.speeds[robot] = speed;
  return reward;
}

void CrowdEnvironment::advance(std::size_t copy, const float* actions, std::size_t columns) {
  Copy& of = *copies_[copy];
  sim2d::StepInputs inputs;
  for (std::size_t robot = 0; robot < robots(); ++robot) {
    const float* const action = actions + robot * columns;
    sim2d::Input input;
    input.kind = sim2d::InputKind::Robot;
    input.id = -1 - static_cast<int>(indices_[robot]);
    const bool isDriving = of.ends[robot] == EpisodeEnd::None;
    const auto component = [&](std::size_t i) {
      return isDriving && std::isfinite(action[i]) ? static_cast<double>(action[i]) : 0.0;
    };
    input.velocity = {component(0), columns > 2 ? component(2) : 0.0};
    input.omega = component(1);
    inputs.push_back(input);
  }
  const std::vector<EpisodeEnd> before = of.ends;
  bool isAlive = true;
  for (int i = 0; i < options_.repeat && isAlive; ++i) {
    isAlive = of.world->step(inputs);
    noteEvents(of);
  }
  const bool isTimeUp = !isAlive || of.world->time() >= options_.duration - 1e-9;
  bool isOver = true;
  for (std::size_t robot = 0; robot < robots(); ++robot) {
    const std::size_t row = copy * robots() + robot;
    if (before[robot] != EpisodeEnd::None) {
      continue;  // it ended earlier in this episode
    }
    rewards_[row] = rewardOf(of, robot, inputs[robot].velocity.x());
    if (of.ends[robot] == EpisodeEnd::None && isTimeUp) {
      of.ends[robot] = EpisodeEnd::TimedOut;
    }
    ends_[row] = of.ends[robot];
    isOver = isOver && of.ends[robot] != EpisodeEnd::None;
  }
  of.isOver = isOver;
}

void CrowdEnvironment::observe(std::size_t copy) {
  Copy& of = *copies_[copy];
  const sim2d::WorldView& view = of.world->view();
  of.bodies.clear();
  for (int human = 0; human < view.humanCount(); ++human) {
    if (view.isPresent(human)) {
      const base::Pose2 pose = view.pose(human);
      of.bodies.push_back({view.constants(human).id, sim2d::BodyKind::Person, pose.position,
                           pose.heading, view.velocity(human), view.constants(human).radius,
                           nullptr});
    }
  }
  std::sort(of.bodies.begin(), of.bodies.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  for (int robot = view.robotCount() - 1; robot >= 0; --robot) {
    const base::Pose2 pose = view.robotPose(robot);
    of.bodies.push_back({-1 - robot, sim2d::BodyKind::Robot, pose.position, pose.heading,
                         view.robotVelocity(robot), view.robotRadius(robot), nullptr});
  }
  of.tracks.clear();
  for (const sim2d::SensedBody& body : of.bodies) {
    of.tracks.push_back(
        {body.id, body.kind, body.position, body.velocity, body.heading, body.radius});
  }
  for (std::size_t robot = 0; robot < robots(); ++robot) {
    const std::size_t row = copy * robots() + robot;
    const std::size_t index = indices_[robot];
    const base::Pose2 pose = view.robotPose(static_cast<int>(index));
    const base::Pose2 frame{base::Vec2::Zero(), pose.heading};
    const base::Vec2 velocity = frame.toLocal(view.robotVelocity(static_cast<int>(index)));
    sim2d::writePolicyState(pose,
                            {velocity.x(), of.world->frame().robots.omega[index], velocity.y()},
                            of.goals[robot], observations_.state.data() + row * kStateColumns);
    observePeople(of, robot, row);
    if (options_.beams > 0) {
      of.lidars[robot].update({pose, pose, of.world->obstacles(), of.bodies, of.world->time()});
      observeLidar(of, robot, row);
    }
    observeGrid(of, robot, row);
  }
}

void CrowdEnvironment::observePeople(Copy& of, std::size_t robot, std::size_t row) {
  const sim2d::WorldView& view = of.world->view();
  const int index = static_cast<int>(indices_[robot]);
  const base::Pose2 pose = view.robotPose(index);
  const auto near = sim2d::nearestPeople(pose.position, of.tracks);
  of.gaps[robot] = near.empty()
                       ? sim2d::kPolicyPeopleRange
                       : near.front().first - near.front().second->radius - view.robotRadius(index);
  sim2d::writePolicyPeople(pose, near, options_.people,
                           observations_.people.data() + row * options_.people * kPersonColumns);
}

void CrowdEnvironment::observeLidar(const Copy& of, std::size_t robot, std::size_t row) {
  const auto beams = static_cast<std::size_t>(options_.beams);
  const base::Pose2 pose = of.world->view().robotPose(static_cast<int>(indices_[robot]));
  sim2d::writePolicyLidar(pose, of.lidars[robot].scan(), beams,
                          observations_.lidar.data() + row * beams);
}

void CrowdEnvironment::observeGrid(const Copy& of, std::size_t robot, std::size_t row) {
  const std::size_t side = options_.gridCells;
  if (side == 0) {
    return;
  }
  const int index = static_cast<int>(indices_[robot]);
  std::vector<sim2d::TrackedBody> others = of.tracks;
  others.erase(std::remove_if(others.begin(), others.end(),
                              [&](const auto& body) { return body.id == -1 - index; }),
               others.end());
  sim2d::writePolicyGrid(
      of.world->view().robotPose(index), others, of.world->obstacles(),
      {options_.people, static_cast<std::size_t>(options_.beams), side, options_.gridResolution},
      observations_.grid.data() + row * side * side);
}

}  // namespace python
