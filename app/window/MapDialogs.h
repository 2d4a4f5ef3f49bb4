#pragma once

#include <memory>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include "app/window/ScaleView.h"
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

/// Resolution and place of an image that is to become a map: by two points whose distance is known,
/// or by number.
class ImageMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// `grid`: the cells of the image, `image`: what is shown.
  ImageMapDialog(std::shared_ptr<const sim2d::OccupancyGrid> grid, QImage image,
                 const editor::Theme& theme, QWidget* parent = nullptr);
  ScaleView& view() { return *view_; }
  void setDistance(double metres) { distance_->setValue(metres); }
  void setResolution(double metresPerPixel);  // by number from now on
  void setFirstPoint(double x, double y);
  double resolution() const;  // [m] per pixel, as measured
  bool isMeasured() const;    // enough is said to make a map, and of a size that a map can have
  /// With the resolution and so placed that the first point has its coordinates; without points:
  /// the lower left corner of the image.
  std::shared_ptr<const sim2d::OccupancyGrid> map() const;

 private:
  QLayout* makeSide();
  void measure();
  void showState();
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
