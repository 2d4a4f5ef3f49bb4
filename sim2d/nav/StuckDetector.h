#pragma once

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

/// Detects that a robot makes no progress; then the robot moves away a little and accepts a smaller
/// margin, repeatedly until it progresses. Waiting alone would not help, because a person may keep
/// standing in the way. Not thread-safe.
class StuckDetector {
 public:
  /// After `patience` [s] without progress the robot moves away by `distance` [m].
  StuckDetector(double patience, double distance) : patience_(patience), distance_(distance) {}

  /// Call once per step. `rest`: remaining path length [m], including turns; a changed `goal`
  /// resets the state.
  void update(double time, const Vec2& position, const Vec2& goal, double rest);

  bool isRecovering() const { return isRecovering_; }
  /// Number of consecutive recoveries without success.
  int tries() const { return tries_; }
  /// Scale of the margin to obstacles: 1 normally, down to 0.2.
  double marginScale() const { return share_; }
  /// True in the step in which a recovery begins.
  bool hasJustStarted() const { return hasJustStarted_; }

 private:
  double patience_, distance_;
  bool isFirst_ = true;
  bool isRecovering_ = false;
  bool hasJustStarted_ = false;
  int tries_ = 0;
  double share_ = 1.0;
  double since_ = 0.0;           // time of the last progress, or of the start of the recovery [s]
  double minRemaining_ = 0.0;    // rest at the last progress [m]
  double remaining_ = 0.0;       // in the last step [m]
  double stuckRemaining_ = 0.0;  // rest when it got stuck [m]
  Vec2 startPosition_ = Vec2::Zero();  // position at the start of the recovery
  Vec2 goal_ = Vec2::Zero();
};

}  // namespace sim2d
