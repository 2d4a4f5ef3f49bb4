#include "sim2d/nav/mppi/MppiScene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sim2d {
namespace {

constexpr double kWalksFrom = 0.15;  // [m/s]
constexpr double kLog2e = 1.4426950408889634;
constexpr double kMostDiscs = 5.0;
constexpr double kLeastBand = 0.05;     // [m], between touch and no cost
constexpr double kGroupDistance = 2.0;  // [m], between two who talk
constexpr double kGroupRadius = 0.6;    // [m], least of the space between them
constexpr double kFacing = 0.5;         // least cosine between heading and direction to the other
constexpr double kNarrowFrom = 0.3, kNarrowTo = 4.0, kNarrowStep = 0.1;  // [m], along the route
constexpr double kBesideRay = 2.5;                                       // [m]
constexpr double kComesWithin = 4.0;                                     // [s]
constexpr double kComesAtLeast = 0.2;                                    // [m/s]
constexpr double kIsThrough = 0.6;  // [m] on this side of the place

Vec2 headingOfBody(const Vec2& velocity, double heading) {
  const double speed = velocity.norm();
  return speed > kWalksFrom ? Vec2(velocity / speed) : base::directionOf(heading);
}

MppiPerson personAt(const PredictedBody& body, std::size_t step, const Vec2& origin,
                    const MppiRanges& ranges) {
  const Vec2 place = body.positions[step] - origin;
  const Vec2& velocity = body.velocities[step];
  const double speed = velocity.norm();
  const double radii = body.now.radius + ranges.robotRadius;
  const double touch = radii + ranges.margin;
  const double far = std::max(radii + ranges.range, touch + kLeastBand);
  const Vec2 heading = headingOfBody(velocity, body.now.heading);
  // Variances of Kirby 2010: longest ahead, two thirds to the sides, half behind.
  const double variance = std::max(2.0 * speed, 0.5);
  const double walks = std::clamp((speed - kWalksFrom) / kWalksFrom, 0.0, 1.0);
  MppiPerson person;
  person.x = static_cast<float>(place.x());
  person.y = static_cast<float>(place.y());
  person.far2 = static_cast<float>(far * far);
  person.perBand = static_cast<float>(1.0 / (far * far - touch * touch));
  person.touch = static_cast<float>(body.now.radius + ranges.reach);
  person.vx = static_cast<float>(velocity.x());
  person.vy = static_cast<float>(velocity.y());
  person.hx = static_cast<float>(heading.x());
  person.hy = static_cast<float>(heading.y());
  person.front = static_cast<float>(kLog2e / (2.0 * variance));
  person.side = static_cast<float>(kLog2e / (2.0 * variance * 2.0 / 3.0));
  person.rear = static_cast<float>(kLog2e / (2.0 * variance / 2.0));
  person.perStrip = static_cast<float>(1.0 / (radii + speed * ranges.stripTime));
  person.walks = static_cast<float>(walks);
  person.comfort = body.now.kind == BodyKind::Person ? 1.0F : 0.0F;
  return person;
}

double widthAt(const Obstacles& obstacles, const Vec2& point, const Vec2& direction) {
  const Vec2 left(-direction.y(), direction.x());
  return obstacles.raycast(point, left, kBesideRay) + obstacles.raycast(point, -left, kBesideRay);
}

}  // namespace

std::vector<MppiDisc> coverOf(const Footprint& footprint) {
  if (footprint.isDisc()) {
    return {{0.0F, 0.0F, static_cast<float>(footprint.radius)}};
  }
  Vec2 low = footprint.corners.front();
  Vec2 high = low;
  for (const Vec2& corner : footprint.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const Vec2 size = high - low;
  const int along = size.x() >= size.y() ? 0 : 1;
  const double shorter = std::max(size[1 - along], 1e-3);
  const auto count =
      static_cast<int>(std::clamp(std::ceil(size[along] / shorter + 0.5), 1.0, kMostDiscs));
  const double slab = size[along] / count;
  const double radius = 0.5 * std::sqrt(slab * slab + shorter * shorter);
  std::vector<MppiDisc> discs;
  discs.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Vec2 centre = 0.5 * (low + high);
    centre[along] = low[along] + (i + 0.5) * slab;
    discs.push_back({static_cast<float>(centre.x()), static_cast<float>(centre.y()),
                     static_cast<float>(radius)});
  }
  return discs;
}

void addBodies(const std::vector<PredictedBody>& bodies, const Vec2& origin, double dt,
               const MppiRanges& ranges, MppiScene& scene) {
  const std::size_t steps = bodies.empty() ? 0 : bodies.front().positions.size();
  scene.people.reserve(steps * bodies.size());
  for (std::size_t step = 0; step < steps; ++step) {
    scene.firstPerson[step] = static_cast<int>(scene.people.size());
    const double travel = ranges.speed * dt * static_cast<double>(step + 1) + ranges.reach;
    for (const PredictedBody& body : bodies) {
      const double near = std::max(ranges.range, ranges.margin + kLeastBand);
      const double cares = body.now.kind == BodyKind::Person ? ranges.comfortRange : 0.0;
      const double range = travel + body.now.radius + ranges.robotRadius + std::max(near, cares);
      if ((body.positions[step] - origin).norm() < range) {
        scene.people.push_back(personAt(body, step, origin, ranges));
      }
    }
  }
  std::fill(scene.firstPerson.begin() + static_cast<std::ptrdiff_t>(steps), scene.firstPerson.end(),
            static_cast<int>(scene.people.size()));
}

std::vector<SlowDisc> standingBodies(const std::vector<PredictedBody>& bodies, double room) {
  std::vector<SlowDisc> discs;
  discs.reserve(bodies.size());
  for (const PredictedBody& body : bodies) {
    if (body.now.velocity.norm() < kWalksFrom) {
      discs.push_back({body.now.position, body.now.radius + room});
    }
  }
  return discs;
}

void addGroups(const std::vector<PredictedBody>& bodies, const Vec2& origin, double weight,
               std::vector<MppiZone>& zones) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const TrackedBody& a = bodies[i].now;
      const TrackedBody& b = bodies[j].now;
      const Vec2 apart = b.position - a.position;
      const double distance = apart.norm();
      const bool arePeople = a.kind == BodyKind::Person && b.kind == BodyKind::Person;
      const bool stand = a.velocity.norm() < kWalksFrom && b.velocity.norm() < kWalksFrom;
      if (!arePeople || !stand || distance > kGroupDistance || distance < 1e-3 ||
          base::directionOf(a.heading).dot(apart) < kFacing * distance ||
          base::directionOf(b.heading).dot(-apart) < kFacing * distance) {
        continue;
      }
      const Vec2 middle = 0.5 * (a.position + b.position) - origin;
      const double radius = std::max(0.5 * distance, kGroupRadius);
      zones.push_back({static_cast<float>(middle.x()), static_cast<float>(middle.y()),
                       static_cast<float>(1.0 / (radius * radius)), static_cast<float>(weight)});
    }
  }
}

NarrowPlace narrowPlaceAhead(const RobotRoute& route, const Vec2& position,
                             const Obstacles& obstacles, double width) {
  NarrowPlace place;
  const double rest = std::min(route.restLength(position), kNarrowTo);
  const auto count = static_cast<int>(std::floor((rest - kNarrowFrom) / kNarrowStep));
  Vec2 before = route.pointAhead(position, kNarrowFrom - kNarrowStep);
  for (int i = 0; i <= count; ++i) {
    const Vec2 point = route.pointAhead(position, kNarrowFrom + i * kNarrowStep);
    const Vec2 way = point - before;
    before = point;
    const double length = way.norm();
    if (length < 1e-6) {
      continue;
    }
    const double room = widthAt(obstacles, point, way / length);
    if (room < width && (!place.isThere || room < place.width)) {
      place = {true, point, way / length, room};
    } else if (place.isThere && room >= width) {
      break;  // behind the first narrow place
    }
  }
  return place;
}

bool comesThrough(const TrackedBody& body, const NarrowPlace& place) {
  const Vec2 from = body.position - place.position;
  const double beyond = from.dot(place.direction);
  const double speed = -body.velocity.dot(place.direction);
  if (body.kind != BodyKind::Person || speed < kComesAtLeast || beyond < -kIsThrough ||
      beyond > kComesWithin * speed) {
    return false;
  }
  const Vec2 there = from + std::max(beyond, 0.0) / speed * body.velocity;
  return std::fabs(base::cross(place.direction, there)) < 0.5 * place.width + body.radius;
}

}  // namespace sim2d
