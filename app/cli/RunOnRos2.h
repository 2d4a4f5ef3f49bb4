#pragma once

#include <memory>

#include "app/cli/Ros2Words.h"
#include "app/run/Session.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// Options of `run` that count with --ros2.
struct RunOnRos2Words {
  Ros2Words ros2;
  bool lockstep = false, stamped = false, sendsGoals = false;
};
void addRunOnRos2Options(CLI::App& command, RunOnRos2Words& words);

/// A run that is told on topics of ROS 2 while it runs, at the pace of the clock on the wall, and
/// whose first robot drives by /cmd_vel. What it is told is recorded with its steps.
class RunOnRos2 {
 public:
  /// Null: not asked for. Ends the command when it cannot be. World and session must outlive it.
  static std::unique_ptr<RunOnRos2> open(const RunOnRos2Words& words,
                                         const sim2d::Scenario& scenario, sim2d::World& world,
                                         Session& session);
  virtual ~RunOnRos2() = default;
  virtual void tell(const sim2d::Frame& frame) = 0;
};

}  // namespace app
