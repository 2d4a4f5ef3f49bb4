#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "tests/nav/Nav2MppiScenes.h"

/// Nav2's MPPI as plain loops in double precision, straight from its description: what the
/// optimiser must agree with to rounding, and what it is measured against. It shares parameters,
/// scene and noise with it, and no code.
namespace nav2reference {

using namespace nav2test;
using Speeds = std::array<double, 3>;  // vx, wz, vy

struct Trajectory {
  std::vector<Speeds> controls, speeds;
  std::vector<Pose2> poses;
  double cost = 0.0, length = 0.0;
  bool hits = false;
};

inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

inline double gap(const Vec2& a, const Vec2& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

class Reference {
 public:
  Reference(const MppiConfiguration& mppi, double period)
      : mppi_(mppi), set_(mppi.settings), period_(period) {
    isShifting_ = std::fabs(period - set_.modelDt) < 1e-6;
    sequence_.assign(static_cast<std::size_t>(set_.timeSteps), Speeds{});
  }

  /// One cycle with one iteration; `noise(sample, step, axis)`. The command.
  template <class Noise>
  Speeds cycle(const HandScene& scene, const Noise& noise) {
    scene_ = &scene;
    setSpeed();
    if (mppi_.distro >= Distro::Lyrical) {
      for (std::size_t a = 0; a < 3; ++a) {
        sequence_[0][a] = isShifting_ ? speed_[a] : reach(sequence_[0][a], speed_[a], a, period_);
      }
    }
    trajectories_.assign(static_cast<std::size_t>(set_.batchSize), {});
    for (std::size_t k = 0; k < trajectories_.size(); ++k) {
      roll(trajectories_[k],
           [&](int step, int axis) { return noise(static_cast<int>(k), step, axis); });
    }
    findFurthest();
    price();
    update();
    return send();
  }

  const std::vector<Trajectory>& trajectories() const { return trajectories_; }
  const std::vector<Speeds>& sequence() const { return sequence_; }  // shifted
  std::size_t furthest() const { return furthest_; }

 private:
  int axes() const { return mppi_.motion == MppiMotion::Omni ? 3 : 2; }

  double reach(double wanted, double now, std::size_t axis, double dt) const {
    const double most = std::array<double, 3>{set_.axMax, set_.azMax, set_.ayMax}[axis] * dt;
    const double least = std::array<double, 3>{set_.axMin, -set_.azMax, set_.ayMin}[axis] * dt;
    return now > 0.0 ? std::min(std::max(wanted, now + least), now + most)
                     : std::min(std::max(wanted, now - most), now - least);
  }

  void setSpeed() {
    const sim2d::BodyTwist& measured = scene_->speed;
    const Speeds now = {measured.linear, measured.angular, axes() == 3 ? measured.lateral : 0.0};
    speed_ = now;
    if (set_.isOpenLoop && mppi_.distro != Distro::Humble) {
      speed_ = last_;
    } else if (mppi_.distro >= Distro::Lyrical) {
      for (std::size_t a = 0; a < 3; ++a) {
        speed_[a] = reach(last_[a], now[a], a, period_);
      }
    }
  }

  template <class Noise>
  void roll(Trajectory& way, const Noise& noise) {
    const auto steps = static_cast<std::size_t>(set_.timeSteps);
    way.controls = sequence_;
    way.speeds.assign(steps, speed_);
    for (std::size_t i = 0; i < steps; ++i) {
      for (int a = 0; a < axes(); ++a) {
        way.controls[i][static_cast<std::size_t>(a)] += noise(static_cast<int>(i), a);
      }
    }
    const bool isMain = mppi_.distro >= Distro::Lyrical;
    for (std::size_t i = 1; i < steps; ++i) {
      for (std::size_t a = 0; a < static_cast<std::size_t>(axes()); ++a) {
        double control = way.controls[i - 1][a];
        if (mppi_.distro != Distro::Humble) {
          control = reach(control, way.speeds[i - 1][a], a, set_.modelDt);
        }
        way.speeds[i][a] = control;
        if ((mppi_.distro == Distro::Jazzy || mppi_.distro == Distro::Kilted) ||
            (isMain && set_.clampsRawControls)) {
          way.controls[i - 1][a] = control;
        }
      }
    }
    Pose2 pose = scene_->robot;
    for (const Speeds& v : way.speeds) {
      const double c = std::cos(pose.heading);
      const double s = std::sin(pose.heading);
      pose.position += set_.modelDt * Vec2(v[0] * c - v[2] * s, v[0] * s + v[2] * c);
      pose.heading += v[1] * set_.modelDt;
      way.length += set_.modelDt * std::hypot(v[0], v[2]);
      way.poses.push_back(pose);
    }
  }

  void findFurthest() {
    const Path& path = scene_->path;
    furthest_ = 0;
    for (const Trajectory& way : trajectories_) {
      std::size_t best = 0;
      double along = 0.0;
      for (std::size_t i = 0; i < path.size(); ++i) {
        along += i == 0 ? 0.0 : gap(path[i].position, path[i - 1].position);
        if (mppi_.distro >= Distro::Lyrical && along > way.length + 1e-3) {
          break;
        }
        if (gap(path[i].position, way.poses.back().position) <
            gap(path[best].position, way.poses.back().position)) {
          best = i;
        }
      }
      furthest_ = std::max(furthest_, best);
    }
  }

  bool isNear(double threshold) const {
    const Path& path = scene_->path;
    if (mppi_.distro >= Distro::Lyrical) {
      double length = 0.0;
      for (std::size_t i = 1; i < path.size(); ++i) {
        length += gap(path[i].position, path[i - 1].position);
      }
      return length < threshold;
    }
    const Pose2& end = mppi_.distro == Distro::Humble ? path.back() : scene_->goal;
    return gap(end.position, scene_->robot.position) < threshold;
  }

  double cellCost(const Vec2& place) const {
    const auto cell = scene_->costmap.worldToCell(place);
    return cell ? scene_->costmap.at(*cell) : 255.0;
  }
  bool isValid(std::size_t point) const {
    const Vec2& place = scene_->path[point].position;
    const double cost = cellCost(place);
    return scene_->costmap.worldToCell(place).has_value() &&
           (cost < 253.0 || (cost == 255.0 && scene_->shape.tracksUnknown));
  }

  void price() {
    for (const std::string& name : set_.critics) {
      if (name == "ObstaclesCritic") {
        priceObstacles();
        continue;
      }
      for (Trajectory& way : trajectories_) {
        way.cost += priceOf(name, way);
      }
    }
  }

  /// By the centre's cost, of every pose.
  void priceObstacles() {
    const ObstaclesSettings& c = mppi_.critics.obstacles;
    const bool isHumble = mppi_.distro == Distro::Humble;
    const double scaling = isHumble ? c.costScaling : scene_->shape.costScaling;
    const double radius = isHumble ? c.inflationRadius : scene_->shape.inflationRadius;
    std::vector<double> margins, repulsions;
    for (Trajectory& way : trajectories_) {
      double margin = 0.0, repulsion = 0.0;
      for (const Pose2& pose : way.poses) {
        const double cost = cellCost(pose.position);
        if (cost < 1.0) {
          continue;
        }
        way.hits =
            cost == 253.0 || cost == 254.0 || (cost == 255.0 && !scene_->shape.tracksUnknown);
        if (way.hits) {
          break;
        }
        const double distance = -std::log(cost / 253.0) / scaling;
        margin += std::max(0.0, c.marginDistance - distance);
        const bool isRepelled = !isHumble || distance >= c.marginDistance;
        repulsion += isRepelled && !isNear(c.nearGoalDistance) ? radius - distance : 0.0;
      }
      margins.push_back(way.hits ? c.collisionCost : margin);
      repulsions.push_back(repulsion);
    }
    const double least = isHumble ? 0.0 : *std::min_element(repulsions.begin(), repulsions.end());
    for (std::size_t i = 0; i < trajectories_.size(); ++i) {
      trajectories_[i].cost +=
          std::pow(c.criticalWeight * margins[i] + c.repulsionWeight * (repulsions[i] - least) /
                                                       static_cast<double>(set_.timeSteps),
                   c.power);
    }
  }

  double twirling(const Trajectory& way) const {
    double sum = 0.0;
    for (const Speeds& v : way.speeds) {
      sum += std::fabs(v[1]);
    }
    return sum / static_cast<double>(way.speeds.size());
  }

  double deadband(const Trajectory& way) const {
    const std::vector<double>& bands = mppi_.critics.deadband.velocities;  // vx, vy, wz
    double sum = 0.0;
    for (const Speeds& v : way.speeds) {
      sum += std::max(0.0, bands[0] - std::fabs(v[0])) + std::max(0.0, bands[2] - std::fabs(v[1]));
      sum += axes() == 3 ? std::max(0.0, bands[1] - std::fabs(v[2])) : 0.0;
    }
    return sum * set_.modelDt;
  }

  double priceOf(const std::string& name, Trajectory& way) const {
    const MppiCriticSettings& c = mppi_.critics;
    const auto powered = [](const CommonCriticSettings& s, double raw) {
      return std::pow(s.weight * raw, s.power);
    };
    if (name == "ConstraintCritic") {
      return powered(c.constraint, constraint(way));
    }
    if (name == "CostCritic") {
      return std::pow(c.cost.weight / 254.0 * cost(way), c.cost.power);
    }
    if (name == "TwirlingCritic") {
      const Pose2& end = mppi_.distro == Distro::Humble ? scene_->path.back() : scene_->goal;
      const bool isThere = gap(end.position, scene_->robot.position) < scene_->xyGoalTolerance;
      return isThere ? 0.0 : powered(c.twirling, twirling(way));
    }
    if (name == "VelocityDeadbandCritic") {
      return powered(c.deadband, deadband(way));
    }
    if (name == "GoalCritic" && isNear(c.goal.threshold)) {
      return powered(c.goal, goal(way));
    }
    if (name == "GoalAngleCritic" && isNear(c.goalAngle.threshold)) {
      return powered(c.goalAngle, goalAngle(way));
    }
    if (name == "PathAlignCritic" && !isNear(c.pathAlign.threshold) && alignCounts()) {
      return powered(c.pathAlign, align(way));
    }
    if (name == "PathFollowCritic" && !isNear(c.pathFollow.threshold)) {
      return powered(c.pathFollow, follow(way));
    }
    if (name == "PathAngleCritic" && !isNear(c.pathAngle.threshold)) {
      return powered(c.pathAngle, angle(way));
    }
    if (name == "PreferForwardCritic" && !isNear(c.preferForward.threshold)) {
      return powered(c.preferForward, back(way));
    }
    return 0.0;
  }

  double constraint(const Trajectory& way) const {
    double sum = 0.0;
    for (const Speeds& v : way.speeds) {
      double low = set_.vxMin;
      double high = set_.vxMax;
      double speed = v[0];
      if (mppi_.distro < Distro::Lyrical) {
        low = -std::hypot(low, set_.vyMax);
        high = std::hypot(high, set_.vyMax);
      }
      if (mppi_.motion == MppiMotion::Omni && mppi_.distro < Distro::Lyrical) {
        speed = (v[0] > 0.0 ? 1.0 : -1.0) * std::hypot(v[0], v[2]);
      }
      sum += std::max(0.0, speed - high) + std::max(0.0, low - speed);
      if (mppi_.motion == MppiMotion::Omni && mppi_.distro >= Distro::Lyrical) {
        sum += std::max(0.0, std::fabs(v[2]) - set_.vyMax);
      }
      if (mppi_.motion == MppiMotion::Ackermann) {
        sum += std::max(0.0,
                        set_.minTurningRadius - std::fabs(v[0]) / std::max(std::fabs(v[1]), 1e-6));
      }
    }
    return sum * set_.modelDt;
  }

  double cost(Trajectory& way) const {
    const CostSettings& c = mppi_.critics.cost;
    const bool isNearGoal = isNear(c.nearGoalDistance);
    double sum = 0.0;
    double count = 0.0;
    const auto stride = static_cast<std::size_t>(c.pointStep);
    const std::size_t end =
        way.poses.size() -
        (mppi_.distro == Distro::Jazzy ? way.poses.size() % stride : std::size_t{0});
    for (std::size_t i = 0; i < end; i += stride) {
      count += 1.0;
      const double value = cellCost(way.poses[i].position);
      const bool isUnknownFree = scene_->shape.tracksUnknown && value == 255.0;
      way.hits = way.hits || (value >= 253.0 && !isUnknownFree);
      if (value >= c.nearCollisionCost) {
        sum += c.criticalCost;
      } else if (!isNearGoal) {
        sum += value;
      }
    }
    return (way.hits ? c.collisionCost : sum) / count;
  }

  double goal(const Trajectory& way) const {
    double sum = 0.0;
    for (const Pose2& pose : way.poses) {
      sum += gap(pose.position, scene_->path.back().position);
    }
    return sum / static_cast<double>(way.poses.size());
  }

  double goalAngle(const Trajectory& way) const {
    const bool isHumble = mppi_.distro == Distro::Humble;
    const double yaw = isHumble ? scene_->path.back().heading : scene_->goal.heading;
    double sum = 0.0;
    for (const Pose2& pose : way.poses) {
      sum += std::fabs(wrapped(yaw - pose.heading));
    }
    return sum / static_cast<double>(way.poses.size());
  }

  bool alignCounts() const {
    const PathAlignSettings& c = mppi_.critics.pathAlign;
    double blocked = 0.0;
    for (std::size_t i = 0; i < furthest_; ++i) {
      blocked += isValid(i) ? 0.0 : 1.0;
    }
    const bool isBlocked =
        blocked > 2.0 && blocked / static_cast<double>(furthest_) > c.maxPathOccupancyRatio;
    return furthest_ >= static_cast<std::size_t>(c.offsetFromFurthest) && !isBlocked;
  }

  double align(const Trajectory& way) const {
    const auto step = static_cast<std::size_t>(mppi_.critics.pathAlign.pointStep);
    const Path& path = scene_->path;
    std::vector<double> along = {0.0};
    for (std::size_t i = 1; i < furthest_; ++i) {
      along.push_back(along.back() + gap(path[i].position, path[i - 1].position));
    }
    double driven = 0.0;
    double sum = 0.0;
    double count = 0.0;
    std::size_t at = 0;
    for (std::size_t i = step; i < way.poses.size(); i += step) {
      driven += gap(way.poses[i].position, way.poses[i - step].position);
      for (std::size_t j = at; j < furthest_; ++j) {  // onwards; the later of two equally near
        if (std::fabs(along[j] - driven) <= std::fabs(along[at] - driven)) {
          at = j;
        }
      }
      if (isValid(at)) {
        const double turn = mppi_.critics.pathAlign.usesOrientations
                                ? wrapped(path[at].heading - way.poses[i].heading)
                                : 0.0;
        sum += std::hypot(gap(path[at].position, way.poses[i].position), turn);
        count += 1.0;
      }
    }
    return count > 0.0 ? sum / count : 0.0;
  }

  double follow(const Trajectory& way) const {
    const std::size_t last = scene_->path.size() - 1;
    std::size_t at = std::min(
        furthest_ + static_cast<std::size_t>(mppi_.critics.pathFollow.offsetFromFurthest), last);
    while (at + 1 < last && !isValid(at)) {
      ++at;
    }
    return gap(scene_->path[at].position, way.poses.back().position);
  }

  static double angleTo(const Pose2& pose, const Vec2& place) {
    const Vec2 way = place - pose.position;
    return std::fabs(wrapped(std::atan2(way.y(), way.x()) - pose.heading));
  }
  double angle(const Trajectory& way) const {
    const PathAngleSettings& c = mppi_.critics.pathAngle;
    const std::size_t at = std::min(furthest_ + static_cast<std::size_t>(c.offsetFromFurthest),
                                    scene_->path.size() - 1);
    const Vec2& place = scene_->path[at].position;
    if (angleTo(scene_->robot, place) < c.maxAngleToFurthest) {
      return 0.0;
    }
    if (mppi_.distro != Distro::Humble) {
      return angleTo(way.poses.back(), place);
    }
    double sum = 0.0;
    for (const Pose2& pose : way.poses) {
      sum += angleTo(pose, place);
    }
    return sum / static_cast<double>(way.poses.size());
  }

  double back(const Trajectory& way) const {
    double sum = 0.0;
    for (const Speeds& v : way.speeds) {
      sum += std::max(0.0, -v[0]);
    }
    return sum * set_.modelDt;
  }

  void update() {
    const Speeds deviations = {set_.vxStd, set_.wzStd, set_.vyStd};
    for (Trajectory& way : trajectories_) {
      for (std::size_t a = 0; a < static_cast<std::size_t>(axes()); ++a) {
        double sum = 0.0;
        for (std::size_t i = 0; i < sequence_.size(); ++i) {
          sum += sequence_[i][a] * (way.controls[i][a] - sequence_[i][a]);
        }
        way.cost += set_.gamma / (deviations[a] * deviations[a]) * sum;
      }
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Trajectory& way : trajectories_) {
      least = std::min(least, way.cost);
    }
    double total = 0.0;
    std::vector<Speeds> mean(sequence_.size(), Speeds{});
    for (const Trajectory& way : trajectories_) {
      const double weight = std::exp(-(way.cost - least) / set_.temperature);
      total += weight;
      for (std::size_t i = 0; i < mean.size(); ++i) {
        for (std::size_t a = 0; a < static_cast<std::size_t>(axes()); ++a) {
          mean[i][a] += weight * way.controls[i][a];
        }
      }
    }
    for (Speeds& v : mean) {
      for (double& value : v) {
        value /= total;
      }
    }
    sequence_ = mean;
    if (mppi_.distro >= Distro::Lyrical) {
      filter();
      turnLimit();
      limit(true);
    } else {
      limit(false);
    }
    turnLimit();
  }

  void turnLimit() {
    if (mppi_.motion == MppiMotion::Ackermann) {
      for (Speeds& v : sequence_) {
        const double most = std::fabs(v[0]) / set_.minTurningRadius;
        v[1] = std::min(std::max(v[1], -most), most);
      }
    }
  }

  void limit(bool fromSpeed) {
    const Speeds low = {set_.vxMin, -set_.wzMax, -set_.vyMax};
    const Speeds high = {set_.vxMax, set_.wzMax, set_.vyMax};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t i = 0; i < sequence_.size(); ++i) {
        double& value = sequence_[i][a];
        value = std::min(std::max(value, low[a]), high[a]);
        if (i > 0 && mppi_.distro != Distro::Humble) {
          value = reach(value, sequence_[i - 1][a], a, set_.modelDt);
        } else if (i == 0 && fromSpeed) {
          value = isShifting_ ? speed_[a] : reach(value, speed_[a], a, period_);
        }
      }
    }
  }

  void filter() {
    constexpr double kTaps[] = {-21, 14, 39, 54, 59, 54, 39, 14, -21};
    if (sequence_.size() < 21) {
      return;
    }
    const std::vector<Speeds> raw = sequence_;
    const auto size = static_cast<int>(raw.size());
    for (int i = 0; i + 1 < size; ++i) {
      for (std::size_t a = 0; a < 3; ++a) {
        double sum = 0.0;
        for (int tap = -4; tap <= 4; ++tap) {
          const int at = i + tap;
          const double value = at < 0 ? sent_[static_cast<std::size_t>(4 + at)][a]
                                      : raw[static_cast<std::size_t>(std::min(at, size - 1))][a];
          sum += kTaps[tap + 4] * value / 231.0;
        }
        sequence_[static_cast<std::size_t>(i)][a] = sum;
      }
    }
    sent_ = {sent_[1], sent_[2], sent_[3], sequence_[isShifting_ ? 1 : 0]};
  }

  Speeds send() {
    if (mppi_.distro < Distro::Lyrical) {
      filter();
    }
    last_ = sequence_[isShifting_ ? 1 : 0];
    if (isShifting_) {
      sequence_.erase(sequence_.begin());
      sequence_.push_back(sequence_.back());
    }
    return last_;
  }

  MppiConfiguration mppi_;
  const MppiSettings& set_;
  double period_;
  bool isShifting_ = false;
  const HandScene* scene_ = nullptr;
  std::vector<Speeds> sequence_;
  std::array<Speeds, 4> sent_{};
  Speeds speed_{}, last_{};
  std::vector<Trajectory> trajectories_;
  std::size_t furthest_ = 0;
};

}  // namespace nav2reference
