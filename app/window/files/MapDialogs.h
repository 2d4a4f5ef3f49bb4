#pragma once

#include <memory>
#include <vector>

#include <QtWidgets>

#include "editor/look/Theme.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {

/// Asks for the size of a new empty room.
class RoomDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RoomDialog(const editor::Theme& theme, QWidget* parent = nullptr);
  QSizeF size() const { return {width_->value(), height_->value()}; }  // [m], inner size
  bool hasWalls() const { return walls_->isChecked(); }

 private:
  QRadioButton* walls_;
  QRadioButton* plane_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
};

/// Shows a map image in which the user marks two points by clicking and dragging.
class ScaleView : public QWidget {
  Q_OBJECT
 public:
  ScaleView(QImage image, const editor::Theme& theme, QWidget* parent = nullptr);
  /// The points in image pixels from the lower left corner, in order of clicking.
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
  QRectF imageRect() const;  // in widget coordinates
  QPointF toImage(const QPointF& widget) const;
  QPointF toWidget(const QPointF& image) const;

  QImage image_;
  editor::Theme theme_;
  std::vector<QPointF> points_;
  int draggedPoint_ = -1;
};

/// Asks for the resolution and origin of an image that becomes a map: by two points with a known
/// distance, or by number.
class ImageMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `grid`: the cells of the image; `image`: the displayed image.
  ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                 const editor::Theme& theme, QWidget* parent = nullptr);
  ScaleView& view() { return *view_; }
  double resolution() const;  // [m/pixel]
  bool isMeasured() const;    // the input is complete and valid
  /// The map with this resolution. The first point has the entered coordinates; without points, the
  /// lower left corner of the image has them.
  std::shared_ptr<const sim2d::OccupancyGrid> map() const;

 private:
  QLayout* makeSide();
  void measure();          // updates the result
  double pixels() const;   // [pixels] between the points; 0: fewer than two
  bool isInRange() const;  // whether the resolution is valid
  QString hint() const;    // instruction for the user

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
