#include "editor/panels/RobotPicture.h"

#include <algorithm>

#include <QPainter>

#include "editor/canvas/EntityItem.h"
#include "editor/look/FigurePainter.h"

namespace editor {

namespace {

constexpr double kPictureEdgePx = 12.0;  // from the sides of the dock
constexpr double kBodyShare = 0.5;       // of the width
constexpr double kMeasurePx = 20.0;      // for a line of size and its number
constexpr double kBesidePx = 52.0;       // and where that stands beside the body
constexpr double kFigureRowPx = 20.0;    // as rows of the section "Now"
constexpr double kTickPx = 3.0;

QRectF boxOf(const sim2d::ResolvedRobot& robot) {
  if (robot.footprint.empty()) {
    return around({}, robot.radius);
  }
  QPolygonF corners;
  for (const base::Vec2& corner : robot.footprint) {
    corners << QPointF(corner.x(), -corner.y());
  }
  return corners.boundingRect();
}

QString driveWord(sim2d::Kinematics kinematics) {
  switch (kinematics) {
    case sim2d::Kinematics::Omnidirectional:
      return QObject::tr("any way");
    case sim2d::Kinematics::Ackermann:
      return QObject::tr("as a car");
    default:
      return QObject::tr("differential");
  }
}

QString lengthWords(double metres) {
  return QObject::tr("%1 m").arg(metres, 0, 'f', 2);
}

/// A line between two ticks, and how long that is in the middle.
void paintMeasure(QPainter& painter, const QLineF& line, const QString& words,
                  const QColor& ground) {
  const QPointF tick = QPointF(-line.unitVector().dy(), line.unitVector().dx()) * kTickPx;
  painter.drawLine(line);
  for (const QPointF& end : {line.p1(), line.p2()}) {
    painter.drawLine(end - tick, end + tick);
  }
  QRectF text = QFontMetricsF(painter.font()).boundingRect(words).adjusted(-4.0, 0.0, 4.0, 0.0);
  text.moveCenter(line.center());
  painter.fillRect(text, ground);
  painter.drawText(text, Qt::AlignCenter, words);
}

}  // namespace

RobotPicture::RobotPicture(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Body of the robot"));
}

void RobotPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void RobotPicture::show(const std::optional<sim2d::ResolvedRobot>& robot) {
  robot_ = robot;
  setVisible(robot.has_value());
  if (robot) {
    const QSizeF size = sizeOf(*robot);
    QStringList words = {
        tr("%1 long, %2 wide").arg(lengthWords(size.width()), lengthWords(size.height()))};
    for (const auto& [name, figure] : figuresOf(*robot)) {
      words << name + QLatin1Char(' ') + figure;
    }
    setToolTip(words.join(QLatin1Char('\n')));
    setAccessibleDescription(words.join(QStringLiteral(", ")));
  }
  update();
}

QSizeF RobotPicture::sizeOf(const sim2d::ResolvedRobot& robot) {
  return boxOf(robot).size();
}

QList<std::pair<QString, QString>> RobotPicture::figuresOf(const sim2d::ResolvedRobot& robot) {
  const auto number = [](double value, const char* unit) {
    return QStringLiteral("%1 %2").arg(value, 0, 'f', 2).arg(QString::fromUtf8(unit));
  };
  const bool isCar = robot.kinematics == sim2d::Kinematics::Ackermann;
  return {{tr("Drive"), driveWord(robot.kinematics)},
          {tr("Speed"), number(robot.maxVel, "m/s")},
          isCar ? std::pair(tr("Circle"), number(robot.turningRadius, "m"))
                : std::pair(tr("Turn"), number(robot.maxOmega, "rad/s")),
          {tr("Mass"), QStringLiteral("%1 kg").arg(robot.mass, 0, 'f', 1)}};
}

void RobotPicture::paintEvent(QPaintEvent* /*event*/) {
  if (!robot_) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF all = QRectF(rect()).adjusted(kPictureEdgePx, 8.0, -kPictureEdgePx, -8.0);
  QRectF left = all;
  left.setWidth(kBodyShare * all.width());
  paintBody(painter, left);
  paintFigures(painter, all.adjusted(left.width() + kPictureEdgePx, 0.0, 0.0, 0.0));
}

void RobotPicture::paintBody(QPainter& painter, const QRectF& room) const {
  const QRectF box = boxOf(*robot_);
  constexpr double kWithWheels = 1.16;
  const bool isDisc = robot_->footprint.empty();
  const QRectF place = room.adjusted(isDisc ? 0.0 : kBesidePx, 0.0, 0.0, -kMeasurePx);
  const double scale =
      std::min(place.width() / box.width(), place.height() / (kWithWheels * box.height()));
  const QPointF origin = place.center() - scale * box.center();
  painter.save();
  painter.translate(origin);
  FigurePainter(theme_).robot(
      painter, robotFigure(robot_->radius, robot_->footprint, robot_->kinematics, 0.0, scale));
  painter.restore();
  const QRectF drawn(origin + scale * box.topLeft(), scale * box.size());
  painter.setFont(theme_.figureFont(9.0));
  painter.setPen(QPen(theme_.color(Role::TextSecondary), 1.0));
  const QColor ground = theme_.color(Role::Panel);
  const double below = room.bottom() - 0.5 * kMeasurePx + 2.0;
  const QString length = lengthWords(box.width());
  paintMeasure(painter, {drawn.left(), below, drawn.right(), below},
               isDisc ? QString::fromUtf8("⌀ ") + length : length, ground);
  if (!isDisc) {
    const double beside = room.left() + 0.46 * kBesidePx;
    paintMeasure(painter, {beside, drawn.top(), beside, drawn.bottom()}, lengthWords(box.height()),
                 ground);
  }
}

void RobotPicture::paintFigures(QPainter& painter, const QRectF& room) const {
  const auto figures = figuresOf(*robot_);
  const double height = static_cast<double>(figures.size()) * kFigureRowPx;
  QRectF row(room.left(), room.center().y() - 0.5 * height, room.width(), kFigureRowPx);
  painter.setFont(theme_.figureFont(9.0));
  const QFontMetricsF metrics(painter.font());
  double words = 0.0;
  for (const auto& [name, figure] : figures) {
    words = std::max(words, metrics.horizontalAdvance(name));
  }
  for (const auto& [name, figure] : figures) {
    painter.setPen(theme_.color(Role::TextSecondary));
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setPen(theme_.color(Role::Text));
    painter.drawText(row.adjusted(words + 8.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                     figure);
    row.translate(0.0, kFigureRowPx);
  }
}

}  // namespace editor
