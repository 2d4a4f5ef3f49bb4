#include "sim2d/nav/LidarRaster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/map/Outlines.h"

namespace sim2d {
namespace {

// An edge whose line passes the origin this near [m] is met beam by beam: which way round it goes
// is then a matter of rounding, and the nanometre by which rays widen it spans more than a beam.
constexpr double kEdgeInLine = 1e-5;
constexpr double kBucketsPerBeam = 8.0;  // so that a search seldom goes beyond its bucket
constexpr double kEdgeWidened = 2e-9;    // [m], no less than what rays widen edges by

}  // namespace

LidarRaster::LidarRaster(int beams, double perBeam, double range)
    : beams_(beams), range_(range), perPseudo_(kBucketsPerBeam / perBeam) {
  assert(beams >= 1 && perBeam >= 1e-4 && (beams - 1) * perBeam < 2.0 * base::kPi && range > 0.0);
  const auto count = static_cast<std::size_t>(beams);
  nearness_.resize(count);
  cosines_.reserve(count);
  sines_.reserve(count);
  pseudos_.reserve(count);
  for (int i = 0; i < beams; ++i) {
    cosines_.push_back(base::cos(i * perBeam));
    sines_.push_back(i == 0 ? 0.0 : base::sin(i * perBeam));
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
  std::fill(nearness_.begin(), nearness_.end(), 1.0 / range_);
}

void LidarRaster::block() {
  std::fill(nearness_.begin(), nearness_.end(), std::numeric_limits<double>::infinity());
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

/// The first beam at or after it, the number of beams if there is none.
int LidarRaster::firstFrom(double pseudo) const {
  int beam = start_[static_cast<std::size_t>(pseudo * perPseudo_)];
  while (beam < beams_ && pseudos_[static_cast<std::size_t>(beam)] < pseudo) {
    ++beam;
  }
  return beam;
}

/// Counter-clockwise from one direction to the other, less than half a turn.
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
  const double area = base::cross(a, b);  // its height over the origin times its length
  const double areaSquared = area * area;
  const double lengthSquared = along.squaredNorm();
  if (areaSquared > range_ * range_ * lengthSquared) {
    return;
  }
  if (areaSquared <= kEdgeInLine * kEdgeInLine * lengthSquared) {
    for (int i = 0; i < beams_; ++i) {
      castBeam(i, a, b);
    }
    return;
  }
  if (area > 0.0) {
    return;  // its back
  }
  const Beams beams = beamsBetween(b, a);
  const double perArea = 1.0 / area;
  const Vec2 slope(along.y() * perArea, -along.x() * perArea);
  forRanges(beams, [&](int first, int end) { coverByEdge(first, end, slope); });
  // The beams beside meet it where it is widened.
  const int before = beams.first > 0 ? beams.first - 1 : beams_ - 1;
  const int after = beams.end % beams_;
  if (base::cross(directionOfBeam(before), b) <= kEdgeWidened) {
    castBeam(before, a, b);
  }
  if (base::cross(a, directionOfBeam(after)) <= kEdgeWidened) {
    castBeam(after, a, b);
  }
}

/// cross(t d - a, b - a) = 0 along the beam d, hence 1/t = cross(d, b - a) / cross(a, b).
void LidarRaster::coverByEdge(int first, int end, const Vec2& slope) {
  const double x = slope.x();
  const double y = slope.y();
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
    nearness_[i] = std::max(nearness_[i], cosines_[i] * x + sines_[i] * y);
  }
}

void LidarRaster::castBeam(int beam, const Vec2& a, const Vec2& b) {
  const std::optional<double> hit = raySegmentHit(Vec2::Zero(), directionOfBeam(beam), {a, b});
  if (hit) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double& nearness = nearness_[static_cast<std::size_t>(beam)];
    const double found = *hit > 0.0 ? 1.0 / *hit : kInfinity;  // not by -0
    nearness = std::max(nearness, found);
  }
}

void LidarRaster::addCircle(const Vec2& centre, double radius) {
  addCircle(centre, radius, beamsOf(centre, radius));
}

/// The tangents are the way to the centre, turned by the angle of sine r/d.
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
      areAll = nearness_[static_cast<std::size_t>(i)] * distance >= 1.0;
    }
  });
  return areAll;
}

void LidarRaster::addCircle(const Vec2& centre, double radius, const Beams& beams) {
  if (centre.squaredNorm() <= radius * radius) {
    block();
    return;
  }
  forRanges(beams, [&](int first, int end) { coverByCircle(first, end, centre, radius); });
}

/// t = (c d) - sqrt(r² - cross(d, c)²), as 1/t = ((c d) + sqrt(…)) / (c² - r²).
void LidarRaster::coverByCircle(int first, int end, const Vec2& centre, double radius) {
  const double perOutside = 1.0 / (centre.squaredNorm() - radius * radius);
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i) {
    const double along = cosines_[i] * centre.x() + sines_[i] * centre.y();
    const double aside = cosines_[i] * centre.y() - sines_[i] * centre.x();
    const double inside = radius * radius - aside * aside;
    if (inside >= 0.0 && along > 0.0) {
      nearness_[i] = std::max(nearness_[i], (along + std::sqrt(inside)) * perOutside);
    }
  }
}

void LidarRaster::writeDistances(std::vector<double>& distances) const {
  distances.resize(nearness_.size());
  const double perRange = 1.0 / range_;
  for (std::size_t i = 0; i < nearness_.size(); ++i) {
    distances[i] = nearness_[i] > perRange ? std::min(1.0 / nearness_[i], range_) : range_;
  }
}

}  // namespace sim2d
