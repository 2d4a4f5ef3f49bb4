#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/control/dwb/VelocitySamples.h"

namespace sim2d::nav2 {
namespace {

/// Index of the place's cell, -1 off the map: as Costmap::worldToCell, in less time.
class CellIndex {
 public:
  explicit CellIndex(const Costmap& costmap)
      : origin_(costmap.origin()),
        resolution_(costmap.resolution()),
        width_(costmap.width()),
        height_(costmap.height()) {}
  int operator()(const Vec2& place) const {
    const double column = (place.x() - origin_.x()) / resolution_;
    const double row = (place.y() - origin_.y()) / resolution_;
    const bool isInside = column >= 0.0 && row >= 0.0 && column < width_ && row < height_;
    return isInside ? static_cast<int>(row) * width_ + static_cast<int>(column) : -1;
  }

 private:
  Vec2 origin_;
  double resolution_;
  int width_, height_;
};

void locate(const Costmap& costmap, DwbTrajectory& trajectory) {
  const CellIndex indexOf(costmap);
  trajectory.cells.resize(trajectory.poses.size());
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    trajectory.cells[i] = indexOf(trajectory.poses[i].position);
  }
  const auto off = std::find(trajectory.cells.begin(), trajectory.cells.end(), -1);
  trajectory.onMap = static_cast<std::size_t>(off - trajectory.cells.begin());
}

}  // namespace

Pose2 DwbTrajectory::at(double time) const {
  if (time <= 0.0 || poses.size() < 2) {
    return poses.front();
  }
  const double place = time / step;
  if (!(place < static_cast<double>(poses.size() - 1))) {
    return poses.back();
  }
  const auto before = static_cast<std::size_t>(place);
  const double ratio = place - static_cast<double>(before);
  const Pose2& a = poses[before];
  const Pose2& b = poses[before + 1];
  return {(1.0 - ratio) * a.position + ratio * b.position,
          (1.0 - ratio) * a.heading + ratio * b.heading};
}

int stepCount(const DwbParameters& p, const BodyTwist& command) {
  double steps = 0.0;
  if (p.discretizesByTime) {
    steps = std::ceil(p.simTime / p.timeGranularity);
  } else {
    const double speed =
        std::sqrt(command.linear * command.linear + command.lateral * command.lateral);
    const double way = speed * p.simTime;
    const double turn = std::abs(command.angular) * p.simTime;
    steps = std::ceil(std::max(way / p.linearGranularity, turn / p.angularGranularity));
  }
  return std::max(1, static_cast<int>(steps));
}

TrajectoryGenerator::TrajectoryGenerator(Kind kind, double frequency)
    : kind_(kind), period_(1.0 / frequency) {}

void TrajectoryGenerator::start(const DwbParameters& parameters, const Pose2& robot,
                                const BodyTwist& speed, const Costmap& costmap) {
  parameters_ = &parameters;
  costmap_ = &costmap;
  robot_ = robot;
  speed_ = speed;
  turningCount_ = 0;
  lastTurning_ = 0;
  double time = parameters.simTime;
  if (kind_ == Kind::LimitedAccel) {
    time = parameters.simPeriod == 0.0 ? period_ : parameters.simPeriod;
  }
  velocitySamples(parameters, speed, time, commands_);
}

BodyTwist TrajectoryGenerator::next(const BodyTwist& velocity, const BodyTwist& command,
                                    double dt) const {
  if (kind_ == Kind::LimitedAccel) {
    return command;
  }
  const DwbParameters& p = *parameters_;
  return {projectVelocity(velocity.linear, p.accLimX, p.decelLimX, dt, command.linear),
          projectVelocity(velocity.angular, p.accLimTheta, p.decelLimTheta, dt, command.angular),
          projectVelocity(velocity.lateral, p.accLimY, p.decelLimY, dt, command.lateral)};
}

const std::vector<TrajectoryGenerator::Step>& TrajectoryGenerator::turning(double angular,
                                                                           int count) {
  const auto size = static_cast<std::size_t>(count);
  for (std::size_t tried = 0; tried < turningCount_; ++tried) {
    lastTurning_ = lastTurning_ + 1 < turningCount_ ? lastTurning_ + 1 : 0;
    const Turning& known = turnings_[lastTurning_];
    if (known.angular == angular && known.steps.size() == size) {
      return known.steps;
    }
  }
  if (turningCount_ == turnings_.size()) {
    turnings_.emplace_back();
  }
  lastTurning_ = turningCount_++;
  Turning& fresh = turnings_[lastTurning_];
  fresh.angular = angular;
  fresh.steps.resize(size);
  const double dt = parameters_->simTime / count;
  BodyTwist velocity = speed_;
  double heading = robot_.heading;
  for (Step& step : fresh.steps) {
    velocity = next(velocity, {0.0, angular}, dt);
    const base::SinCos direction = base::sinCos(heading);
    heading += velocity.angular * dt;
    step = {heading, direction.sin, direction.cos};
  }
  return fresh.steps;
}

void TrajectoryGenerator::generate(const BodyTwist& command, DwbTrajectory& trajectory) {
  const int count = stepCount(*parameters_, command);
  const double dt = parameters_->simTime / count;
  const std::vector<Step>& turned = turning(command.angular, count);
  trajectory.velocity = command;
  trajectory.step = dt;
  trajectory.poses.clear();
  trajectory.poses.push_back(robot_);
  BodyTwist velocity = speed_;
  Pose2 pose = robot_;
  for (const Step& step : turned) {
    velocity = next(velocity, command, dt);
    if (parameters_->limitsCommand && &step == turned.data()) {
      trajectory.velocity = velocity;
    }
    pose.position += dt * Vec2(velocity.linear * step.cos - velocity.lateral * step.sin,
                               velocity.linear * step.sin + velocity.lateral * step.cos);
    pose.heading = step.heading;
    trajectory.poses.push_back(pose);
  }
  if (parameters_->includesLastPoint) {
    trajectory.poses.push_back(pose);
  }
  locate(*costmap_, trajectory);
}

}  // namespace sim2d::nav2
