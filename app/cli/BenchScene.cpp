#include "app/cli/BenchScene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bt/human/TreeBehavior.h"
#include "sim2d/world/World.h"

namespace app {
namespace {

using sim2d::Scenario;
using sim2d::Vec2;

constexpr double kDensity = 0.5;         // [1/m²]
constexpr double kSpeed = 1.3;           // [m/s]
constexpr double kStep = 0.05;           // [s]
constexpr double kGoalDistance = 100.0;  // [m]; goals are outside the square and never reached
constexpr double kRobotClearance = 1.2;  // [m]
constexpr int kSegmentsPerWall = 100;

/// Pseudo-random numbers (linear congruential), the same in every run.
class Jitter {
 public:
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8U) / 16777216.0;
  }

 private:
  std::uint32_t state_ = 7;
};

void addGoal(Scenario& scenario, int id, const Vec2& position) {
  sim2d::GlobalGoal goal;
  goal.id = id;
  goal.position = position;
  scenario.goals.push_back(goal);
}

/// To the right for odd goals, to the left for even ones, at the agent's own y.
void addPerson(Scenario& scenario, int index, const Vec2& start, int goal) {
  sim2d::Human human;
  human.id = index + 1;
  human.name = "person" + std::to_string(human.id);
  human.initPose = {start, goal % 2 == 1 ? 0.0 : base::kPi};
  human.goals = {goal};
  human.radius = 0.25;
  human.maxVel = kSpeed;
  human.goalRadius = 0.3;
  human.cyclicGoals = false;
  scenario.humans.push_back(human);
}

/// Goals are ten metres apart in y.
int goalAt(double height, bool isRight) {
  const int row = static_cast<int>(height / 10.0);
  return 2 * row + (isRight ? 1 : 2);
}

void addWall(Scenario& scenario, double size, double height, double zigzag) {
  sim2d::Obstacle wall;
  wall.name = "wall" + std::to_string(scenario.obstacles.size() + 1);
  wall.kind = sim2d::ObstacleKind::Wall;
  wall.thickness = 0.1;
  for (int i = 0; i <= kSegmentsPerWall; ++i) {
    wall.points.emplace_back(size * i / kSegmentsPerWall, height + (i % 2 == 0 ? 0.0 : zigzag));
  }
  scenario.obstacles.push_back(wall);
}

void addRobot(Scenario& scenario, const Vec2& place) {
  sim2d::Robot robot;
  robot.name = "robot";
  robot.start = {place, 0.0};
  robot.radius = 0.35;
  scenario.robots.push_back(robot);
}

/// The force of the model, written for readability instead of speed.
Vec2 plainForce(const Vec2& apart, const Vec2& relative) {
  const double distance = std::sqrt(apart.squaredNorm());
  const Vec2 e = apart / distance;
  const Vec2 interaction = 2.0 * relative + e;
  const double length = std::sqrt(interaction.squaredNorm());
  if (length < 1e-6) {
    return Vec2::Zero();
  }
  const Vec2 t = interaction / length;
  const double reach = 0.35 * length;
  const double theta =
      std::atan2(t.x() * e.y() - t.y() * e.x(), t.x() * e.x() + t.y() * e.y()) + 0.005 * reach;
  const double forSpeed = 3.0 * reach * theta;
  const double forTurn = 2.0 * reach * theta;
  const double slowing = -std::exp(-distance / reach - forSpeed * forSpeed);
  const double turning = std::copysign(std::exp(-distance / reach - forTurn * forTurn), -theta);
  return 5.0 * (slowing * t + turning * Vec2(-t.y(), t.x()));
}

}  // namespace

Scenario makeBenchScenario(const BenchScene& scene) {
  Scenario scenario;
  scenario.desktop.dt = kStep;
  scenario.desktop.seed = 1;
  const double size = std::sqrt(scene.people / kDensity);
  for (int row = 0; 10.0 * row <= size; ++row) {
    const double height = 10.0 * row + 5.0;
    addGoal(scenario, 2 * row + 1, Vec2(size + kGoalDistance, height));
    addGoal(scenario, 2 * row + 2, Vec2(-kGoalDistance, height));
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(scene.people)));
  const double gap = size / side;
  const Vec2 middle(size / 2.0, size / 2.0);
  Jitter jitter;
  const int people = scene.singlePerson ? 1 : scene.people;
  scenario.humans.reserve(static_cast<std::size_t>(people));
  for (int i = 0; i < people; ++i) {
    const double x = (i % side + 0.25 + 0.5 * jitter.next()) * gap;
    const int row = i / side;
    const double y = (row + 0.25 + 0.5 * jitter.next()) * gap;
    const bool isRight = jitter.next() < 0.5;
    if ((Vec2(x, y) - middle).norm() > kRobotClearance) {
      addPerson(scenario, i, Vec2(x, y), goalAt(y, isRight));
    }
  }
  addRobot(scenario, middle);
  if (scene.walls) {
    addWall(scenario, size, -0.7, -0.3);
    addWall(scenario, size, size + 0.7, 0.3);
  }
  return scenario;
}

base::Result<std::unique_ptr<sim2d::World>> makeBenchWorld(const BenchScene& scene) {
  Scenario scenario = makeBenchScenario(scene);
  // Route search is unnecessary: the streams are straight.
  scenario.desktop.route = sim2d::Route::Direct;
  bt::TreeFiles trees;
  for (const sim2d::Human& human : scenario.humans) {
    trees[human.name] = scene.tree;
  }
  base::Diagnostics diagnostics;
  sim2d::WorldSetup setup;
  setup.behavior = bt::makeTreeBehavior(scenario, trees, diagnostics);
  if (!setup.behavior) {
    return diagnostics;
  }
  setup.scenario = std::make_shared<const Scenario>(std::move(scenario));
  setup.threads = scene.threads;
  return sim2d::World::create(std::move(setup));
}

int crossingSteps(const BenchScene& scene) {
  constexpr int kMinSteps = 30;
  const double size = std::sqrt(scene.people / kDensity);
  return std::max(kMinSteps, static_cast<int>(size / 7.0 / (kSpeed * kStep)));
}

std::string benchTreeText() {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<root main_tree_to_execute="Walker" BTCPP_format="4">
  <BehaviorTree ID="Walker">
    <ReactiveFallback>
      <ReactiveSequence>
        <IsRobotVisible agent_id="{id}" distance="0.1"/>
        <Inverter><IsGoalReached agent_id="{id}"/></Inverter>
        <LookAtRobot agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <IsGoalReached agent_id="{id}"/>
        <UpdateGoal agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <IsRobotVisible agent_id="{id}" distance="0.2"/>
        <ForceSuccess><AlwaysSuccess/></ForceSuccess>
        <LookAtRobot agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <Inverter><IsGoalReached agent_id="{id}"/></Inverter>
        <AlwaysSuccess/>
        <RegularNav agent_id="{id}" time_step="{dt}"/>
      </ReactiveSequence>
    </ReactiveFallback>
  </BehaviorTree>
</root>
)";
}

double plainStepSeconds(const Scenario& scenario, double atLeastSeconds) {
  std::vector<Vec2> positions;
  std::vector<Vec2> velocities;
  for (const sim2d::Human& human : scenario.humans) {
    positions.push_back(human.initPose.position);
    velocities.push_back(kSpeed * base::directionOf(human.initPose.heading));
  }
  std::vector<Vec2> forces(positions.size(), Vec2::Zero());
  double fastest = 1e300;
  double before = sim2d::clockSeconds(sim2d::StepClock::Thread);
  const double end = before + atLeastSeconds;
  while (fastest == 1e300 || before < end) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      forces[i] = Vec2::Zero();
      for (std::size_t k = 0; k < positions.size(); ++k) {
        if (k != i) {
          forces[i] += plainForce(positions[k] - positions[i], velocities[i] - velocities[k]);
        }
      }
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
      velocities[i] += kStep * forces[i];
      velocities[i] *= std::min(1.0, kSpeed / std::max(velocities[i].norm(), 1e-9));
      positions[i] += kStep * velocities[i];
    }
    const double now = sim2d::clockSeconds(sim2d::StepClock::Thread);
    fastest = std::min(fastest, now - before);
    before = now;
  }
  return fastest;
}

namespace {

using Anchor = report::Figure::Anchor;

/// The times of one kind, with the roles of their line and dots.
struct Series {
  double BenchPoint::*time;
  const char *line, *dot;
  std::string name;
};

void drawSeries(report::Figure& figure, const report::Scale& across, const report::Scale& up,
                const std::vector<BenchPoint>& points, const Series& series) {
  std::vector<Vec2> line;
  for (const BenchPoint& point : points) {
    line.emplace_back(across.at(point.people), up.at(point.*series.time));
    if (series.time != &BenchPoint::plain || !point.isScaled) {
      figure.disc(line.back().x(), line.back().y(), 3.0, series.dot);
    }
  }
  figure.polyline(line, series.line, 2.0);
}

}  // namespace

report::Figure benchFigure(const std::vector<BenchPoint>& points, const std::string& machine) {
  constexpr double kTickMs = 50.0;  // [ms] of simulated time
  constexpr double kWidth = 720.0;
  constexpr double kHeight = 405.0;
  double low = kTickMs;
  double high = kTickMs;
  for (const BenchPoint& point : points) {
    low = std::min({low, point.whole, point.forces, point.plain});
    high = std::max({high, point.whole, point.forces, point.plain});
  }
  const report::Scale across{1.0 * points.front().people, 1.0 * points.back().people, 64.0,
                             kWidth - 28.0, true};
  const report::Scale up{std::pow(10.0, std::floor(std::log10(low))),
                         std::pow(10.0, std::ceil(std::log10(high))), kHeight - 72.0, 56.0, true};
  report::Figure figure("bench", kWidth, kHeight);
  figure.text(0.5 * kWidth, 20.0, machine, "ink", Anchor::Middle, 12.5);
  figure.text(8.0, 42.0, "time per 50 ms step [ms]", "dim");
  for (const double people : report::axisTicks(across)) {
    figure.line(across.at(people), up.from, across.at(people), up.to, "grid");
  }
  report::verticalAxis(figure, up, report::axisTicks(up), across.from, across.to);
  report::horizontalAxis(figure, across, up.from);
  figure.text(across.to, up.from + 32.0, "people", "dim", Anchor::End);
  figure.line(across.from, up.at(kTickMs), across.to, up.at(kTickMs), "axis");
  figure.text(across.from + 4.0, up.at(kTickMs) - 4.0, "real time", "dim", Anchor::Start, 10.0);
  const Series all[] = {
      {&BenchPoint::plain, "zero", "dim", "forces, naive sum over all pairs (dots: measured)"},
      {&BenchPoint::whole, "line", "ink", "full step with trees, bodies and lidar"},
      {&BenchPoint::forces, "accent", "heat", "forces only"}};
  double left = 12.0;  // of a legend entry [px]
  for (const Series& series : all) {
    constexpr double kSample = 24.0;
    constexpr double kLetter = 5.7;
    drawSeries(figure, across, up, points, series);
    figure.line(left, kHeight - 16.0, left + kSample, kHeight - 16.0, series.line, 2.0);
    figure.text(left + kSample + 6.0, kHeight - 12.0, series.name, "dim", Anchor::Start, 10.0);
    left += kSample + 24.0 + kLetter * static_cast<double>(series.name.size());
  }
  return figure;
}

}  // namespace app
