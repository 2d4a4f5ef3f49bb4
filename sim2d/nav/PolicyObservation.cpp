#include "sim2d/nav/PolicyObservation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim2d/base/Math.h"

namespace sim2d {

std::vector<std::pair<double, const TrackedBody*>> nearestPeople(
    const Vec2& from, const std::vector<TrackedBody>& bodies) {
  std::vector<std::pair<double, const TrackedBody*>> near;
  for (const TrackedBody& body : bodies) {
    const double distance = (body.position - from).norm();
    if (body.kind == BodyKind::Person && distance <= kPolicyPeopleRange) {
      near.emplace_back(distance, &body);
    }
  }
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second->id) < std::pair(b.first, b.second->id);
  });
  return near;
}

void writePolicyState(const Pose2& pose, const BodyTwist& motion, const Vec2& goal, float* to) {
  const Vec2 local = pose.toLocal(goal);
  for (const double value : {local.x(), local.y(), motion.linear, motion.lateral, motion.angular}) {
    *to++ = static_cast<float>(value);
  }
}

void writePolicyPeople(const Pose2& pose,
                       const std::vector<std::pair<double, const TrackedBody*>>& near,
                       std::size_t rows, float* to) {
  const Pose2 frame{Vec2::Zero(), pose.heading};
  std::fill_n(to, rows * kPolicyPersonColumns, 0.0F);
  for (std::size_t i = 0; i < std::min(near.size(), rows); ++i) {
    const TrackedBody& person = *near[i].second;
    const Vec2 place = pose.toLocal(person.position);
    const Vec2 velocity = frame.toLocal(person.velocity);
    for (const double value : {place.x(), place.y(), velocity.x(), velocity.y(), person.radius}) {
      *to++ = static_cast<float>(value);
    }
  }
}

namespace {

constexpr double kFullTurn = 2.0 * base::kPi;

/// Index of the beam nearest to the direction [rad], in the frame of the scan's position; nullopt
/// outside the field of view.
std::optional<std::size_t> nearestBeam(const LaserScan& scan, double direction) {
  const double offset = direction - scan.sensor.heading - scan.angleMin;
  double steps = (offset - kFullTurn * std::floor(offset / kFullTurn)) / scan.angleIncrement;
  const double turn = kFullTurn / scan.angleIncrement;  // in beams, also of a partial scan
  if (steps >= turn - 0.5) {                            // just before the first beam
    steps = 0.0;
  }
  const auto beam = static_cast<std::size_t>(std::lround(std::max(steps, 0.0)));
  return beam < scan.distances.size() ? std::optional(beam) : std::nullopt;
}

}  // namespace

void writePolicyLidar(const Pose2& pose, const LaserScan* scan, std::size_t beams, float* to) {
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle =
        -base::kPi + kFullTurn / static_cast<double>(beams) * static_cast<double>(i);
    const auto beam = scan != nullptr ? nearestBeam(*scan, pose.heading + angle) : std::nullopt;
    const double distance = beam ? scan->distances[*beam] : kPolicyLidarRange;
    const bool isHit = beam && distance < scan->range;
    to[i] = static_cast<float>(isHit ? std::min(distance, kPolicyLidarRange) : kPolicyLidarRange);
  }
}

void writePolicyGrid(const Pose2& pose, const std::vector<TrackedBody>& others,
                     const Obstacles& obstacles, const PolicySizes& sizes, float* to) {
  const double half = 0.5 * static_cast<double>(sizes.gridCells) * sizes.gridResolution;
  for (std::size_t i = 0; i < sizes.gridCells; ++i) {
    for (std::size_t j = 0; j < sizes.gridCells; ++j) {
      const Vec2 local((static_cast<double>(i) + 0.5) * sizes.gridResolution - half,
                       (static_cast<double>(j) + 0.5) * sizes.gridResolution - half);
      const Vec2 place = pose.toWorld(local);
      const bool isInBody = std::any_of(others.begin(), others.end(), [&](const TrackedBody& body) {
        return (body.position - place).squaredNorm() <= body.radius * body.radius;
      });
      *to++ = isInBody || obstacles.isInside(place) ? 1.0F : 0.0F;
    }
  }
}

PolicyObservation::PolicyObservation(const PolicySizes& sizes)
    : state(kPolicyStateColumns),
      people(sizes.people * kPolicyPersonColumns),
      lidar(sizes.beams),
      grid(sizes.gridCells * sizes.gridCells),
      sizes_(sizes) {}

void PolicyObservation::fill(const Observation& observation) {
  const Pose2& pose = observation.pose;
  writePolicyState(pose, observation.motion, observation.goal, state.data());
  if (sizes_.people > 0) {
    writePolicyPeople(pose, nearestPeople(pose.position, observation.bodies), sizes_.people,
                      people.data());
  }
  if (sizes_.beams > 0) {
    writePolicyLidar(pose, observation.scan, sizes_.beams, lidar.data());
  }
  if (sizes_.gridCells > 0) {
    writePolicyGrid(pose, observation.bodies, *observation.obstacles, sizes_, grid.data());
  }
}

}  // namespace sim2d
