#include "sim2d/nav/Teleop.h"

namespace sim2d {

void TeleopInput::post(Command wish) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wish.number = command_.number + 1;
  command_ = wish;
}

void TeleopInput::drive(const BodyTwist& twist) {
  Command wish;
  wish.kind = Kind::Drive;
  wish.twist = twist;
  post(wish);
}

void TeleopInput::driveTo(const Vec2& point) {
  Command wish;
  wish.kind = Kind::DriveTo;
  wish.point = point;
  post(wish);
}

void TeleopInput::release() {
  post({});
}

TeleopInput::Command TeleopInput::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return command_;
}

}  // namespace sim2d
