#pragma once

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

/// Notices that a robot does not get on, and then has it move off a little and content itself with
/// less room, again and again until it does. A person in the way may go on standing there, so that
/// to wait is no way out. Thread: one at a time.
class StuckWatch {
 public:
  /// Without progress for `patience` [s] the robot moves off by `distance` [m].
  StuckWatch(double patience, double distance) : patience_(patience), distance_(distance) {}

  /// Once per step. `rest`: what is left of the way [m], turns included; `goal` tells a new one.
  void update(double time, const Vec2& position, const Vec2& goal, double rest);

  bool isMovingOff() const { return isMovingOff_; }
  /// How often in a row it has moved off in vain.
  int tries() const { return tries_; }
  /// Of the room that is usually left to others: 1 while all is well, down to 0.2.
  double shareOfMargin() const { return share_; }
  /// True in the step in which it began to move off.
  bool hasJustBegun() const { return hasJustBegun_; }

 private:
  double patience_, distance_;
  bool isFirst_ = true;
  bool isMovingOff_ = false;
  bool hasJustBegun_ = false;
  int tries_ = 0;
  double share_ = 1.0;
  double since_ = 0.0;        // of the last progress, or of moving off [s]
  double least_ = 0.0;        // rest at the last progress [m]
  double rest_ = 0.0;         // in the last step [m]
  double stuckAt_ = 0.0;      // rest when it got stuck [m]
  Vec2 from_ = Vec2::Zero();  // where it moves off from
  Vec2 goal_ = Vec2::Zero();
};

}  // namespace sim2d
