#include "editor/document/Geometry.h"

#include <algorithm>
#include <cmath>

#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

Extent extentOfPoints(const std::vector<Vec2>& points) {
  Extent extent{points.front(), points.front()};
  for (const Vec2& point : points) {
    extent.include({point, point});
  }
  return extent;
}

bool isByCorners(const sim2d::Obstacle& obstacle) {
  return obstacle.kind == sim2d::ObstacleKind::Polygon ||
         obstacle.kind == sim2d::ObstacleKind::Wall;
}

std::vector<Vec2> outlineOf(const sim2d::Obstacle& obstacle) {
  if (isByCorners(obstacle)) {
    return obstacle.points;
  }
  if (obstacle.kind == sim2d::ObstacleKind::Box) {
    return sim2d::boxOutline(obstacle.pose, obstacle.length, obstacle.width).points;
  }
  const Vec2 reach = Vec2::Constant(obstacle.radius);
  return {obstacle.pose.position - reach, obstacle.pose.position + reach};
}

}  // namespace

void Extent::include(const Extent& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

std::vector<Vec2>* cornersOf(Entity& entity) {
  if (auto* area = std::get_if<sim2d::Area>(&entity)) {
    return &area->points;
  }
  auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  return obstacle != nullptr && isByCorners(*obstacle) ? &obstacle->points : nullptr;
}

const std::vector<Vec2>* cornersOf(const Entity& entity) {
  return cornersOf(const_cast<Entity&>(entity));
}

bool hasOpenLine(const Entity& entity) {
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  return obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Wall;
}

std::size_t fewestCorners(const Entity& entity) {
  return hasOpenLine(entity) ? 2 : 3;
}

std::optional<std::size_t> edgeNear(const Entity& entity, const Vec2& point, double reach) {
  const std::vector<Vec2>* corners = cornersOf(entity);
  if (corners == nullptr || corners->size() < 2) {
    return std::nullopt;
  }
  std::optional<std::size_t> found;
  const std::size_t count = hasOpenLine(entity) ? corners->size() - 1 : corners->size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& a = (*corners)[i];
    const Vec2 along = (*corners)[(i + 1) % corners->size()] - a;
    const double length2 = along.squaredNorm();
    const double part =
        length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    const double distance = (point - a - part * along).norm();
    if (distance <= reach) {
      reach = distance;
      found = i;
    }
  }
  return found;
}

std::optional<Extent> extentOf(const Entity& entity) {
  if (const std::vector<Vec2>* corners = cornersOf(entity); corners != nullptr) {
    return corners->empty() ? std::nullopt : std::optional<Extent>(extentOfPoints(*corners));
  }
  if (const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity)) {
    return extentOfPoints(outlineOf(*obstacle));
  }
  if (const auto* door = std::get_if<sim2d::Door>(&entity)) {
    return extentOfPoints({door->from, door->to});
  }
  const std::optional<Vec2> at = positionOf(entity);
  return at ? std::optional<Extent>({*at, *at}) : std::nullopt;
}

Entity rotated(Entity entity, const Vec2& centre, double angle) {
  const Pose2 turn{centre, angle};
  const auto at = [&](const Vec2& point) { return rounded(turn.toWorld(point - centre)); };
  if (std::vector<Vec2>* corners = cornersOf(entity)) {
    for (Vec2& corner : *corners) {
      corner = at(corner);
    }
    return entity;
  }
  if (auto* door = std::get_if<sim2d::Door>(&entity)) {
    door->from = at(door->from);
    door->to = at(door->to);
    return entity;
  }
  const std::optional<Vec2> place = positionOf(entity);
  const std::optional<double> heading = headingOf(entity);
  if (place) {
    entity = moved(std::move(entity), at(*place) - *place);
  }
  return heading ? turned(std::move(entity), *heading + angle) : entity;
}

double rounded(double metres) {
  constexpr double kPerMetre = 1e6;
  return std::round(metres * kPerMetre) / kPerMetre + 0.0;  // 0, not -0
}

Vec2 rounded(const Vec2& point) {
  return {rounded(point.x()), rounded(point.y())};
}

}  // namespace editor
