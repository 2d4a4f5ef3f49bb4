#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "sim2d/nav/Planner.h"

/// Manual driving of a robot.
namespace sim2d {

/// Command for a robot from outside; the latest one applies. Thread-safe.
class TeleopInput {
 public:
  enum class Kind : std::uint8_t { Nothing, Drive, DriveTo };
  struct Command {
    Kind kind = Kind::Nothing;
    BodyTwist twist;            // Drive
    Vec2 point = Vec2::Zero();  // DriveTo: world frame [m]
    std::uint64_t number = 0;   // incremented by each command, including repeated ones
  };

  void drive(const BodyTwist& twist);  // drive with these velocities until the next command
  void driveTo(const Vec2& point);     // drive to the point and stop
  void release();                      // stand still
  Command latest() const;

 private:
  void post(Command wish);

  mutable std::mutex mutex_;
  Command command_;
};

/// A planner whose command is set from outside. `input` may be written while the planner runs.
class TeleopPlanner : public Planner {
 public:
  virtual const std::shared_ptr<TeleopInput>& input() const = 0;
};

}  // namespace sim2d
