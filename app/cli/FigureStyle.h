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

/// Overlays of the map in a figure.
enum class FigureOverlay { Density, Zones, Gaussian, Velocities, Forces, Contacts };
/// "density", "zones" … in enum order.
const std::vector<std::string>& figureOverlayNames();

struct FigureOptions {
  std::set<FigureOverlay> overlays;
  double timeMarks = 0.0;  // [s] between two marks on trajectories; 0: none
  bool names = true;       // below the bodies
};

/// The layout of a figure. Pixels are those of CSS, 96 per inch.
struct PictureLayout {
  double width = 1600.0;         // [px]; below 900 the figure is for a column or page of a paper
  std::optional<double> height;  // [px]; nullopt: as the map requires
  bool textAsOutlines = false;   // looks the same where the fonts are missing
  FigureOptions options;
};

/// Sizes derived from the width [px].
struct FigureSizes {
  explicit FigureSizes(double width) : isNarrow(width < 900.0) {}
  bool isNarrow;
  double margin() const { return isNarrow ? 10.0 : 32.0; }  // around the map
  double legend() const { return isNarrow ? 0.0 : 300.0; }  // beside the map
  double row() const { return isNarrow ? 16.0 : 26.0; }
  double column() const { return 150.0; }                 // minimum width, legend below the map
  double foot() const { return isNarrow ? 24.0 : 32.0; }  // with the scale
  double title() const { return isNarrow ? 9.0 : 12.0; }  // pt
  double text() const { return isNarrow ? 8.0 : 9.5; }
  double small() const { return isNarrow ? 8.0 : 9.0; }
  double body() const { return isNarrow ? 5.0 : 7.0; }  // the minimum radius of a body symbol
  double line() const { return isNarrow ? 1.2 : 1.8; }
};

/// Draws text in figures on white, with the fonts of the light theme.
class FigureText {
 public:
  explicit FigureText(bool asOutlines) : asOutlines_(asOutlines) {}
  const editor::Theme& theme() const { return theme_; }
  void write(QPainter& painter, const QPointF& baseline, const QFont& font, editor::Role role,
             const QString& text) const;

 private:
  bool asOutlines_;
  editor::Theme theme_ = editor::Theme::light();
};

}  // namespace app
