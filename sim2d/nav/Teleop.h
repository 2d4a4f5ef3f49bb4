#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "sim2d/nav/Planner.h"

/// Driving a robot by hand.
namespace sim2d {

/// What somebody outside wants a robot to do; the newest word counts. Thread: any.
class TeleopInput {
 public:
  enum class Kind : std::uint8_t { Nothing, Drive, HeadFor };
  struct Wish {
    Kind kind = Kind::Nothing;
    BodyTwist twist;            // Drive
    Vec2 point = Vec2::Zero();  // HeadFor: world frame [m]
    std::uint64_t number = 0;   // grows with each word, also when it repeats the last one
  };

  void drive(const BodyTwist& twist);  // with these velocities, until something else is said
  void headFor(const Vec2& point);     // there, and stop
  void release();                      // stand
  Wish newest() const;

 private:
  void say(Wish wish);

  mutable std::mutex mutex_;
  Wish wish_;
};

/// A planner whose command is set from outside. `input` may be written while it runs.
class TeleopPlanner : public Planner {
 public:
  virtual const std::shared_ptr<TeleopInput>& input() const = 0;
};

}  // namespace sim2d
