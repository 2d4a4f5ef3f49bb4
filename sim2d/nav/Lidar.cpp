#include "sim2d/nav/Lidar.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/Rng.h"

namespace sim2d {
namespace {

constexpr double kFullScan = 2.0 * base::kPi;

/// [rad]; of a single beam a turn.
double angleBetweenBeams(const LidarParameters& parameters) {
  const double span = parameters.angleMax - parameters.angleMin;
  assert(parameters.beams >= 1 && span > 0.0 && span <= kFullScan + 1e-9);
  if (span > kFullScan - 1e-9 || parameters.beams == 1) {
    return kFullScan / parameters.beams;
  }
  return span / (parameters.beams - 1);
}

}  // namespace

bool isPossible(const LidarParameters& parameters) {
  const double span = parameters.angleMax - parameters.angleMin;
  return parameters.beams >= 1 && span > 0.0 && span <= kFullScan + 1e-9 &&
         angleBetweenBeams(parameters) >= 1e-4 && parameters.range > 0.0 && parameters.rate > 0.0 &&
         parameters.noise >= 0.0;
}

Lidar::Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor)
    : parameters_(parameters),
      seed_(seed),
      robotId_(robotId),
      sensor_(sensor),
      gait_(seed),
      raster_(parameters.beams, angleBetweenBeams(parameters), parameters.range) {
  assert(isPossible(parameters) && sensor >= 0 && sensor < 1024);
  scan_.angleMin = parameters.angleMin;
  scan_.perBeam = angleBetweenBeams(parameters);
  scan_.range = parameters.range;
}

bool Lidar::update(const SensedWorld& world, bool isRead) {
  if (parameters_.legs) {
    gait_.update(world.bodies);
  }
  const std::int64_t turn = eventAt(world.time, parameters_.rate);
  if (turn <= turn_) {
    return false;
  }
  turn_ = turn;
  if (isRead) {
    makeTurn(world);
  }
  return isRead;
}

void Lidar::makeTurn(const SensedWorld& world) {
  const Pose2& mount = parameters_.mount;
  scan_.time = world.time;
  scan_.sensor.position = world.odometry.toWorld(mount.position);
  scan_.sensor.heading = base::wrapToPi(world.odometry.heading + mount.heading);
  const double firstBeam = world.pose.heading + mount.heading + parameters_.angleMin;
  const BeamFrame frame{world.pose.toWorld(mount.position), base::directionOf(firstBeam)};
  raster_.clear();
  if (world.obstacles.isInside(frame.origin)) {
    raster_.block();
  } else {
    gatherWalls(world.obstacles, frame.origin);
    addWalls(frame);
    addBodies(world.bodies, frame);
  }
  raster_.writeDistances(scan_.distances);
  addNoise();
}

/// Finding walls costs more than seeing them, so those found last time serve until others may have
/// come into range.
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
  walls_.clear();
  obstacles.segmentsNear(from, parameters_.range + kWallMargin, walls_);
}

void Lidar::addWalls(const BeamFrame& frame) {
  for (const Segment& wall : walls_) {
    raster_.addEdge(frame.toFrame(wall.a), frame.toFrame(wall.b));
  }
}

void Lidar::addBodies(const std::vector<SensedBody>& bodies, const BeamFrame& frame) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SensedBody& body = bodies[i];
    if (body.kind == BodyKind::Person) {
      addPerson(body, parameters_.legs ? gait_.strideOf(i) : 0.0, frame);
    } else if (body.id != robotId_) {
      if (body.footprint != nullptr && !body.footprint->isDisc()) {
        addPolygon(body, frame);
      } else {
        raster_.addCircle(frame.toFrame(body.position), body.radius);
      }
    }
  }
}

/// Nearer shapes have mostly been added before, so that many a person need not be looked at
/// closely.
void Lidar::addPerson(const SensedBody& person, double stride, const BeamFrame& frame) {
  const Vec2 centre = frame.toFrame(person.position);
  const double distance = centre.norm();
  if (distance - person.radius > parameters_.range) {
    return;
  }
  const LidarRaster::Beams beams = raster_.beamsOf(centre, person.radius);
  if (distance > person.radius && raster_.areCovered(beams, distance - person.radius)) {
    return;
  }
  if (!parameters_.legs) {
    raster_.addCircle(centre, person.radius, beams);
    return;
  }
  const Legs legs = legsOf(person, stride);
  raster_.addCircle(frame.toFrame(legs.left), legs.radius, beams);
  raster_.addCircle(frame.toFrame(legs.right), legs.radius, beams);
}

void Lidar::addPolygon(const SensedBody& robot, const BeamFrame& frame) {
  const std::vector<Vec2>& corners = robot.footprint->corners;
  const Pose2 pose = robot.pose();
  if (isInside(corners, pose.toLocal(frame.origin))) {
    raster_.block();
    return;
  }
  Vec2 from = frame.toFrame(pose.toWorld(corners.back()));
  for (const Vec2& corner : corners) {
    const Vec2 to = frame.toFrame(pose.toWorld(corner));
    raster_.addEdge(from, to);
    from = to;
  }
}

void Lidar::addNoise() {
  if (parameters_.noise <= 0.0) {
    return;
  }
  const base::AgentRng rng(seed_, robotId_, static_cast<std::uint64_t>(turn_));
  const std::uint32_t first = static_cast<std::uint32_t>(sensor_) << 20U;
  const auto isHit = [this](double distance) {
    return distance > 0.0 && distance < parameters_.range;
  };
  std::vector<double>& distances = scan_.distances;
  for (std::size_t i = 0; i < distances.size(); i += 2) {  // one draw gives two errors
    const std::size_t end = std::min(i + 2, distances.size());
    if (std::none_of(&distances[i], distances.data() + end, isHit)) {
      continue;
    }
    const std::array<double, 2> errors =
        rng.normalPair(base::Draw::Lidar, first + static_cast<std::uint32_t>(i / 2));
    for (std::size_t k = i; k < end; ++k) {
      if (isHit(distances[k])) {
        const double measured = distances[k] + parameters_.noise * errors[k - i];
        distances[k] = std::clamp(measured, 0.0, parameters_.range);
      }
    }
  }
}

}  // namespace sim2d
