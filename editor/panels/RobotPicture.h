#pragma once

#include <optional>

#include <QWidget>

#include "editor/look/Theme.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

/// The body of a robot from above, its front to the right: footprint to scale, wheels, and how long
/// and wide it is [m]; beside it what its drive can do.
class RobotPicture : public QWidget {
  Q_OBJECT
 public:
  explicit RobotPicture(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// None: several with different bodies.
  void show(const std::optional<sim2d::ResolvedRobot>& robot);
  QSize sizeHint() const override { return {200, 128}; }

  /// Of the box round the footprint: along the robot and across [m].
  static QSizeF sizeOf(const sim2d::ResolvedRobot& robot);
  /// What is written beside the body: a word and its figure.
  static QList<std::pair<QString, QString>> figuresOf(const sim2d::ResolvedRobot& robot);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBody(QPainter& painter, const QRectF& room) const;
  void paintFigures(QPainter& painter, const QRectF& room) const;

  Theme theme_;
  std::optional<sim2d::ResolvedRobot> robot_;
};

}  // namespace editor
