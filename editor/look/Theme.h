#pragma once

#include <QtWidgets>

#include "sim2d/scenario/Scenario.h"

namespace sim2d {
struct TraceHuman;
}

namespace editor {

/// The purpose of a colour. Widgets request colours by role only.
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
  Lidar,  // Also used for other robot perception.
  Guide,  // Alignment with other entities.
  Count
};

/// The seven appearances of a person: one for each of the six behaviours, and one for a custom
/// tree.
enum class Look { Regular, Impassive, Surprised, Scared, Curious, Threatening, CustomTree };
constexpr int kLookCount = 7;
enum class Mark { Disc, Square, Diamond, Ring, TriangleDown, TriangleUp, Hexagon };

Look lookOf(sim2d::BehaviorType type);
Look lookOf(const sim2d::TraceHuman& recorded);
QString lookName(Look look);
Mark markOf(Look look);

/// The colour with another opacity, 0 … 1.
inline QColor withAlpha(QColor color, double alpha) {
  color.setAlphaF(alpha);
  return color;
}

/// The colour, including alpha, between `a` (share 0) and `b` (share 1).
QColor mixed(const QColor& a, const QColor& b, double share);

/// All colours and fonts of the window, as a value. A class that draws takes a const reference and
/// offers a setTheme that changes the colours immediately. There is no global theme.
class Theme {
 public:
  explicit Theme(bool isDark = false) : isDark_(isDark) {}
  static Theme light() { return Theme(false); }
  static Theme dark() { return Theme(true); }
  /// The theme that matches the desktop palette.
  static Theme fromSystem(const QPalette& system);

  bool isDark() const { return isDark_; }
  QColor color(Role role) const;
  QColor color(Role role, double alpha) const { return withAlpha(color(role), alpha); }
  QColor fill(Look look) const;
  QColor line(Look look) const;
  QColor outline(Look look) const;  // Outline of a figure: darker on light, lighter on dark themes.
  QColor head(Look look) const { return mixed(fill(look), Qt::white, 0.72); }  // A light tint.
  QColor feet(Look look) const { return mixed(fill(look), Qt::black, 0.5); }   // Darker.

  QPalette palette() const;      // For QApplication::setPalette with the Fusion style.
  QPalette textPalette() const;  // The same for text fields: selected text is clearly visible.
  QFont font(double points = 9.0, QFont::Weight weight = QFont::Normal) const;
  QFont figureFont(double points = 9.0) const;  // With tabular digits where the font has them.

 private:
  bool isDark_;
};

/// WCAG contrast ratio, 1 … 21.
double contrastRatio(const QColor& a, const QColor& b);

}  // namespace editor
