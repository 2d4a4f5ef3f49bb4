#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <QImage>
#include <QPainter>

#include "editor/canvas/MapScene.h"
#include "sim2d/trace/Frame.h"

namespace editor {

/// Prices of the ways that a planner weighed, as colours show them.
struct PriceScale {
  double low = 0.0, high = 0.0;  // best, and what nine in ten of those that may be driven cost
  std::size_t open = 0, refused = 0;
};
PriceScale priceScaleOf(const std::vector<sim2d::RobotSenses::Way>& ways);
/// 0 at the best, 1 at the high end and beyond.
double priceShare(const PriceScale& scale, double cost);
/// From blue over mauve to orange: apart to who sees no red or no green.
QColor priceColor(const Theme& theme, double share);

/// Of a cell: clear where it is free, the stronger the dearer; what a round robot would touch,
/// obstacles and unknown ground have their own.
QColor costColor(const Theme& theme, std::uint8_t cost);
/// One pixel per cell, the highest y first.
QImage costImage(const sim2d::CostGrid& grid, const Theme& theme);
QRectF areaOf(const sim2d::CostGrid& grid);  // scene

/// The arc of a circle from a robot's place, in its direction, to a point: what pure pursuit turns
/// along. Straight where the point lies ahead.
std::vector<Vec2> pursuitArc(const Pose2& robot, const Vec2& target);

/// The robot whose planner is looked at: the one selected, else the first that tells anything.
struct LookedAt {
  const sim2d::RobotSenses* senses = nullptr;
  QString name;
};
std::optional<LookedAt> plannerLookedAt(const MapScene& scene);
/// Whether ways of it have parts of their price, which colours and legend tell.
bool hasPrices(const sim2d::RobotSenses& senses);

/// Draws in the scene what a planner like Nav2's tells of itself.
class PlannerPainter {
 public:
  explicit PlannerPainter(const Theme& theme) : theme_(theme) {}

  /// `image`: of the grid. `hole`: left out, as something nearer lies there; may be empty.
  void costs(QPainter& painter, const sim2d::CostGrid& grid, const QImage& image,
             const QRectF& hole = {}) const;
  /// The edge of a costmap that moves with the robot.
  void edge(QPainter& painter, const sim2d::CostGrid& grid) const;
  /// The dear ones first, the chosen one over all others.
  void ways(QPainter& painter, const std::vector<sim2d::RobotSenses::Way>& ways) const;
  /// What it aims at, the arc there, and where it means to go.
  void aim(QPainter& painter, const sim2d::RobotSenses& senses) const;

 private:
  void line(QPainter& painter, const std::vector<Vec2>& points, const QPen& pen) const;

  const Theme& theme_;
};

}  // namespace editor
