#include "sim2d/nav/StuckDetector.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kStuckProgress = 0.1;    // [m]; smaller changes are not progress
constexpr double kProgressToRelax = 0.5;  // [m] of progress that restores the full margin
constexpr double kStuckJump = 0.5;        // [m] per step; faster than any robot drives
constexpr double kMaxRecoveryTime = 2.0;  // [s]
constexpr double kMinMarginScale = 0.2;

}  // namespace

void StuckDetector::update(double time, const Vec2& position, const Vec2& goal, double rest) {
  hasJustStarted_ = false;
  if (isFirst_ || goal != goal_) {
    isFirst_ = false;
    isRecovering_ = false;
    tries_ = 0;
    share_ = 1.0;
    since_ = time;
    minRemaining_ = rest;
    stuckRemaining_ = rest;
    remaining_ = rest;
    goal_ = goal;
    return;
  }
  if (isRecovering_) {
    if ((position - startPosition_).norm() >= distance_ || time - since_ > kMaxRecoveryTime) {
      isRecovering_ = false;
      since_ = time;
      minRemaining_ = rest;
      remaining_ = rest;
    }
    return;
  }
  const double jump = rest - remaining_;
  remaining_ = rest;
  if (jump > kStuckJump) {  // not driven: the route itself has changed
    minRemaining_ += jump;
    stuckRemaining_ += jump;
  }
  if (rest < minRemaining_ - kStuckProgress) {
    minRemaining_ = rest;
    since_ = time;
  }
  if (rest < stuckRemaining_ - kProgressToRelax) {
    tries_ = 0;
    share_ = 1.0;
  }
  if (time - since_ > patience_) {
    isRecovering_ = true;
    hasJustStarted_ = true;
    ++tries_;
    share_ = std::max(kMinMarginScale, 0.5 * share_);
    stuckRemaining_ = tries_ == 1 ? rest : std::min(stuckRemaining_, rest);
    since_ = time;
    startPosition_ = position;
  }
}

}  // namespace sim2d
