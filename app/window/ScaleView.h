#pragma once

#include <vector>

#include <QImage>
#include <QWidget>

#include "editor/look/Theme.h"

namespace app {

/// A picture of a map on which two points are marked by clicks; they can be dragged.
class ScaleView : public QWidget {
  Q_OBJECT
 public:
  ScaleView(QImage image, const editor::Theme& theme, QWidget* parent = nullptr);
  /// In pixels of the image from its lower left corner, in the order of clicking.
  const std::vector<QPointF>& points() const { return points_; }
  void setPoints(std::vector<QPointF> points);
  QSize sizeHint() const override { return {560, 420}; }

 Q_SIGNALS:
  void pointsChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QRectF imageRect() const;  // where it is drawn
  QPointF toImage(const QPointF& widget) const;
  QPointF toWidget(const QPointF& image) const;

  QImage image_;
  editor::Theme theme_;
  std::vector<QPointF> points_;
  int held_ = -1;
};

}  // namespace app
