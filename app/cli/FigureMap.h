#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPointF>
#include <QString>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/OverlayPainter.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// Overlays of the map in a figure.
enum class FigureOverlay { Density, Zones, Gaussian, Velocities, Forces, Contacts };
/// "density", "zones" … in enum order.
const std::vector<std::string>& figureOverlayNames();

struct FigureOptions {
  std::set<FigureOverlay> overlays;
  double timeMarks = 0.0;     // [s] between two marks on trajectories; 0: none
  bool names = true;          // below the bodies
  bool isDark = false;        // in the colours of the dark theme
  std::set<int> customTrees;  // further people with custom trees, by id: older traces lack them
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

/// Draws text in figures, and has their theme.
class FigureText {
 public:
  explicit FigureText(bool asOutlines, bool isDark = false)
      : asOutlines_(asOutlines), theme_(isDark) {}
  const editor::Theme& theme() const { return theme_; }
  void write(QPainter& painter, const QPointF& baseline, const QFont& font, editor::Role role,
             const QString& text) const;

 private:
  bool asOutlines_;
  editor::Theme theme_;
};

/// The trajectory of a body and its appearance.
struct Track {
  int id = 0;                           // of robots: below 0
  std::vector<sim2d::Vec2> points;      // [m]
  std::vector<double> times;            // [s], per point
  std::vector<double> headings;         // [rad], per point
  std::vector<sim2d::Vec2> velocities;  // [m/s], per point
  QString name;
  double radius = 0.35;  // [m]

  /// The number of points up to this time.
  std::size_t countUntil(double time) const {
    const auto end = std::upper_bound(times.begin(), times.end(), time);
    return static_cast<std::size_t>(end - times.begin());
  }
};

/// Of all bodies, by id.
std::map<int, Track> tracksOf(const sim2d::Trace& trace);

/// The map of a run with its obstacles, and the state up to a time: trajectories that fade from
/// light to full, starts as rings, goals as pins, bodies and overlays. One thread; requires a
/// QGuiApplication. The trace must outlive it.
class FigureMap {
 public:
  FigureMap(const sim2d::Trace& trace, const FigureSizes& sizes, const FigureText& text,
            const FigureOptions& options);

  QSizeF world() const { return world_.size(); }  // [m], of the drawn area
  /// Centres the map in this rectangle [px].
  void place(const QRectF& room);
  const QRectF& mapRect() const { return mapRect_; }
  double drawnLeft() const;  // the left edge of the drawn area without its margin [px]
  /// Paints the state at this time [s]; nullopt: the whole run, with all bodies at their last
  /// positions.
  void paint(QPainter& painter, std::optional<double> time);
  /// Paints a scale bar; `left`: its left end.
  void paintScale(QPainter& painter, const QPointF& left) const;
  double lastTime() const;  // [s] of the run

  // For legends.
  editor::Look lookOf(int person) const;
  QColor colorOf(int id) const;
  bool hasPaths() const { return trace_.frames.size() > 1; }  // not only the start
  double scale() const { return frame_.scale; }               // [px/m]
  double maxDensity() const { return maxDensity_; }           // of the last paint() [1/m²]
  /// The names of the last paint() [px]; null: left out.
  const std::vector<QRectF>& nameRects() const { return nameRects_; }

 private:
  QRectF extent() const;
  QImage drawnMap() const;
  QImage cellImage(const sim2d::OccupancyGrid& grid) const;
  bool has(FigureOverlay overlay) const { return options_.overlays.count(overlay) > 0; }
  std::size_t currentFrame() const;  // index of the frame; requires at least one
  void paintObstacles() const;
  QPolygonF lineOf(const Track& track) const;
  void paintTrack(const Track& track) const;
  void paintStart(const Track& track) const;
  void paintTimeMarks() const;
  std::optional<std::size_t> positionIndexOf(const Track& track) const;
  double radiusOf(const Track& track) const;
  void paintBody(const Track& track) const;
  std::vector<editor::Label> nameLabels(const QFontMetricsF& metrics) const;
  void paintNames();
  void paintGoals() const;
  void pin(const QString& number) const;
  void paintGround();
  void paintTop() const;
  void paintForces(const editor::OverlayPainter& over) const;

  const sim2d::Trace& trace_;
  const FigureSizes sizes_;
  const FigureText& text_;
  const editor::Theme& theme_;
  const FigureOptions options_;
  const std::map<int, Track> tracks_;
  const std::vector<sim2d::ContactMark> contacts_;
  const editor::FigurePainter figures_;
  const QRectF world_;
  QPainter* painter_ = nullptr;  // during paint()
  bool isWhole_ = true;
  double time_ = 0.0;  // [s] of the painted state
  editor::PictureTransform frame_;
  QRectF mapRect_;
  QImage map_;
  double maxDensity_ = 0.0;
  std::vector<QRectF> nameRects_;
  std::map<QString, int> sides_;  // of names in the last painted state
};

/// A length in whole metres for the scale bar.
double barLength(double pixelsPerMetre, double longest);

}  // namespace app
