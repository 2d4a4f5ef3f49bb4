#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sim2d::nav2 {
namespace {

/// Index of the cell at a position, -1 off the map; equivalent to Costmap::worldToCell, but faster.
class CellIndex {
 public:
  explicit CellIndex(const Costmap& costmap)
      : origin_(costmap.origin()),
        resolution_(costmap.resolution()),
        size_(costmap.width(), costmap.height()),
        width_(costmap.width()) {}
  int operator()(const Vec2& place) const {
    const Vec2 cell = (place - origin_) / resolution_;
    const bool isInside =
        cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < size_.x() && cell.y() < size_.y();
    return isInside ? static_cast<int>(cell.y()) * width_ + static_cast<int>(cell.x()) : -1;
  }

 private:
  Vec2 origin_;
  double resolution_;
  Vec2 size_;  // [cells]
  int width_;
};

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
  headingProfileCount_ = 0;
  lastHeadingProfile_ = 0;
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

const TrajectoryGenerator::HeadingProfile& TrajectoryGenerator::headingProfile(double angular,
                                                                               int count) {
  const auto size = static_cast<std::size_t>(count);
  for (std::size_t tried = 0; tried < headingProfileCount_; ++tried) {
    lastHeadingProfile_ =
        lastHeadingProfile_ + 1 < headingProfileCount_ ? lastHeadingProfile_ + 1 : 0;
    const HeadingProfile& known = headingProfiles_[lastHeadingProfile_];
    if (known.angular == angular && known.steps.size() == size) {
      return known;
    }
  }
  if (headingProfileCount_ == headingProfiles_.size()) {
    headingProfiles_.emplace_back();
  }
  lastHeadingProfile_ = headingProfileCount_++;
  HeadingProfile& fresh = headingProfiles_[lastHeadingProfile_];
  fresh.angular = angular;
  fresh.steps.resize(size);
  headings_.resize(size + 1);
  directions_.resize(size + 1);
  const DwbParameters& p = *parameters_;
  const double dt = p.simTime / count;
  double speed = speed_.angular;
  double heading = robot_.heading;
  headings_[0] = heading;
  for (std::size_t i = 0; i < size; ++i) {
    speed = kind_ == Kind::LimitedAccel
                ? angular
                : projectVelocity(speed, p.accLimTheta, p.decelLimTheta, dt, angular);
    heading += speed * dt;
    headings_[i + 1] = heading;
    fresh.steps[i].heading = heading;
  }
  base::sinCosArray(headings_.data(), directions_.data(), size + 1);
  for (std::size_t i = 0; i < size; ++i) {
    fresh.steps[i].direction = {directions_[i].cos, directions_[i].sin};
  }
  fresh.endDirection = {directions_[size].cos, directions_[size].sin};
  return fresh;
}

void TrajectoryGenerator::generate(const BodyTwist& command, DwbTrajectory& trajectory) {
  const DwbParameters& p = *parameters_;
  const int count = stepCount(p, command);
  const double dt = p.simTime / count;
  const HeadingProfile& profile = headingProfile(command.angular, count);
  const std::vector<Step>& turned = profile.steps;
  trajectory.step = dt;
  trajectory.poses.resize(turned.size() + (p.includesLastPoint ? 2 : 1));
  trajectory.velocity = p.limitsCommand ? next(speed_, command, dt) : command;
  Pose2* pose = trajectory.poses.data();
  *pose = robot_;
  Vec2 place = robot_.position;
  const auto advance = [&](const Step& step, double x, double y) {
    const Vec2 along = x * step.direction;
    place +=
        dt * (y == 0.0 ? along : Vec2(along + y * Vec2(-step.direction.y(), step.direction.x())));
    *++pose = {place, step.heading};
  };
  auto step = turned.begin();
  if (kind_ == Kind::Standard) {
    double x = speed_.linear, y = speed_.lateral;
    // A velocity that has reached the command stays constant, unless braking accelerates.
    const bool isRamp = p.decelLimX > 0.0 || p.decelLimY > 0.0;
    while (step != turned.end() && (isRamp || x != command.linear || y != command.lateral)) {
      x = projectVelocity(x, p.accLimX, p.decelLimX, dt, command.linear);
      y = projectVelocity(y, p.accLimY, p.decelLimY, dt, command.lateral);
      advance(*step++, x, y);
    }
  }
  for (; step != turned.end(); ++step) {
    advance(*step, command.linear, command.lateral);
  }
  trajectory.poses.back() = *pose;
  trajectory.endDirection = profile.endDirection;
  trajectory.endCell = CellIndex(*costmap_)(place);
}

void TrajectoryGenerator::locate(DwbTrajectory& trajectory) const {
  const CellIndex indexOf(*costmap_);
  trajectory.cells.resize(trajectory.poses.size());
  std::transform(trajectory.poses.begin(), trajectory.poses.end(), trajectory.cells.begin(),
                 [&](const Pose2& pose) { return indexOf(pose.position); });
  const auto off = std::find(trajectory.cells.begin(), trajectory.cells.end(), -1);
  trajectory.onMap = static_cast<std::size_t>(off - trajectory.cells.begin());
}

namespace {

constexpr double kSampleEpsilon = 1e-5;

bool isValidSpeed(const DwbParameters& p, const BodyTwist& twist) {
  const double squared = twist.linear * twist.linear + twist.lateral * twist.lateral;
  if (p.maxSpeedXy >= 0.0 && squared > p.maxSpeedXy * p.maxSpeedXy) {
    return false;
  }
  const bool isSlow = p.minSpeedXy >= 0.0 && squared < p.minSpeedXy * p.minSpeedXy;
  const bool turnsSlowly = p.minSpeedTheta >= 0.0 && std::abs(twist.angular) < p.minSpeedTheta;
  return !(isSlow && turnsSlowly) && !(squared == 0.0 && twist.angular == 0.0);
}

}  // namespace

double projectVelocity(double v, double acceleration, double deceleration, double dt,
                       double target) {
  return v < target ? std::min(target, v + acceleration * dt)
                    : std::max(target, v + deceleration * dt);
}

std::vector<double> axisSamples(const VelocityAxis& axis, double v, double time, int count) {
  // Like std::clamp, but defined if the bounds are swapped.
  const double now = v < axis.least ? axis.least : std::min(v, axis.most);
  const double hi = projectVelocity(now, axis.acceleration, axis.deceleration, time, axis.most);
  const double lo = projectVelocity(now, axis.acceleration, axis.deceleration, time, axis.least);
  double increment = 1.0;
  if (std::abs(hi - lo) >= kSampleEpsilon) {
    increment = (hi - lo) / (std::max(2, count) - 1);
  }
  // An increment below the rounding error of large velocities would not end the loop.
  const auto most = static_cast<std::size_t>(std::max(2, count)) + 2;
  std::vector<double> samples;
  for (double value = lo; !(value > hi + kSampleEpsilon) && samples.size() < most;
       value += increment) {
    samples.push_back(value);
    const double next = value + increment;
    if (value < 0.0 && next > 0.0 && next <= hi + kSampleEpsilon) {
      samples.push_back(0.0);
    }
    if (!(increment > 0.0)) {
      break;  // the bounds are swapped
    }
  }
  return samples;
}

VelocityAxis axisX(const DwbParameters& p) {
  return {p.minVelX, p.maxVelX, p.accLimX, p.decelLimX};
}

VelocityAxis axisY(const DwbParameters& p) {
  return {p.minVelY, p.maxVelY, p.accLimY, p.decelLimY};
}

VelocityAxis axisTheta(const DwbParameters& p) {
  return {-p.maxVelTheta, p.maxVelTheta, p.accLimTheta, p.decelLimTheta};
}

void velocitySamples(const DwbParameters& p, const BodyTwist& now, double time,
                     std::vector<BodyTwist>& samples) {
  const std::vector<double> xs = axisSamples(axisX(p), now.linear, time, p.vxSamples);
  const std::vector<double> ys = axisSamples(axisY(p), now.lateral, time, p.vySamples);
  const std::vector<double> thetas = axisSamples(axisTheta(p), now.angular, time, p.vthetaSamples);
  samples.clear();
  samples.reserve(xs.size() * ys.size() * thetas.size());
  for (const double x : xs) {
    for (const double y : ys) {
      for (const double theta : thetas) {
        const BodyTwist twist{x, theta, y};
        if (isValidSpeed(p, twist)) {
          samples.push_back(twist);
        }
      }
    }
  }
}

}  // namespace sim2d::nav2
