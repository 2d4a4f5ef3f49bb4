#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QRadioButton>

#include "editor/look/Theme.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {

/// Size of a new empty room.
class RoomDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RoomDialog(const editor::Theme& theme, QWidget* parent = nullptr);
  QSizeF size() const;  // of the free ground [m]
  bool hasWalls() const { return walls_->isChecked(); }

 private:
  QRadioButton* walls_;
  QRadioButton* plane_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
};

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

/// Resolution and place of an image that is to become a map: by number, or by two points whose
/// distance is known.
class ImageMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `grid`: the cells of the image, `image`: what is shown.
  ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                 const editor::Theme& theme, QWidget* parent = nullptr);
  ScaleView& view() { return *view_; }
  void setDistance(double metres) { distance_->setValue(metres); }
  void setFirstPoint(double x, double y);
  double resolution() const { return resolution_->value(); }  // [m] per pixel
  /// With the resolution and so placed that the first point has its coordinates.
  std::shared_ptr<const sim2d::OccupancyGrid> map() const;

 private:
  void build();
  void measure();
  void showSize();

  std::shared_ptr<const sim2d::OccupancyGrid> grid_;
  editor::Theme theme_;
  ScaleView* view_;
  QDoubleSpinBox* distance_;
  QDoubleSpinBox* resolution_;
  QDoubleSpinBox* firstX_;
  QDoubleSpinBox* firstY_;
  QLabel* hint_;
  QLabel* size_;
};

}  // namespace app
