#include "sim2d/nav/Teleop.h"

namespace sim2d {

void TeleopInput::say(Wish wish) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wish.number = wish_.number + 1;
  wish_ = wish;
}

void TeleopInput::drive(const BodyTwist& twist) {
  Wish wish;
  wish.kind = Kind::Drive;
  wish.twist = twist;
  say(wish);
}

void TeleopInput::headFor(const Vec2& point) {
  Wish wish;
  wish.kind = Kind::HeadFor;
  wish.point = point;
  say(wish);
}

void TeleopInput::release() {
  say({});
}

TeleopInput::Wish TeleopInput::newest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return wish_;
}

}  // namespace sim2d
