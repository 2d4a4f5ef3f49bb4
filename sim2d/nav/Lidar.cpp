#include "sim2d/nav/Lidar.h"

#include <cstddef>
#include <utility>

namespace sim2d {

Lidar::Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor)
    : parameters_(parameters),
      seed_(seed),
      gait_(seed),
      caster_(std::make_shared<LidarCaster>(parameters, robotId, sensor)),
      walls_(std::make_shared<std::vector<Segment>>()) {}

bool Lidar::update(const SensedWorld& world, ScanUse use) {
  if (parameters_.legs) {
    gait_.update(world.bodies);
  }
  const std::int64_t number = eventAt(world.time, parameters_.rate);
  const bool isDue = number > number_;
  if (isDue) {
    number_ = number;
    laterTurn_.reset();
  }
  if (isDue && use == ScanUse::Now) {
    take(world, turn_);
    caster_->cast(turn_, scan_);
  } else if (isDue && use == ScanUse::Later) {
    const auto turn = std::make_shared<LidarTurn>();
    take(world, *turn);
    laterTurn_ = turn;
    areWallsShared_ = true;
  } else if (use == ScanUse::Now && laterTurn_ != nullptr) {
    caster_->cast(*laterTurn_, scan_);
    laterTurn_.reset();
  }
  return isDue && use == ScanUse::Now;
}

void Lidar::take(const SensedWorld& world, LidarTurn& turn) {
  const Pose2& mount = parameters_.mount;
  turn.number = number_;
  turn.seed = seed_;
  turn.time = world.time;
  turn.sensor.position = world.odometry.toWorld(mount.position);
  turn.sensor.heading = base::wrapToPi(world.odometry.heading + mount.heading);
  turn.mapToOdom = world.mapToOdom;
  turn.origin = world.pose.toWorld(mount.position);
  turn.ahead = base::directionOf(world.pose.heading + mount.heading + parameters_.angleMin);
  turn.isInsideObstacle = world.obstacles.isInside(turn.origin);
  if (!turn.isInsideObstacle) {
    gatherWalls(world.obstacles, turn.origin);
  }
  turn.walls = walls_;
  turn.bodies = world.bodies;
  turn.strides.resize(parameters_.legs ? turn.bodies.size() : 0);
  for (std::size_t i = 0; i < turn.strides.size(); ++i) {
    turn.strides[i] = gait_.strideOf(i);
  }
}

/// Finding walls costs more than seeing them, so those found last time serve until others may have
/// come into range. Turns that are still to be looked at keep theirs.
void Lidar::gatherWalls(const Obstacles& obstacles, const Vec2& from) {
  const auto parts = static_cast<std::size_t>(obstacles.partCount());
  bool isUpToDate = wallParts_.size() == parts && (from - wallsFrom_).norm() <= kWallMargin;
  for (std::size_t i = 0; i < parts && isUpToDate; ++i) {
    isUpToDate = (wallParts_[i] != 0) == obstacles.isEnabled(static_cast<int>(i));
  }
  if (isUpToDate) {
    return;
  }
  wallsFrom_ = from;
  wallParts_.resize(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    wallParts_[i] = obstacles.isEnabled(static_cast<int>(i)) ? 1 : 0;
  }
  if (std::exchange(areWallsShared_, false)) {
    walls_ = std::make_shared<std::vector<Segment>>();
  }
  walls_->clear();
  obstacles.segmentsNear(from, parameters_.range + kWallMargin, *walls_);
}

}  // namespace sim2d
