#include "sim2d/scenario/BlockShapes.h"

#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

std::vector<Vec2> readPoints(YamlMap& view, std::size_t least) {
  const std::vector<double> xs = view.numbers("xs");
  const std::vector<double> ys = view.numbers("ys");
  if (xs.size() != ys.size()) {
    view.error("ys", "must have as many numbers as xs");
    return {};
  }
  if (xs.size() < least) {
    view.error("xs", "needs at least " + std::to_string(least) + " points");
  }
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    points.emplace_back(xs[i], ys[i]);
  }
  return points;
}

void setPoints(YamlNode& map, const std::vector<Vec2>& points) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Vec2& point : points) {
    xs.push_back(point.x());
    ys.push_back(point.y());
  }
  if (!points.empty()) {
    setChild(map, "xs", decimalList(xs));
    setChild(map, "ys", decimalList(ys));
  }
}

void setOptional(YamlNode& map, const std::string& key, const std::optional<double>& value) {
  if (value) {
    setChild(map, key, decimals(*value));
  }
}

}  // namespace

Obstacle readObstacle(YamlMap view) {
  Obstacle obstacle;
  const auto kind = view.requiredChoice("kind", obstacleKindWords());
  if (!kind) {
    return obstacle;  // told; its keys say nothing then
  }
  obstacle.kind = static_cast<ObstacleKind>(*kind);
  switch (obstacle.kind) {
    case ObstacleKind::Box:
      obstacle.pose.position = Vec2(view.required("x"), view.required("y"));
      obstacle.pose.heading = view.number("h").value_or(0.0);
      obstacle.length = view.required("length", kPositive);
      obstacle.width = view.required("width", kPositive);
      break;
    case ObstacleKind::Circle:
      obstacle.pose.position = Vec2(view.required("x"), view.required("y"));
      obstacle.radius = view.required("radius", kPositive);
      break;
    case ObstacleKind::Polygon:
      obstacle.points = readPoints(view, 3);
      break;
    case ObstacleKind::Wall:
      obstacle.points = readPoints(view, 2);
      obstacle.thickness = view.number("thickness", kPositive);
      break;
  }
  obstacle.unknown = view.takeUnknown();
  return obstacle;
}

Door readDoor(YamlMap view) {
  Door door;
  door.from = Vec2(view.required("x1"), view.required("y1"));
  door.to = Vec2(view.required("x2"), view.required("y2"));
  door.thickness = view.number("thickness", kPositive);
  door.open = view.boolean("open");
  door.toggles = view.numbers("toggles", kNotNegative);
  door.unknown = view.takeUnknown();
  return door;
}

Area readArea(YamlMap view) {
  Area area;
  area.kind = static_cast<AreaKind>(
      view.requiredChoice("kind", areaKindWords()).value_or(static_cast<int>(AreaKind::Wait)));
  area.points = readPoints(view, 3);
  area.like = view.text("like");
  area.rate = view.number("rate", kNotNegative);
  area.from = view.number("from", kNotNegative);
  area.until = view.number("until", kNotNegative);
  area.count = view.integer("count", 0, 1000000);
  area.unknown = view.takeUnknown();
  return area;
}

YamlNode obstacleTree(const Obstacle& obstacle) {
  YamlNode tree;
  setChild(tree, "kind", stringNode(obstacleKindWords()[static_cast<std::size_t>(obstacle.kind)]));
  const bool box = obstacle.kind == ObstacleKind::Box;
  if (box || obstacle.kind == ObstacleKind::Circle) {
    setChild(tree, "x", decimals(obstacle.pose.position.x()));
    setChild(tree, "y", decimals(obstacle.pose.position.y()));
  }
  if (box) {
    setChild(tree, "h", decimals(obstacle.pose.heading));
    setChild(tree, "length", decimals(obstacle.length));
    setChild(tree, "width", decimals(obstacle.width));
  }
  if (obstacle.kind == ObstacleKind::Circle) {
    setChild(tree, "radius", decimals(obstacle.radius));
  }
  if (obstacle.kind == ObstacleKind::Polygon || obstacle.kind == ObstacleKind::Wall) {
    setPoints(tree, obstacle.points);
  }
  if (obstacle.kind == ObstacleKind::Wall) {
    setOptional(tree, "thickness", obstacle.thickness);
  }
  setUnknown(tree, obstacle.unknown);
  return tree;
}

YamlNode doorTree(const Door& door) {
  YamlNode tree;
  setChild(tree, "x1", decimals(door.from.x()));
  setChild(tree, "y1", decimals(door.from.y()));
  setChild(tree, "x2", decimals(door.to.x()));
  setChild(tree, "y2", decimals(door.to.y()));
  setOptional(tree, "thickness", door.thickness);
  if (door.open) {
    setChild(tree, "open", flag(*door.open));
  }
  if (!door.toggles.empty()) {
    setChild(tree, "toggles", decimalList(door.toggles));
  }
  setUnknown(tree, door.unknown);
  return tree;
}

YamlNode areaTree(const Area& area) {
  YamlNode tree;
  setChild(tree, "kind", stringNode(areaKindWords()[static_cast<std::size_t>(area.kind)]));
  setPoints(tree, area.points);
  if (area.like) {
    setChild(tree, "like", stringNode(*area.like));
  }
  setOptional(tree, "rate", area.rate);
  setOptional(tree, "from", area.from);
  setOptional(tree, "until", area.until);
  if (area.count) {
    setChild(tree, "count", number(*area.count));
  }
  setUnknown(tree, area.unknown);
  return tree;
}

}  // namespace sim2d
