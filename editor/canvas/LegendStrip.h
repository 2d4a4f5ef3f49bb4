#pragma once

#include <vector>

#include <QtWidgets>

#include "editor/canvas/MapLegend.h"

namespace editor {

class MapView;

/// The legend over a corner of a view. The view keeps its size and zoom, and receives the mouse
/// events.
class LegendStrip : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kCorners = 3;  // 0: top right, 1: top left, 2: bottom right.
  explicit LegendStrip(MapView& view);
  /// Sets the contents. A brief legend shows only the rows that have a sign, a name and a value.
  void setParts(std::vector<LegendPart> parts);
  /// Shows only the signs and values of the rows, without their names. Applies to the next
  /// contents.
  void setBrief(bool brief) { isBrief_ = brief; }
  bool isEmpty() const { return parts_.empty(); }
  void setCorner(int corner) { corner_ = corner; }
  /// The place in a corner of `room` [px of the view].
  QRect boxAt(int corner, const QRect& room) const;
  /// Moves it into its corner of `room`. It does not become narrower while it is visible, so that
  /// it does not move with the digits of its values.
  void place(const QRect& room);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double rowWidth(const LegendRow& row) const;
  QSize fittingSize() const;
  double paintPart(QPainter& painter, const LegendPart& part, const QRectF& room) const;

  MapView& view_;
  std::vector<LegendPart> parts_;
  int corner_ = 0;
  bool isBrief_ = false;
};

}  // namespace editor
