#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QPixmap>

#include "sim2d/scenario/Scenario.h"

namespace editor {

/// What a colour is for. Widgets ask for roles, never for numbers.
enum class Role {
  Window,
  Panel,
  Text,
  TextSecondary,
  Line,
  Accent,
  AccentText,
  MapFree,
  MapOccupied,
  MapUnknown,
  CanvasOutside,
  ObstacleFill,
  ObstacleEdge,
  RowSelected,
  RowHover,
  Field,
  FieldEdge,
  Ok,
  Warning,
  WarningMark,
  Error,
  ErrorSoft,
  RobotBody,
  RobotFront,
  RobotLine,
  GoalPin,
  Past,
  ForceGoal,
  ForceSocial,
  ForceObstacle,
  ForceGroup,
  ForceTotal,
  Lidar,  // and whatever else a robot perceives
  Count
};

/// The seven looks of a person: the six behaviours, or a tree of one's own.
enum class Look { Regular, Impassive, Surprised, Scared, Curious, Threatening, CustomTree };
constexpr int kLookCount = 7;
enum class Mark { Disc, Square, Diamond, Ring, TriangleDown, TriangleUp, Hexagon };

Look lookOf(sim2d::BehaviorType type);
QString lookName(Look look);
Mark markOf(Look look);

/// All colours and fonts of the window, as a value. Whoever draws gets a const reference and a
/// setTheme to recolour at once; nothing is kept globally.
class Theme {
 public:
  explicit Theme(bool isDark = false) : isDark_(isDark) {}
  static Theme light() { return Theme(false); }
  static Theme dark() { return Theme(true); }
  /// The one that fits the palette of the desktop.
  static Theme fromSystem(const QPalette& system);

  bool isDark() const { return isDark_; }
  QColor color(Role role) const;
  QColor color(Role role, double alpha) const;
  QColor fill(Look look) const;
  QColor line(Look look) const;
  QColor outline(Look look) const;  // of a figure: darker on light, lighter on dark
  QColor head(Look look) const;     // light tint of the fill
  QColor feet(Look look) const;     // darker than the body

  QPalette palette() const;  // for QApplication::setPalette with the Fusion style
  QFont font(double points = 9.0, QFont::Weight weight = QFont::Normal) const;
  QFont figureFont(double points = 9.0) const;  // tabular digits where the font has them

 private:
  bool isDark_;
};

/// WCAG contrast ratio, 1 … 21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace editor
