#pragma once

#include <array>

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
  LaserHit,
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
  enum class Kind { Light, Dark };
  static Theme ofKind(Kind kind);
  static Theme light() { return ofKind(Kind::Light); }
  static Theme dark() { return ofKind(Kind::Dark); }
  /// The one that fits the palette of the desktop.
  static Theme fromSystem(const QPalette& system);

  Kind kind() const { return kind_; }
  bool isDark() const { return kind_ == Kind::Dark; }
  QColor color(Role role) const { return roles_[static_cast<std::size_t>(role)]; }
  QColor color(Role role, double alpha) const;
  QColor fill(Look look) const { return fills_[static_cast<std::size_t>(look)]; }
  QColor line(Look look) const { return lines_[static_cast<std::size_t>(look)]; }
  QColor outline(Look look) const;  // of a figure: darker on light, lighter on dark
  QColor head(Look look) const;     // light tint of the fill
  QColor feet(Look look) const;     // darker than the body

  QPalette palette() const;  // for QApplication::setPalette with the Fusion style
  QFont font(double points = 9.0, QFont::Weight weight = QFont::Normal) const;
  QFont figureFont(double points = 9.0) const;  // tabular digits where the font has them

 private:
  Kind kind_ = Kind::Light;
  std::array<QColor, static_cast<std::size_t>(Role::Count)> roles_;
  std::array<QColor, kLookCount> fills_, lines_;
};

/// WCAG contrast ratio, 1 … 21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace editor
