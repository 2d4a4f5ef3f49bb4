#pragma once

#include <memory>
#include <vector>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QWidget>

#include "editor/look/Theme.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {

/// Size of a new empty room.
class RoomDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RoomDialog(const editor::Theme& theme, QWidget* parent = nullptr);
  QSizeF size() const { return {width_->value(), height_->value()}; }  // of the free ground [m]
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

/// Resolution and place of an image that is to become a map: by two points whose distance is known,
/// or by number.
class ImageMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `grid`: the cells of the image, `image`: what is shown.
  ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                 const editor::Theme& theme, QWidget* parent = nullptr);
  ScaleView& view() { return *view_; }
  double resolution() const;  // [m] per pixel, as measured
  bool isMeasured() const;    // enough is said to make a map, and of a size that a map can have
  /// With the resolution and so placed that the first point has its coordinates; without points:
  /// the lower left corner of the image.
  std::shared_ptr<const sim2d::OccupancyGrid> map() const;

 private:
  QLayout* makeSide();
  void measure();          // and shows what comes of it
  double pixels() const;   // between the two points; 0: there are not two
  bool isInRange() const;  // the resolution
  QString hint() const;    // what to do with the points

  std::shared_ptr<const sim2d::OccupancyGrid> grid_;
  editor::Theme theme_;
  ScaleView* view_;
  QRadioButton* byPoints_;
  QRadioButton* byNumber_;
  QDoubleSpinBox* distance_;
  QDoubleSpinBox* resolution_;
  QDoubleSpinBox* firstX_;
  QDoubleSpinBox* firstY_;
  QLabel* hint_;
  QLabel* place_;
  QLabel* size_;
  QPushButton* create_ = nullptr;
};

}  // namespace app
