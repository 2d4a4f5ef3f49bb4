#include "sim2d/nav/StuckWatch.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kStuckProgress = 0.1;   // [m]; less is none
constexpr double kStuckFree = 0.5;       // [m] of progress after which the usual room counts again
constexpr double kStuckJump = 0.5;       // [m] within one step; robots do not drive so far
constexpr double kLongestMoveOff = 2.0;  // [s]
constexpr double kStuckLeastShare = 0.2;

}  // namespace

void StuckWatch::update(double time, const Vec2& position, const Vec2& goal, double rest) {
  hasJustBegun_ = false;
  if (isFirst_ || goal != goal_) {
    isFirst_ = false;
    isMovingOff_ = false;
    tries_ = 0;
    share_ = 1.0;
    since_ = time;
    least_ = rest;
    stuckAt_ = rest;
    rest_ = rest;
    goal_ = goal;
    return;
  }
  if (isMovingOff_) {
    if ((position - from_).norm() >= distance_ || time - since_ > kLongestMoveOff) {
      isMovingOff_ = false;
      since_ = time;
      least_ = rest;
      rest_ = rest;
    }
    return;
  }
  const double jump = rest - rest_;
  rest_ = rest;
  if (jump > kStuckJump) {  // not driven: the way itself has changed
    least_ += jump;
    stuckAt_ += jump;
  }
  if (rest < least_ - kStuckProgress) {
    least_ = rest;
    since_ = time;
  }
  if (rest < stuckAt_ - kStuckFree) {
    tries_ = 0;
    share_ = 1.0;
  }
  if (time - since_ > patience_) {
    isMovingOff_ = true;
    hasJustBegun_ = true;
    ++tries_;
    share_ = std::max(kStuckLeastShare, 0.5 * share_);
    stuckAt_ = tries_ == 1 ? rest : std::min(stuckAt_, rest);
    since_ = time;
    from_ = position;
  }
}

}  // namespace sim2d
