#include "editor/canvas/Tool.h"

#include <cmath>

#include "editor/canvas/EntityItem.h"
#include "editor/document/EditCommands.h"
#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

double toStep(double value, double step) {
  return editor::rounded(std::round(value / step) * step);
}

/// With that number of decimals; not "-0.0".
QString fixedText(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return QString::number(std::round(value * scale) / scale + 0.0, 'f', decimals);
}

Vec2 onAngle(const Vec2& anchor, const Vec2& world) {
  const Vec2 offset = world - anchor;
  const Vec2 direction = base::directionOf(snappedAngle(base::headingOf(offset)));
  return anchor + toStep(std::max(0.0, offset.dot(direction)), 0.01) * direction;
}

/// The nearest point of another entity within reach.
std::optional<Vec2> pointNear(const MapScene& scene, const CanvasMouse& mouse,
                              const SnapRequest& wish) {
  std::optional<Vec2> nearest;
  double reach = kSnapReachPx / mouse.pixelsPerMetre;
  const auto offer = [&](const std::vector<Vec2>& points) {
    for (const Vec2& point : points) {
      const double distance = (point - mouse.world).norm();
      if (distance <= reach) {
        reach = distance;
        nearest = point;
      }
    }
  };
  const auto offerAll = [&](const auto& list) {
    for (const auto& value : list) {
      const auto& without = wish.without;
      if (std::find(without.begin(), without.end(), value.key) == without.end()) {
        offer(snapPointsOf(value));
      }
    }
  };
  const sim2d::Scenario& scenario = scene.document().scenario();
  offerAll(scenario.obstacles);
  offerAll(scenario.doors);
  offerAll(scenario.areas);
  offerAll(scenario.goals);
  offerAll(scenario.robots);
  offerAll(scenario.docks);
  offer(wish.more);
  return nearest;
}

constexpr double kMaxCells = 40.0;  // Search limit to each side at any zoom.
constexpr int kLeg = 3;             // Minimum length of the edges of a corner in cells.

/// Borders between wall and non-wall cells; lattice points are the corners of cells.
struct Borders {
  const sim2d::OccupancyGrid& grid;

  bool isWall(int column, int row) const { return grid.isWall({column, row}); }
  /// The border from a lattice point to the next one on the right, or above.
  bool goesRight(int column, int row) const {
    return isWall(column, row - 1) != isWall(column, row);
  }
  bool goesUp(int column, int row) const { return isWall(column - 1, row) != isWall(column, row); }

  bool isCorner(int column, int row) const {
    const bool right = goesRight(column, row);
    const bool left = goesRight(column - 1, row);
    const bool up = goesUp(column, row);
    const bool down = goesUp(column, row - 1);
    if (right == left || up == down) {
      return false;
    }
    for (int i = 0; i < kLeg; ++i) {
      if (!goesRight(right ? column + i : column - 1 - i, row) ||
          !goesUp(column, up ? row + i : row - 1 - i)) {
        return false;
      }
    }
    return true;
  }
};

/// The nearest of the offered points, the first one on ties; in cells.
struct NearestPlace {
  Vec2 at = Vec2::Zero();
  double reach = 0.0;
  std::optional<Vec2> place;

  void offer(const Vec2& candidate) {
    const double distance = (candidate - at).norm();
    if (place ? distance < reach : distance <= reach) {
      place = candidate;
      reach = distance;
    }
  }
};

}  // namespace

Tool::Tool(ScenarioDocument& document, MapScene& scene, QObject* parent)
    : QObject(parent), document_(document), scene_(scene) {}

Vec2 Tool::snap(const CanvasMouse& mouse, const SnapRequest& wish) const {
  const Snapped result = snapped(scene_, mouse, wish);
  marks().snapMark = result.isOnPoint ? std::optional<Vec2>(result.point) : std::nullopt;
  return result.point;
}

Vec2 Tool::snapToGrid(const CanvasMouse& mouse) const {
  return snapped(scene_, mouse, {std::nullopt, {}, {}, false}).point;
}

Alignment Tool::align(const CanvasMouse& mouse, const Extent& moving,
                      const std::vector<EntityId>& without) const {
  marks().guides = alignedOnCanvas(scene_, mouse, moving, without);
  return marks().guides;
}

Vec2 Tool::snapAligned(const CanvasMouse& mouse, const SnapRequest& wish) const {
  marks().guides = {};
  const Snapped result = snapped(scene_, mouse, wish);
  marks().snapMark = result.isOnPoint ? std::optional<Vec2>(result.point) : std::nullopt;
  const bool isOnAngle = wish.anchor && mouse.modifiers.testFlag(Qt::ShiftModifier);
  if (result.isOnPoint || isOnAngle) {
    return result.point;
  }
  const Alignment aligned = align(mouse, {mouse.world, mouse.world}, wish.without);
  const Vec2 exact = mouse.world + aligned.offset;
  return {aligned.isAligned[0] ? exact.x() : result.point.x(),
          aligned.isAligned[1] ? exact.y() : result.point.y()};
}

void Tool::clearMarks() {
  scene_.clearPreview();
  marks() = {};
  Q_EMIT statusTextChanged();
}

bool isDrag(const Vec2& from, const CanvasMouse& mouse) {
  return (mouse.world - from).norm() * mouse.pixelsPerMetre >= kDragPx;
}

QString placeText(const Vec2& world) {
  return QStringLiteral("%1, %2 m").arg(fixedText(world.x(), 2), fixedText(world.y(), 2));
}

QString headingText(double heading) {
  return fixedText(heading * 180.0 / base::kPi, 1) + QStringLiteral("°");
}

QString legText(const Vec2& from, const Vec2& to) {
  return QStringLiteral("%1 m · %2")
      .arg((to - from).norm(), 0, 'f', 2)
      .arg(headingText(base::headingOf(to - from)));
}

std::optional<Vec2> nearestOnWalls(const sim2d::OccupancyGrid& grid, const Vec2& world,
                                   double reach) {
  if (grid.isEmpty()) {
    return std::nullopt;
  }
  const Borders borders{grid};
  const Vec2 at = grid.worldToCorner(world);
  const double cells = std::min(reach / grid.resolution(), kMaxCells);
  const auto low = [cells](double value) { return static_cast<int>(std::floor(value - cells)); };
  const auto high = [cells](double value) { return static_cast<int>(std::ceil(value + cells)); };
  NearestPlace corner{at, cells, {}};
  NearestPlace edge = corner;
  for (int row = low(at.y()); row <= high(at.y()); ++row) {
    for (int column = low(at.x()); column <= high(at.x()); ++column) {
      const Vec2 point(column, row);
      if (borders.goesRight(column, row)) {
        edge.offer({std::clamp(at.x(), point.x(), point.x() + 1.0), point.y()});
      }
      if (borders.goesUp(column, row)) {
        edge.offer({point.x(), std::clamp(at.y(), point.y(), point.y() + 1.0)});
      }
      if (borders.isCorner(column, row)) {
        corner.offer(point);
      }
    }
  }
  const std::optional<Vec2> best = corner.place ? corner.place : edge.place;
  return best ? std::optional<Vec2>(grid.cornerToWorld(best->x(), best->y())) : std::nullopt;
}

double snappedAngle(double heading, double step) {
  return base::wrapToPi(std::round(heading / step) * step + 0.0);  // Avoids -0.
}

namespace {

constexpr std::size_t kMaxGuideBoxes = 24;  // With more, every position would be aligned.
constexpr double kGuideRangePx = 1200.0;
constexpr double kStraight = 0.005;  // Deviation of a box from the axes [quarter turns].

double distanceOf(const Extent& a, const Extent& b) {
  const Vec2 gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec2(Vec2::Zero()));
  return gap.norm();
}

}  // namespace

std::optional<Extent> guideBoxOf(const Entity& entity) {
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Box) {
    const double quarters = obstacle->pose.heading / (0.5 * base::kPi);
    if (std::abs(quarters - std::round(quarters)) > kStraight) {
      return Extent{obstacle->pose.position, obstacle->pose.position};
    }
  }
  return extentOf(entity);
}

std::optional<Extent> guideBoxOfSelection(const ScenarioDocument& document) {
  std::vector<Vec2> corners;
  for (const Entity& value : valuesOf(document, document.selection())) {
    if (const std::optional<Extent> extent = guideBoxOf(value)) {
      corners.insert(corners.end(), {extent->low, extent->high});
    }
  }
  return extentOf(corners);
}

Alignment alignedOnCanvas(const MapScene& scene, const CanvasMouse& mouse, const Extent& moving,
                          const std::vector<EntityId>& without) {
  if (!scene.options().guides || mouse.modifiers.testFlag(Qt::AltModifier) ||
      mouse.modifiers.testFlag(Qt::ControlModifier)) {
    return {};
  }
  std::vector<std::pair<double, Extent>> found;
  forEachList(scene.document().scenario(), [&](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      const EntityItem* item = scene.item(value.key);
      const bool isMeant = item != nullptr && item->isVisible() &&
                           std::find(without.begin(), without.end(), value.key) == without.end();
      const std::optional<Extent> extent = isMeant ? guideBoxOf(Entity(value)) : std::nullopt;
      const double distance = extent ? distanceOf(*extent, moving) : 0.0;
      if (extent && distance * mouse.pixelsPerMetre <= kGuideRangePx) {
        found.emplace_back(distance, *extent);
      }
    }
  });
  const auto end =
      found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kMaxGuideBoxes));
  std::partial_sort(found.begin(), end, found.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Extent> others;
  std::transform(found.begin(), end, std::back_inserter(others),
                 [](const auto& each) { return each.second; });
  return alignmentOf(moving, others, kGuideReachPx / mouse.pixelsPerMetre);
}

std::vector<Vec2> snapPointsOf(const Entity& entity) {
  if (kindOf(entity) == EntityKind::Human) {
    return {};
  }
  std::vector<Vec2> points = pointsOf(entity);
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  if (obstacle != nullptr && obstacle->kind == sim2d::ObstacleKind::Box) {
    const auto corners = sim2d::boxOutline(obstacle->pose, obstacle->length, obstacle->width);
    points.insert(points.begin(), corners.points.begin(), corners.points.end());
  }
  const auto* robot = std::get_if<sim2d::Robot>(&entity);
  if (robot != nullptr && robot->goal.point) {
    points.push_back(*robot->goal.point);
  }
  return points;
}

Snapped snapped(const MapScene& scene, const CanvasMouse& mouse, const SnapRequest& wish) {
  if (mouse.modifiers.testFlag(Qt::AltModifier)) {
    return {mouse.world, false};
  }
  if (wish.anchor && mouse.modifiers.testFlag(Qt::ShiftModifier)) {
    return {onAngle(*wish.anchor, mouse.world), false};
  }
  if (wish.ontoPoints && scene.options().snapToPoints) {
    if (const std::optional<Vec2> onPoint = pointNear(scene, mouse, wish)) {
      return {*onPoint, true};
    }
  }
  const bool isHeld = mouse.modifiers.testFlag(Qt::ControlModifier);
  if (wish.ontoPoints && wish.ontoWalls && scene.options().snapToWalls && !isHeld) {
    const std::optional<Vec2> onWall =
        nearestOnWalls(*scene.document().map(), mouse.world, kSnapReachPx / mouse.pixelsPerMetre);
    if (onWall) {
      return {*onWall, true};
    }
  }
  const bool onGrid = scene.options().snapToGrid || isHeld;
  const double step = onGrid ? kSnapGrid : 0.01;
  return {Vec2(toStep(mouse.world.x(), step), toStep(mouse.world.y(), step)), false};
}

}  // namespace editor
