#pragma once

#include <atomic>
#include <memory>

#include "sim2d/nav/Teleop.h"
#include "sim2d/trace/Frame.h"

namespace app {

/// A robot of a running world in somebody's hands: what it is told becomes an input of each step,
/// which overrides its planner and is recorded. Its limits hold. Orders: any thread; `inputs`: the
/// thread that runs.
class HandSteering {
 public:
  /// `robot`: as in frames, -1, -2 …
  HandSteering(int robot, const sim2d::RobotBody& body);

  int robot() const { return robot_; }
  void drive(const sim2d::BodyTwist& twist);  // until something else is said; zero brakes
  void headFor(const base::Vec2& point);      // there, and stop
  void letGo();                               // its planner drives again

  /// For the step after this frame; nothing when it was let go or is not in the frame.
  sim2d::StepInputs inputs(const sim2d::Frame& frame);

 private:
  const int robot_;
  std::shared_ptr<sim2d::TeleopPlanner> planner_;
  std::atomic<bool> isHeld_{false};
};

}  // namespace app
