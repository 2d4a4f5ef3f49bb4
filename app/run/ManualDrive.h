#pragma once

#include <atomic>
#include <memory>

#include "sim2d/nav/Teleop.h"
#include "sim2d/trace/Frame.h"

namespace app {

/// Manual control of a robot in a running world. Commands become an input of each step, which
/// overrides the planner and is recorded. The limits of the robot apply. Commands: any thread;
/// `inputs`: the run thread.
class ManualDrive {
 public:
  /// `robot`: id as in frames (-1, -2 …).
  ManualDrive(int robot, const sim2d::RobotBody& body);

  int robot() const { return robot_; }
  void drive(const sim2d::BodyTwist& twist);  // until the next command; zero brakes
  void driveTo(const base::Vec2& point);      // drives there and stops
  void releaseControl();                      // returns control to the planner

  /// The inputs for the step after this frame; empty after releaseControl() or when the frame does
  /// not contain the robot.
  sim2d::StepInputs inputs(const sim2d::Frame& frame);

 private:
  const int robot_;
  std::shared_ptr<sim2d::TeleopPlanner> planner_;
  std::atomic<bool> isActive_{false};
};

}  // namespace app
