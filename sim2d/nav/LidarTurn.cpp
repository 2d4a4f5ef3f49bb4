#include "sim2d/nav/LidarTurn.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "sim2d/base/Rng.h"
#include "sim2d/nav/LegGait.h"

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

/// Into the frame of the beams: origin in the sensor, x along the first of them.
Vec2 toBeams(const LidarTurn& turn, const Vec2& place) {
  const Vec2 offset = place - turn.origin;
  return {turn.ahead.dot(offset), base::cross(turn.ahead, offset)};
}

}  // namespace

bool isPossible(const LidarParameters& parameters) {
  const double span = parameters.angleMax - parameters.angleMin;
  return parameters.beams >= 1 && span > 0.0 && span <= kFullScan + 1e-9 &&
         angleBetweenBeams(parameters) >= 1e-4 && parameters.range > 0.0 && parameters.rate > 0.0 &&
         parameters.noise >= 0.0;
}

LidarCaster::LidarCaster(const LidarParameters& parameters, int robotId, int sensor)
    : parameters_(parameters),
      robotId_(robotId),
      sensor_(sensor),
      raster_(parameters.beams, angleBetweenBeams(parameters), parameters.range) {
  assert(isPossible(parameters) && sensor >= 0 && sensor < 1024);
}

void LidarCaster::cast(const LidarTurn& turn, LaserScan& scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scan.sensor = turn.sensor;
  scan.mapToOdom = turn.mapToOdom;
  scan.time = turn.time;
  scan.angleMin = parameters_.angleMin;
  scan.perBeam = angleBetweenBeams(parameters_);
  scan.range = parameters_.range;
  raster_.clear();
  if (turn.isInsideObstacle) {
    raster_.block();
  } else {
    for (const Segment& wall : *turn.walls) {
      raster_.addEdge(toBeams(turn, wall.a), toBeams(turn, wall.b));
    }
    addBodies(turn);
  }
  raster_.writeDistances(scan.distances);
  addNoise(turn, scan.distances);
}

void LidarCaster::addBodies(const LidarTurn& turn) {
  for (std::size_t i = 0; i < turn.bodies.size(); ++i) {
    const SensedBody& body = turn.bodies[i];
    if (body.kind == BodyKind::Person) {
      addPerson(turn, i);
    } else if (body.id != robotId_) {
      if (body.footprint != nullptr && !body.footprint->isDisc()) {
        addPolygon(turn, body);
      } else {
        raster_.addCircle(toBeams(turn, body.position), body.radius);
      }
    }
  }
}

/// Nearer shapes have mostly been added before, so that many a person need not be looked at
/// closely.
void LidarCaster::addPerson(const LidarTurn& turn, std::size_t number) {
  const SensedBody& person = turn.bodies[number];
  const Vec2 centre = toBeams(turn, person.position);
  const double distance = centre.norm();
  if (distance - person.radius > parameters_.range) {
    return;
  }
  const LidarRaster::Beams beams = raster_.beamsOf(centre, person.radius);
  if (distance > person.radius && raster_.areCovered(beams, distance - person.radius)) {
    return;
  }
  if (turn.strides.empty()) {
    raster_.addCircle(centre, person.radius, beams);
    return;
  }
  const Legs legs = legsOf(person, turn.strides[number]);
  raster_.addCircle(toBeams(turn, legs.left), legs.radius, beams);
  raster_.addCircle(toBeams(turn, legs.right), legs.radius, beams);
}

void LidarCaster::addPolygon(const LidarTurn& turn, const SensedBody& robot) {
  const std::vector<Vec2>& corners = robot.footprint->corners;
  const Pose2 pose = robot.pose();
  if (isInside(corners, pose.toLocal(turn.origin))) {
    raster_.block();
    return;
  }
  Vec2 from = toBeams(turn, pose.toWorld(corners.back()));
  for (const Vec2& corner : corners) {
    const Vec2 to = toBeams(turn, pose.toWorld(corner));
    raster_.addEdge(from, to);
    from = to;
  }
}

void LidarCaster::addNoise(const LidarTurn& turn, std::vector<double>& distances) const {
  if (parameters_.noise <= 0.0) {
    return;
  }
  const base::AgentRng rng(turn.seed, robotId_, static_cast<std::uint64_t>(turn.number));
  const std::uint32_t first = static_cast<std::uint32_t>(sensor_) << 20U;
  const auto isHit = [this](double distance) {
    return distance > 0.0 && distance < parameters_.range;
  };
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
