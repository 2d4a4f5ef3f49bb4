#include "sim2d/nav/Lidar.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

// An edge whose line passes the origin within this distance [m] is cast beam by beam: its
// orientation is then decided by rounding, and the tolerance by which rays extend edges covers more
// than a beam.
constexpr double kCollinearTolerance = 1e-5;
constexpr double kBucketsPerBeam = 8.0;  // high enough that a search seldom leaves its bucket
constexpr double kEdgeTolerance = 2e-9;  // [m], at least the tolerance by which rays extend edges

}  // namespace

LidarRaster::LidarRaster(int beams, double angleIncrement, double range)
    : beams_(beams), range_(range), perPseudo_(kBucketsPerBeam / angleIncrement) {
  assert(beams >= 1 && angleIncrement >= 1e-4 && (beams - 1) * angleIncrement < 2.0 * base::kPi &&
         range > 0.0);
  const auto count = static_cast<std::size_t>(beams);
  inverseDistances_.resize(count);
  cosines_.reserve(count);
  sines_.reserve(count);
  pseudos_.reserve(count);
  for (int i = 0; i < beams; ++i) {
    cosines_.push_back(base::cos(i * angleIncrement));
    sines_.push_back(i == 0 ? 0.0 : base::sin(i * angleIncrement));
    pseudos_.push_back(pseudoAngle(directionOfBeam(i)));
  }
  const int buckets = static_cast<int>(4.0 * perPseudo_) + 2;
  start_.reserve(static_cast<std::size_t>(buckets));
  int beam = 0;
  for (int i = 0; i < buckets; ++i) {
    while (beam < beams && pseudos_[static_cast<std::size_t>(beam)] * perPseudo_ < i) {
      ++beam;
    }
    start_.push_back(beam);
  }
  clear();
}

void LidarRaster::clear() {
  std::fill(inverseDistances_.begin(), inverseDistances_.end(), 1.0 / range_);
}

void LidarRaster::block() {
  std::fill(inverseDistances_.begin(), inverseDistances_.end(),
            std::numeric_limits<double>::infinity());
}

Vec2 LidarRaster::directionOfBeam(int beam) const {
  const auto i = static_cast<std::size_t>(beam);
  return {cosines_[i], sines_[i]};
}

double LidarRaster::pseudoAngle(const Vec2& direction) {
  const double share = direction.y() / (std::fabs(direction.x()) + std::fabs(direction.y()));
  if (direction.x() < 0.0) {
    return 2.0 - share;
  }
  return share < 0.0 ? 4.0 + share : share;
}

/// First beam at or after `pseudo`; the number of beams if there is none.
int LidarRaster::firstFrom(double pseudo) const {
  int beam = start_[static_cast<std::size_t>(pseudo * perPseudo_)];
  while (beam < beams_ && pseudos_[static_cast<std::size_t>(beam)] < pseudo) {
    ++beam;
  }
  return beam;
}

/// Beams counter-clockwise from one direction to the other, less than half a turn.
LidarRaster::Beams LidarRaster::beamsBetween(const Vec2& first, const Vec2& last) const {
  const double from = pseudoAngle(first);
  const double to = pseudoAngle(last);
  return {firstFrom(from), firstFrom(to) + (from > to ? beams_ : 0)};
}

template <class Visit>
void LidarRaster::forRanges(const Beams& beams, Visit visit) const {
  visit(beams.first, std::min(beams.end, beams_));
  if (beams.end > beams_) {
    visit(0, beams.end - beams_);
  }
}

void LidarRaster::addEdge(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double area = base::cross(a, b);  // distance of its line from the origin times its length
  const double areaSquared = area * area;
  const double lengthSquared = along.squaredNorm();
  if (areaSquared > range_ * range_ * lengthSquared) {
    return;
  }
  if (areaSquared <= kCollinearTolerance * kCollinearTolerance * lengthSquared) {
    for (int i = 0; i < beams_; ++i) {
      castBeam(i, a, b);
    }
    return;
  }
  if (area > 0.0) {
    return;  // back face
  }
  const Beams beams = beamsBetween(b, a);
  const double perArea = 1.0 / area;
  const Vec2 slope(along.y() * perArea, -along.x() * perArea);
  forRanges(beams, [&](int first, int end) { rasterizeEdge(first, end, slope); });
  // The neighbouring beams may hit the edge within its tolerance.
  const int before = beams.first > 0 ? beams.first - 1 : beams_ - 1;
  const int after = beams.end % beams_;
  if (base::cross(directionOfBeam(before), b) <= kEdgeTolerance) {
    castBeam(before, a, b);
  }
  if (base::cross(a, directionOfBeam(after)) <= kEdgeTolerance) {
    castBeam(after, a, b);
  }
}

/// cross(t d - a, b - a) = 0 along the beam d, hence 1/t = cross(d, b - a) / cross(a, b).
void LidarRaster::rasterizeEdge(int first, int end, const Vec2& slope) {
  const double x = slope.x();
  const double y = slope.y();
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
    inverseDistances_[i] = std::max(inverseDistances_[i], cosines_[i] * x + sines_[i] * y);
  }
}

void LidarRaster::castBeam(int beam, const Vec2& a, const Vec2& b) {
  const std::optional<double> hit = raySegmentHit(Vec2::Zero(), directionOfBeam(beam), {a, b});
  if (hit) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double& nearness = inverseDistances_[static_cast<std::size_t>(beam)];
    const double found = *hit > 0.0 ? 1.0 / *hit : kInfinity;  // avoids division by -0
    nearness = std::max(nearness, found);
  }
}

void LidarRaster::addCircle(const Vec2& centre, double radius) {
  addCircle(centre, radius, beamsOf(centre, radius));
}

/// The tangents are the direction to the centre, rotated by the angle of sine r/d.
LidarRaster::Beams LidarRaster::beamsOf(const Vec2& centre, double radius) const {
  const double outside = centre.squaredNorm() - radius * radius;
  if (outside <= 0.0) {
    return {0, beams_};
  }
  const double tangent = std::sqrt(outside);
  const Vec2 toCentre = tangent * centre;
  const Vec2 aside(-radius * centre.y(), radius * centre.x());
  return beamsBetween(toCentre - aside, toCentre + aside);
}

bool LidarRaster::areCovered(const Beams& beams, double distance) const {
  bool areAll = true;
  forRanges(beams, [&](int first, int end) {
    for (int i = first; i < end && areAll; ++i) {
      areAll = inverseDistances_[static_cast<std::size_t>(i)] * distance >= 1.0;
    }
  });
  return areAll;
}

void LidarRaster::addCircle(const Vec2& centre, double radius, const Beams& beams) {
  if (centre.squaredNorm() <= radius * radius) {
    block();
    return;
  }
  forRanges(beams, [&](int first, int end) { rasterizeCircle(first, end, centre, radius); });
}

/// t = (c d) - sqrt(r² - cross(d, c)²), as 1/t = ((c d) + sqrt(…)) / (c² - r²).
void LidarRaster::rasterizeCircle(int first, int end, const Vec2& centre, double radius) {
  const double perOutside = 1.0 / (centre.squaredNorm() - radius * radius);
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
    const double along = cosines_[i] * centre.x() + sines_[i] * centre.y();
    const double aside = cosines_[i] * centre.y() - sines_[i] * centre.x();
    const double inside = radius * radius - aside * aside;
    if (inside >= 0.0 && along > 0.0) {
      inverseDistances_[i] =
          std::max(inverseDistances_[i], (along + std::sqrt(inside)) * perOutside);
    }
  }
}

void LidarRaster::writeDistances(std::vector<double>& distances) const {
  distances.resize(inverseDistances_.size());
  const double perRange = 1.0 / range_;
  for (std::size_t i = 0; i < inverseDistances_.size(); ++i) {
    distances[i] =
        inverseDistances_[i] > perRange ? std::min(1.0 / inverseDistances_[i], range_) : range_;
  }
}

namespace {

constexpr double kFullScan = 2.0 * base::kPi;

/// Angular spacing [rad]; a full turn for a single beam.
double beamSpacing(const LidarParameters& parameters) {
  const double span = parameters.angleMax - parameters.angleMin;
  assert(parameters.beams >= 1 && span > 0.0 && span <= kFullScan + 1e-9);
  if (span > kFullScan - 1e-9 || parameters.beams == 1) {
    return kFullScan / parameters.beams;
  }
  return span / (parameters.beams - 1);
}

/// Converts to the beam frame: origin at the sensor, x along the first beam.
Vec2 toBeamFrame(const LidarSnapshot& turn, const Vec2& place) {
  const Vec2 offset = place - turn.origin;
  return {turn.ahead.dot(offset), base::cross(turn.ahead, offset)};
}

}  // namespace

bool areValidParameters(const LidarParameters& parameters) {
  const double span = parameters.angleMax - parameters.angleMin;
  return parameters.beams >= 1 && span > 0.0 && span <= kFullScan + 1e-9 &&
         beamSpacing(parameters) >= 1e-4 && parameters.range > 0.0 && parameters.rate > 0.0 &&
         parameters.noise >= 0.0;
}

LidarScanner::LidarScanner(const LidarParameters& parameters, int robotId, int sensor)
    : parameters_(parameters),
      robotId_(robotId),
      sensor_(sensor),
      raster_(parameters.beams, beamSpacing(parameters), parameters.range) {
  assert(areValidParameters(parameters) && sensor >= 0 && sensor < 1024);
}

void LidarScanner::cast(const LidarSnapshot& turn, LaserScan& scan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scan.sensor = turn.sensor;
  scan.mapToOdom = turn.mapToOdom;
  scan.time = turn.time;
  scan.angleMin = parameters_.angleMin;
  scan.angleIncrement = beamSpacing(parameters_);
  scan.range = parameters_.range;
  raster_.clear();
  if (turn.isInsideObstacle) {
    raster_.block();
  } else {
    for (const Segment& wall : *turn.walls) {
      raster_.addEdge(toBeamFrame(turn, wall.a), toBeamFrame(turn, wall.b));
    }
    addBodies(turn);
  }
  raster_.writeDistances(scan.distances);
  addNoise(turn, scan.distances);
}

void LidarScanner::addBodies(const LidarSnapshot& turn) {
  for (std::size_t i = 0; i < turn.bodies.size(); ++i) {
    const SensedBody& body = turn.bodies[i];
    if (body.kind == BodyKind::Person) {
      addPerson(turn, i);
    } else if (body.id != robotId_) {
      if (body.footprint != nullptr && !body.footprint->isDisc()) {
        addPolygon(turn, body);
      } else {
        raster_.addCircle(toBeamFrame(turn, body.position), body.radius);
      }
    }
  }
}

/// Nearer shapes have mostly been added before, so that many people can be skipped early.
void LidarScanner::addPerson(const LidarSnapshot& turn, std::size_t number) {
  const SensedBody& person = turn.bodies[number];
  const Vec2 centre = toBeamFrame(turn, person.position);
  const double distance = centre.norm();
  if (distance - person.radius > parameters_.range) {
    return;
  }
  const LidarRaster::Beams beams = raster_.beamsOf(centre, person.radius);
  if (distance > person.radius && raster_.areCovered(beams, distance - person.radius)) {
    return;
  }
  if (turn.gaitPhases.empty()) {
    raster_.addCircle(centre, person.radius, beams);
    return;
  }
  const Legs legs = legsAt(person, turn.gaitPhases[number]);
  raster_.addCircle(toBeamFrame(turn, legs.left), legs.radius, beams);
  raster_.addCircle(toBeamFrame(turn, legs.right), legs.radius, beams);
}

void LidarScanner::addPolygon(const LidarSnapshot& turn, const SensedBody& robot) {
  const std::vector<Vec2>& corners = robot.footprint->corners;
  const Pose2 pose = robot.pose();
  if (isInside(corners, pose.toLocal(turn.origin))) {
    raster_.block();
    return;
  }
  Vec2 from = toBeamFrame(turn, pose.toWorld(corners.back()));
  for (const Vec2& corner : corners) {
    const Vec2 to = toBeamFrame(turn, pose.toWorld(corner));
    raster_.addEdge(from, to);
    from = to;
  }
}

void LidarScanner::addNoise(const LidarSnapshot& turn, std::vector<double>& distances) const {
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
        rng.normalPair(base::DrawPurpose::Lidar, first + static_cast<std::uint32_t>(i / 2));
    for (std::size_t k = i; k < end; ++k) {
      if (isHit(distances[k])) {
        const double measured = distances[k] + parameters_.noise * errors[k - i];
        distances[k] = std::clamp(measured, 0.0, parameters_.range);
      }
    }
  }
}

Lidar::Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor)
    : parameters_(parameters),
      seed_(seed),
      gait_(seed),
      caster_(std::make_shared<LidarScanner>(parameters, robotId, sensor)),
      walls_(std::make_shared<std::vector<Segment>>()) {}

bool Lidar::update(const SensedWorld& world, ScanDemand use) {
  if (parameters_.legs) {
    gait_.update(world.bodies);
  }
  const std::int64_t number = eventIndexAt(world.time, parameters_.rate);
  const bool isDue = number > number_;
  if (isDue) {
    number_ = number;
    deferredSnapshot_.reset();
  }
  if (isDue && use == ScanDemand::Now) {
    take(world, turn_);
    caster_->cast(turn_, scan_);
  } else if (isDue && use == ScanDemand::Later) {
    const auto turn = std::make_shared<LidarSnapshot>();
    take(world, *turn);
    deferredSnapshot_ = turn;
    areWallsShared_ = true;
  } else if (use == ScanDemand::Now && deferredSnapshot_ != nullptr) {
    caster_->cast(*deferredSnapshot_, scan_);
    deferredSnapshot_.reset();
  }
  return isDue && use == ScanDemand::Now;
}

void Lidar::take(const SensedWorld& world, LidarSnapshot& turn) {
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
  turn.gaitPhases.resize(parameters_.legs ? turn.bodies.size() : 0);
  for (std::size_t i = 0; i < turn.gaitPhases.size(); ++i) {
    turn.gaitPhases[i] = gait_.gaitPhase(i);
  }
}

/// Finding walls costs more than casting beams, so the walls found last are reused until others may
/// have come into range. Deferred scans keep their own list.
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

namespace {

constexpr std::uint32_t kGaitPhaseDraw = 0x80000000U;  // above the draw indices of beams
constexpr double kWalkRatio = 0.39;                    // W [m s]
constexpr double kHalfShoulder = 0.1;                  // [m]
constexpr double kLegRadius = 0.06;                    // [m]
constexpr double kMinStepLength = 0.005;               // [m]; slower people hardly lift their feet

double advancedPhase(double stride, double walked, double speed) {
  const double after = stride + walked / (2.0 * std::max(stepLength(speed), kMinStepLength));
  return after - std::floor(after);
}

}  // namespace

double stepLength(double speed) {
  return std::sqrt(kWalkRatio * speed);
}

Legs legsAt(const SensedBody& person, double stride) {
  Legs legs;
  legs.radius = std::min(kLegRadius, 0.5 * person.radius);
  const double reach = person.radius - legs.radius;  // of a leg's centre
  const double aside = std::min(kHalfShoulder, reach);
  const double room = std::sqrt(std::max(reach * reach - aside * aside, 0.0));
  const double swing = 0.5 * stepLength(person.velocity.norm());
  const double ahead = std::clamp(swing * (std::fabs(4.0 * stride - 2.0) - 1.0), -room, room);
  const Vec2 direction = base::directionOf(person.heading);
  const Vec2 offset =
      ahead * direction + aside * Vec2(-direction.y(), direction.x());  // of the left leg
  // The right leg mirrors the left one at the body's centre.
  legs.left = person.position + offset;
  legs.right = person.position - offset;
  return legs;
}

void LegGait::update(const std::vector<SensedBody>& bodies) {
  walkers_.swap(before_);
  walkers_.resize(bodies.size());
  std::size_t old = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SensedBody& body = bodies[i];
    if (body.kind != BodyKind::Person) {
      walkers_[i] = {};
      continue;
    }
    while (old < before_.size() && before_[old].id >= 0 && before_[old].id < body.id) {
      ++old;
    }
    const bool isKnown = old < before_.size() && before_[old].id == body.id;
    const double stride =
        isKnown
            ? advancedPhase(before_[old].stride, (body.position - before_[old].position).norm(),
                            body.velocity.norm())
            : base::AgentRng(seed_, body.id).uniform01(base::DrawPurpose::Lidar, kGaitPhaseDraw);
    walkers_[i] = {body.id, body.position, stride};
  }
}

}  // namespace sim2d
