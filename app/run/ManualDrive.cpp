#include "app/run/ManualDrive.h"

#include <algorithm>

#include "app/run/ProgramRegistries.h"
#include "sim2d/world/Registries.h"

namespace app {

ManualDrive::ManualDrive(int robot, const sim2d::RobotBody& body) : robot_(robot) {
  sim2d::PlannerSetup setup;
  setup.body = body;
  setup.parameters = {{"timeout", 0.0}};  // no timeout: releaseControl() ends the control
  const sim2d::Registries registries = builtinRegistries();
  if (const auto* const teleop = registries.planners.find("teleop")) {
    if (const auto made = teleop->make(setup)) {
      planner_ = std::dynamic_pointer_cast<sim2d::TeleopPlanner>(*made);
    }
  }
}

void ManualDrive::drive(const sim2d::BodyTwist& twist) {
  planner_->input()->drive(twist);
  isActive_ = true;
}

void ManualDrive::driveTo(const base::Vec2& point) {
  planner_->input()->driveTo(point);
  isActive_ = true;
}

void ManualDrive::releaseControl() {
  isActive_ = false;
}

sim2d::StepInputs ManualDrive::inputs(const sim2d::Frame& frame) {
  const sim2d::RobotColumns& robots = frame.robots;
  const auto found = std::find(robots.id.begin(), robots.id.end(), robot_);
  if (!isActive_ || found == robots.id.end()) {
    return {};
  }
  const auto i = static_cast<std::size_t>(found - robots.id.begin());
  sim2d::Observation seen;
  seen.pose = {{robots.x[i], robots.y[i]}, robots.heading[i]};
  seen.time = frame.time;
  const base::Result<sim2d::BodyTwist> command = planner_->command(seen);
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = robot_;
  input.velocity = {command ? command->linear : 0.0, 0.0};
  input.omega = command ? command->angular : 0.0;
  return {input};
}

}  // namespace app
