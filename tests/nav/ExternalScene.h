#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Planner.h"

#ifndef EXAMPLE_PLANNERS  // where the programs and libraries of resources/planners are built
#define EXAMPLE_PLANNERS TEST_OUTPUT_DIR "/planners"
#endif

/// A small world for planners in programs and libraries of others.
namespace external {

using namespace sim2d;

inline PlannerSetup setupOf(const std::string& robot = "amy") {
  PlannerSetup setup;
  setup.robot = robot;
  setup.body.footprint.radius = 0.25;
  setup.body.limits.maxVel = 0.8;
  setup.seed = 18446744073709551615U;
  setup.robotId = 3;
  setup.code = ExternalCodePolicy::Allowed;
  return setup;
}

inline PlannerSetup refusedSetup() {
  PlannerSetup setup = setupOf();
  setup.code = ExternalCodePolicy::Refused;
  return setup;
}

/// A block from (2, 3) to (3, 4), a door from (-1, 3) to (0, 3.1); goal (4, 1).
class Scene {
 public:
  Scene() {
    obstacles_.add({Outline{{{2.0, 3.0}, {3.0, 3.0}, {3.0, 4.0}, {2.0, 4.0}}}});
    door_ = obstacles_.add({Outline{{{-1.0, 3.0}, {0.0, 3.0}, {0.0, 3.1}, {-1.0, 3.1}}}});
    obstacles_.build();
    navigation_ = std::make_unique<NavigationMap>(map_, obstacles_,
                                                  std::vector<Vec2>{{0.0, 0.0}, {4.0, 1.0}});
    observation.goal = Vec2(4.0, 1.0);
    observation.obstacles = &obstacles_;
    observation.navigation = navigation_.get();
    observation.bodies.push_back(
        {7, BodyKind::Person, Vec2(1.5, 1.0), Vec2(0.0, -0.5), -base::kPi / 2.0, 0.3});
  }

  void setDoor(bool isClosed) {
    obstacles_.setEnabled(door_, isClosed);
    navigation_->update(map_, obstacles_);
  }

  Observation observation;

 private:
  OccupancyGrid map_;
  Obstacles obstacles_;
  std::unique_ptr<NavigationMap> navigation_;
  int door_ = -1;
};

inline std::string codeOf(const base::Diagnostics& problems) {
  return problems.empty() ? std::string() : std::string(problems.front().code);
}

inline QByteArray messageOf(const base::Diagnostics& problems) {
  return problems.empty() ? QByteArray() : QByteArray::fromStdString(problems.front().message);
}

struct Drive {
  std::vector<double> commands;  // linear, angular, lateral of each step
  Pose2 end;
  base::Diagnostics problems;
};

/// A robot without inertia, driven for so many steps or until it arrives, while a person crosses.
inline Drive drive(Planner& planner, int steps) {
  Scene scene;
  Observation& now = scene.observation;
  Drive result;
  for (int i = 0; i < steps && (now.goal - now.pose.position).norm() > now.goalRadius; ++i) {
    now.time = i * now.dt;
    const base::Result<BodyTwist> command = planner.command(now);
    if (!command) {
      result.problems = command.diagnostics();
      break;
    }
    for (const double part : {command->linear, command->angular, command->lateral}) {
      result.commands.push_back(part);
    }
    now.motion = *command;
    now.pose.position += now.dt * command->linear * now.pose.direction();
    now.pose.heading = base::wrapToPi(now.pose.heading + now.dt * command->angular);
    now.bodies[0].position += now.dt * now.bodies[0].velocity;
  }
  result.end = now.pose;
  return result;
}

/// Two planners reach the goal by the same commands, bit by bit.
inline void checkDrivesTwice(const std::function<base::Result<std::shared_ptr<Planner>>()>& make) {
  std::vector<double> before;
  for (int run = 0; run < 2; ++run) {
    const auto made = make();
    QVERIFY2(made, messageOf(made.diagnostics()));
    const Drive result = external::drive(**made, 400);
    QVERIFY2(result.problems.empty(), messageOf(result.problems));
    QVERIFY((result.end.position - Vec2(4.0, 1.0)).norm() <= 0.2);
    QVERIFY(result.commands.size() > std::size_t{270});  // 3.9 m at 0.8 m/s
    QVERIFY(run == 0 || (before.size() == result.commands.size() &&
                         std::memcmp(before.data(), result.commands.data(),
                                     before.size() * sizeof(double)) == 0));
    before = result.commands;
  }
}

}  // namespace external
