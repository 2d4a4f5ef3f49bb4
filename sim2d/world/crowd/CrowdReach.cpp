#include "sim2d/world/crowd/CrowdReach.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Types.h"

namespace sim2d {
namespace {

constexpr int kDirections = 12;   // steps from straight ahead to straight back
constexpr int kVelocities = 8;    // steps along each half axis of the others' velocities
constexpr int kMiddles = 24;      // places tried for the middle of a disc
constexpr double kMargin = 0.25;  // [m]; what lies between the steps

// A bound of the speed:
constexpr double kSpare = 0.25;         // [m/s] above the fastest while that may still grow
constexpr double kSteadySpare = 0.03;   // [m/s] later
constexpr double kTooWide = 0.08;       // [m/s] above the fastest
constexpr std::size_t kWasted = 50000;  // people who felt too far; as long as a table takes

}  // namespace

bool SpeedBound::update(double fastest, std::size_t people) {
  const double before = value_;
  if (fastest > value_) {
    value_ = fastest + kSpare;
    wasted_ = 0;
  } else if (fastest + kTooWide > value_) {
    wasted_ = 0;
  } else {
    largest_ = wasted_ == 0 ? fastest : std::max(largest_, fastest);
    wasted_ += people;
    if (wasted_ > kWasted) {
      value_ = largest_ + kSteadySpare;
      wasted_ = 0;
    }
  }
  return value_ != before;
}

CrowdReach::CrowdReach(const ForceParameters& parameters, double cutOff, double fastest)
    : parameters_(parameters), cutOff_(cutOff), fastest_(fastest) {
  for (std::size_t i = 0; i < kDiscs; ++i) {
    const double step = fastest_ / static_cast<double>(kDiscs);
    discs_[i] = discOver(step * static_cast<double>(i), step * static_cast<double>(i + 1));
  }
}

const CrowdReach::Disc& CrowdReach::discOf(double speed) const {
  const double place = speed / fastest_ * static_cast<double>(kDiscs);
  return discs_[std::min(static_cast<std::size_t>(place), kDiscs - 1)];
}

/// Distance from which on `isNegligible` holds for an interaction vector with these parts along
/// and across the line to the other; for angles above a quarter turn a sharper bound [m].
double CrowdReach::boundOf(double along, double across) const {
  const double side = std::min(parameters_.n, parameters_.nPrime) * parameters_.gamma;
  const double length2 = along * along + across * across;
  const double turned = along < 0.0 ? side * side * base::kPi * base::kPi / 4.0 * length2
                                    : side * side * across * across;
  return parameters_.gamma * std::sqrt(length2) * std::max(0.0, cutOff_ - turned);
}

/// Over all velocities of the other, in one direction from a person who walks along x.
double CrowdReach::farthestAt(double cosine, double sine, double speed) const {
  double farthest = 0.0;
  for (int i = -kVelocities; i <= kVelocities; ++i) {
    const double along = fastest_ * i / kVelocities;
    const double most = std::sqrt(std::max(0.0, fastest_ * fastest_ - along * along));
    for (int k = -kVelocities; k <= kVelocities; ++k) {
      const double across = most * k / kVelocities;
      farthest = std::max(farthest, boundOf(parameters_.lambda * (speed * cosine - along) + 1.0,
                                            parameters_.lambda * (speed * sine - across)));
    }
  }
  return farthest;
}

/// The smallest one, of some, that holds everybody for all speeds in between.
CrowdReach::Disc CrowdReach::discOver(double low, double high) const {
  std::array<Vec2, kDirections + 1> border;
  double ahead = 0.0;
  for (int i = 0; i <= kDirections; ++i) {
    const Vec2 direction = base::directionOf(base::kPi * i / kDirections);
    double farthest = 0.0;
    for (const double speed : {low, (low + high) / 2.0, high}) {
      farthest = std::max(farthest, farthestAt(direction.x(), direction.y(), speed));
    }
    border[static_cast<std::size_t>(i)] = farthest * direction;
    ahead = std::max(ahead, farthest);
  }
  Disc best{0.0, ahead};
  for (int i = 1; i <= kMiddles; ++i) {
    const Vec2 middle(ahead / 2.0 * i / kMiddles, 0.0);
    double radius = 0.0;
    for (const Vec2& point : border) {
      radius = std::max(radius, (point - middle).norm());
    }
    best = radius < best.radius ? Disc{middle.x(), radius} : best;
  }
  best.radius += kMargin;
  return best;
}

bool haveOneShape(const ForceParameters& a, const ForceParameters& b) {
  return a.lambda == b.lambda && a.gamma == b.gamma && a.n == b.n && a.nPrime == b.nPrime;
}

}  // namespace sim2d
