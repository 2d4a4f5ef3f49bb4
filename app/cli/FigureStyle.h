#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QPainter>
#include <QPointF>
#include <QString>

#include "editor/look/Theme.h"

namespace app {

/// What lies over the map of a figure when it is asked for.
enum class FigureOverlay { Density, Zones, Gaussian, Velocities, Forces, Contacts };
/// "density", "zones" … in this order.
const std::vector<std::string>& figureOverlayNames();

struct FigureOptions {
  std::set<FigureOverlay> overlays;
  double timeMarks = 0.0;  // [s] between two marks on ways; 0: none
  bool names = true;       // below the bodies
};

/// How a figure is laid out. Pixels are those of CSS, 96 to an inch.
struct PictureLayout {
  double width = 1600.0;         // [px]; below 900 it is one for a column or page of a paper
  std::optional<double> height;  // [px]; none: as high as the map wants it
  bool textAsOutlines = false;   // shown the same where the fonts are not
  FigureOptions options;
};

/// Sizes that follow from the width [px].
struct FigureMeasures {
  explicit FigureMeasures(double width) : isNarrow(width < 900.0) {}
  bool isNarrow;
  double margin() const { return isNarrow ? 10.0 : 32.0; }  // around the map
  double legend() const { return isNarrow ? 0.0 : 300.0; }  // beside it
  double row() const { return isNarrow ? 16.0 : 26.0; }
  double column() const { return 150.0; }                 // of the legend below the map, at least
  double foot() const { return isNarrow ? 24.0 : 32.0; }  // with the scale
  double title() const { return isNarrow ? 9.0 : 12.0; }  // pt
  double text() const { return isNarrow ? 8.0 : 9.5; }
  double small() const { return isNarrow ? 8.0 : 9.0; }
  double body() const { return isNarrow ? 5.0 : 7.0; }  // the least radius of a figure
  double line() const { return isNarrow ? 1.2 : 1.8; }
};

/// Writes the words of figures: white ground, fonts of the light theme.
class FigureText {
 public:
  explicit FigureText(bool asOutlines) : asOutlines_(asOutlines) {}
  const editor::Theme& theme() const { return theme_; }
  void write(QPainter& painter, const QPointF& baseline, const QFont& font, editor::Role role,
             const QString& words) const;

 private:
  bool asOutlines_;
  editor::Theme theme_ = editor::Theme::light();
};

}  // namespace app
