#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QImage>
#include <QPainter>

#include "app/cli/FigureStyle.h"
#include "app/cli/RunTracks.h"
#include "editor/canvas/OverlayPainter.h"

namespace app {

/// The map of a run with its obstacles, and over it what happened up to a time: ways that fade from
/// light to full, starts as rings, goals as pins, bodies where they stand, overlays. One thread;
/// needs a QGuiApplication, and the trace as long as it lives.
class FigureMap {
 public:
  FigureMap(const sim2d::Trace& trace, const FigureMeasures& measures, const FigureText& text,
            const FigureOptions& options);

  QSizeF world() const { return world_.size(); }  // [m], of what is drawn
  /// Into the middle of this room [px].
  void place(const QRectF& room);
  const QRectF& mapRect() const { return mapRect_; }
  double wallsLeft() const;  // where what is drawn begins: the map keeps a little distance
  /// As it was at this time [s]; none: the whole run, everybody where they were seen last.
  void paint(QPainter& painter, std::optional<double> time);
  /// A bar of some metres at its left end.
  void paintScale(QPainter& painter, const QPointF& left) const;
  double lastTime() const;  // [s] of the run

  // for legends
  editor::Look lookOf(int person) const;
  QColor colorOf(int id) const;
  double scale() const { return frame_.scale; }        // [px/m]
  double densityMost() const { return densityMost_; }  // of what was painted last [1/m²]

 private:
  QRectF extent() const;
  QImage drawnMap() const;
  QImage cellImage(const sim2d::OccupancyGrid& grid) const;
  bool has(FigureOverlay overlay) const { return options_.overlays.count(overlay) > 0; }
  std::size_t frameNow() const;  // number of the state; the trace has some
  void paintObstacles() const;
  QPolygonF lineOf(const Track& track) const;
  void paintTrack(const Track& track) const;
  void paintStart(const Track& track) const;
  void paintTimeMarks() const;
  std::optional<std::size_t> placeOf(const Track& track) const;
  double radiusOf(const Track& track) const;
  void paintBody(const Track& track) const;
  void label(const Track& track) const;
  void paintGoals() const;
  void pin(const QString& number) const;
  void paintGround();
  void paintTop() const;
  void paintForces(const editor::OverlayPainter& over) const;

  const sim2d::Trace& trace_;
  const FigureMeasures measures_;
  const FigureText& text_;
  const editor::Theme& theme_;
  const FigureOptions options_;
  const std::map<int, Track> tracks_;
  const std::vector<sim2d::ContactMark> contacts_;
  const editor::FigurePainter figures_;
  const QRectF world_;
  QPainter* painter_ = nullptr;  // while something is painted
  bool isWhole_ = true;
  double time_ = 0.0;  // [s] that is painted
  editor::PictureFrame frame_;
  QRectF mapRect_;
  QImage map_;
  double densityMost_ = 0.0;
};

/// Whole metres that a bar of the scale may stand for.
double barLength(double pixelsPerMetre, double longest);

}  // namespace app
