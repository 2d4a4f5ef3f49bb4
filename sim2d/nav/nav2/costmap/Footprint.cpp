#include "sim2d/nav/nav2/costmap/Footprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"

namespace sim2d::nav2 {
namespace {

constexpr std::size_t kMaxCorners = 1000;
constexpr double kMaxCornerDistance = 100000.0;  // [m]

/// Parses "[[x, y], …]" like Nav2: commas may be missing or repeated.
class PolygonParser {
 public:
  explicit PolygonParser(std::string_view text) : rest_(text) {}

  std::optional<Polygon> read() {
    Polygon polygon;
    bool isValid = consume('[');
    while (isValid && consume('[')) {
      Vec2 corner = Vec2::Zero();
      isValid = parseNumber(corner.x()) && parseNumber(corner.y()) && consume(']');
      polygon.push_back(corner);
    }
    isValid = isValid && consume(']') && base::trimmed(rest_).empty();
    return isValid ? std::optional<Polygon>(std::move(polygon)) : std::nullopt;
  }

 private:
  void skipSeparators() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(", \t\r\n"), rest_.size()));
  }
  bool consume(char sign) {
    skipSeparators();
    const bool isThere = !rest_.empty() && rest_.front() == sign;
    rest_.remove_prefix(isThere ? 1 : 0);
    return isThere;
  }
  bool parseNumber(double& number) {
    skipSeparators();
    const std::string_view token = rest_.substr(0, rest_.find_first_of("[], \t\r\n"));
    const std::optional<double> value = base::parseDouble(token);
    rest_.remove_prefix(token.size());
    number = value.value_or(0.0);
    return value && std::isfinite(*value);
  }

  std::string_view rest_;
};

double paddingSign(double value) {
  return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0;
}

}  // namespace

Polygon circlePolygon(double radius) {
  constexpr int kCorners = 16;
  Polygon polygon;
  polygon.reserve(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    // In doubles the cosine of a right angle is not exactly 0. Nav2 pads it, and so does this code.
    const base::SinCos angle = base::sinCos(i * 2.0 * base::kPi / kCorners);
    polygon.emplace_back(radius * angle.cos, radius * angle.sin);
  }
  return polygon;
}

Polygon padded(const Polygon& polygon, double padding) {
  Polygon wide = polygon;
  for (Vec2& corner : wide) {
    corner += padding * Vec2(paddingSign(corner.x()), paddingSign(corner.y()));
  }
  return wide;
}

Polygon transformed(const Polygon& polygon, const Pose2& pose) {
  const Vec2 ahead = pose.direction();
  Polygon world = polygon;
  for (Vec2& corner : world) {
    corner = pose.position + Vec2(corner.x() * ahead.x() - corner.y() * ahead.y(),
                                  corner.x() * ahead.y() + corner.y() * ahead.x());
  }
  return world;
}

base::Result<Polygon> readPolygon(std::string_view text) {
  std::optional<Polygon> polygon = PolygonParser(text).read();
  if (!polygon) {
    return base::error("nav2.polygon-unreadable", {text});
  }
  if (polygon->size() < 3) {
    return base::error("nav2.polygon-too-small", {text});
  }
  const auto isFar = [](const Vec2& corner) {
    return !(corner.array().abs() <= kMaxCornerDistance).all();
  };
  if (polygon->size() > kMaxCorners || std::any_of(polygon->begin(), polygon->end(), isFar)) {
    return base::error("nav2.polygon-too-large", {kMaxCorners, kMaxCornerDistance});
  }
  return *std::move(polygon);
}

double inscribedRadius(const Polygon& polygon) {
  if (polygon.empty()) {
    return 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(
        least, distanceToSegment({polygon[i], polygon[(i + 1) % polygon.size()]}, Vec2::Zero()));
  }
  return least;
}

double circumscribedRadius(const Polygon& polygon) {
  double most = 0.0;
  for (const Vec2& corner : polygon) {
    most = std::max(most, corner.norm());
  }
  return most;
}

CostmapFootprint costmapFootprint(double radius, const Polygon& corners, double padding) {
  CostmapFootprint footprint;
  footprint.isRadius = corners.empty();
  footprint.corners = padded(corners.empty() ? circlePolygon(radius) : corners, padding);
  footprint.inscribed = inscribedRadius(footprint.corners);
  footprint.circumscribed = circumscribedRadius(footprint.corners);
  return footprint;
}

std::uint8_t pointCost(const Costmap& costmap, const Vec2& place) {
  const std::optional<Cell> cell = costmap.worldToCell(place);
  return cell ? costmap.at(*cell) : kLethal;
}

std::uint8_t lineCost(const Costmap& costmap, Cell from, Cell to) {
  std::uint8_t most = kFreeSpace;
  visitLine(from, to, [&costmap, &most](Cell cell) {
    const std::uint8_t cost = costmap.at(cell);
    most = cost == kLethal ? kLethal : std::max(most, cost);
    return cost != kLethal;
  });
  return most;
}

std::uint8_t polygonCost(const Costmap& costmap, const Polygon& polygon) {
  if (polygon.empty()) {
    return kFreeSpace;
  }
  std::optional<Cell> first = costmap.worldToCell(polygon.front());
  if (!first) {
    return kLethal;
  }
  Cell from = *first;
  std::uint8_t most = kFreeSpace;
  for (std::size_t i = 1; i < polygon.size() && most != kLethal; ++i) {
    const std::optional<Cell> to = costmap.worldToCell(polygon[i]);
    if (!to) {
      return kLethal;
    }
    most = std::max(most, lineCost(costmap, from, *to));
    from = *to;
  }
  return most == kLethal ? kLethal : std::max(most, lineCost(costmap, *first, from));
}

std::uint8_t footprintCost(const Costmap& costmap, const Polygon& corners, const Pose2& pose) {
  return polygonCost(costmap, transformed(corners, pose));
}

bool isInCollision(const Costmap& costmap, const CostmapFootprint& footprint, const Pose2& pose,
                   bool isUnknownFree) {
  return footprint.isRadius
             ? isCentreCollision(pointCost(costmap, pose.position), isUnknownFree)
             : isEdgeCollision(footprintCost(costmap, footprint.corners, pose), isUnknownFree);
}

}  // namespace sim2d::nav2
