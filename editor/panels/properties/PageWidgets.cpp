#include "editor/panels/properties/PageWidgets.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "editor/canvas/EntityItem.h"
#include "editor/document/EntityModel.h"
#include "editor/look/FigurePainter.h"

namespace editor {

namespace {

constexpr int kChipHeight = 24;
constexpr int kRowGap = 4;
constexpr int kLineHeight = 28;

}  // namespace

/// One goal; drawn as a pill, with an arrow before all but the first.
class RouteEditor::Chip : public QToolButton {
 public:
  /// `remove`: action of Delete.
  Chip(const QString& text, bool first, std::function<void()> remove, QWidget* parent)
      : QToolButton(parent), first_(first), remove_(std::move(remove)) {
    setText(text);
  }
  QSize sizeHint() const override {
    const int text = fontMetrics().horizontalAdvance(this->text());
    return {std::max(28, text + 16) + (first_ ? 0 : kArrow), kChipHeight};
  }

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride && isRemoving(*event)) {
      event->accept();  // Overrides the window shortcut, which removes the map selection.
      return true;
    }
    return QToolButton::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override {
    isRemoving(*event) ? remove_() : QToolButton::keyPressEvent(event);
  }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF pill = QRectF(rect()).adjusted(first_ ? 0.5 : kArrow + 0.5, 0.5, -0.5, -0.5);
    painter.setPen(
        QPen(palette().color(hasFocus() || underMouse() ? QPalette::Link : QPalette::Mid),
             hasFocus() ? 2.0 : 1.0));
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawRoundedRect(pill, pill.height() / 2, pill.height() / 2);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(pill, Qt::AlignCenter, text());
    if (!first_) {
      painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.4, Qt::SolidLine,
                          Qt::RoundCap, Qt::RoundJoin));
      painter.translate(kArrow / 2.0 - 1.0, height() / 2.0);
      painter.drawPolyline(QPolygonF({{-1.5, -3.0}, {1.5, 0.0}, {-1.5, 3.0}}));
    }
  }

 private:
  static constexpr int kArrow = 12;
  static bool isRemoving(const QEvent& event) {
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Delete || key == Qt::Key_Backspace;
  }
  bool first_;
  std::function<void()> remove_;
};

RouteEditor::RouteEditor(ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  rebuild();
}

void RouteEditor::show(const std::vector<int>& goals) {
  if (goals != goals_) {
    goals_ = goals;
    rebuild();
  }
}

void RouteEditor::rebuild() {
  menu_.close();  // The menu belongs to the previous route.
  for (QWidget* part : parts_) {
    part->hide();
    part->deleteLater();
  }
  parts_.clear();
  for (int i = 0; i < static_cast<int>(goals_.size()); ++i) {
    const int id = goals_[static_cast<std::size_t>(i)];
    auto* chip = new Chip(
        QString::number(id), i == 0, [this, i] { removeGoal(i); }, this);
    chip->setToolTip(goalName(id) + tr("\nClick for options, press Delete to remove it"));
    chip->setAccessibleName(goalName(id));
    connect(chip, &QToolButton::clicked, this, [this, chip, i] { offerMoves(chip, i); });
    parts_.push_back(chip);
  }
  parts_.push_back(linkButton(tr("+ Add"), tr("Add a goal to the end of the route"), this,
                              [this] { offerGoals(parts_.back()); }));
  QWidget* before = previousInFocusChain();
  while (before != this && (before->focusPolicy() & Qt::TabFocus) == 0) {
    before = before->previousInFocusChain();
  }
  for (QWidget* part : parts_) {
    setTabOrder(before, part);  // no effect if there is none before
    before = part;
    part->show();
  }
  place(width(), true);
  updateGeometry();
}

int RouteEditor::place(int width, bool apply) const {
  int x = 0;
  int y = 0;
  for (QWidget* part : parts_) {
    const QSize size(part->sizeHint().width(), kChipHeight);
    if (x > 0 && x + size.width() > width) {
      x = 0;
      y += kLineHeight;
    }
    if (apply) {
      part->setGeometry(QRect(QPoint(x, y + 2), size));
    }
    x += size.width() + kRowGap;
  }
  return y + kLineHeight;
}

int RouteEditor::heightForWidth(int width) const {
  return place(width, false);
}

QSize RouteEditor::sizeHint() const {
  return {184, place(std::max(width(), 184), false)};
}

void RouteEditor::resizeEvent(QResizeEvent*) {
  place(width(), true);
  updateGeometry();
}

void RouteEditor::offerGoals(QWidget* button) {
  QMenu& menu = menu_.begin(*this);
  for (const sim2d::GlobalGoal& goal : document_.scenario().goals) {
    const QString words = goalName(goal.id) + QStringLiteral("   ") + positionText(goal);
    menu.addAction(words, this, [this, id = goal.id] {
      std::vector<int> route = goals_;
      route.push_back(id);
      Q_EMIT edited(route);
    });
  }
  if (menu.isEmpty()) {
    menu.addAction(tr("No goals yet: press G and click on the map"))->setEnabled(false);
  }
  menu.popup(button->mapToGlobal(QPoint(0, button->height())));
}

void RouteEditor::offerMoves(QWidget* chip, int index) {
  QMenu& menu = menu_.begin(*this);
  const int id = goals_[static_cast<std::size_t>(index)];
  const int last = static_cast<int>(goals_.size()) - 1;
  menu.addAction(tr("Select goal %1").arg(id), this, [this, id] {
    if (const EntityId goal = document_.goalKey(id)) {
      document_.setSelection({goal});
    }
  });
  menu.addSeparator();
  menu.addAction(tr("Earlier"), this, [this, index] { moveGoal(index, index - 1); })
      ->setEnabled(index > 0);
  menu.addAction(tr("Later"), this, [this, index] { moveGoal(index, index + 1); })
      ->setEnabled(index < last);
  menu.addAction(tr("Remove from the route"), this, [this, index] { removeGoal(index); });
  menu.popup(chip->mapToGlobal(QPoint(0, chip->height())));
}

/// Keeps the focus in the row.
void RouteEditor::removeGoal(int index) {
  if (!has(index)) {
    return;
  }
  const bool hasKeyboard = isAncestorOf(QApplication::focusWidget());
  std::vector<int> route = goals_;
  route.erase(route.begin() + index);
  const QPointer<RouteEditor> alive(this);
  Q_EMIT edited(route);
  if (alive && hasKeyboard) {
    parts_[std::min(static_cast<std::size_t>(index), parts_.size() - 1)]->setFocus();
  }
}

void RouteEditor::moveGoal(int from, int to) {
  if (!has(from) || !has(to)) {
    return;
  }
  std::vector<int> route = goals_;
  std::swap(route[static_cast<std::size_t>(from)], route[static_cast<std::size_t>(to)]);
  Q_EMIT edited(route);
}

namespace {

constexpr double kPictureEdgePx = 12.0;  // Distance from the sides of the dock.
constexpr double kBodyShare = 0.5;       // Share of the width.
constexpr double kMeasurePx = 20.0;      // Height of a dimension line and its number.
constexpr double kBesidePx = 52.0;       // Width of a dimension line beside the body.
constexpr double kFigureRowPx = 20.0;    // As the rows of the section "Now".
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

QString driveName(sim2d::Kinematics kinematics) {
  return kinematics == sim2d::Kinematics::Omnidirectional ? QObject::tr("omnidirectional")
         : kinematics == sim2d::Kinematics::Ackermann     ? QObject::tr("Ackermann")
                                                          : QObject::tr("differential");
}

QString metresText(double metres) {
  return QObject::tr("%1 m").arg(metres, 0, 'f', 2);
}

/// A dimension line between two ticks with its length in the middle.
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
  setAccessibleName(tr("Robot body"));
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
        tr("%1 long, %2 wide").arg(metresText(size.width()), metresText(size.height()))};
    for (const auto& [name, figure] : specificationsOf(*robot)) {
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

QList<std::pair<QString, QString>> RobotPicture::specificationsOf(
    const sim2d::ResolvedRobot& robot) {
  const auto number = [](double value, const char* unit) {
    return QStringLiteral("%1 %2").arg(value, 0, 'f', 2).arg(QString::fromUtf8(unit));
  };
  const bool isCar = robot.kinematics == sim2d::Kinematics::Ackermann;
  return {{tr("Drive"), driveName(robot.kinematics)},
          {tr("Speed"), number(robot.maxVel, "m/s")},
          isCar ? std::pair(tr("Turning"), number(robot.turningRadius, "m"))
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
  paintSpecifications(painter, all.adjusted(left.width() + kPictureEdgePx, 0.0, 0.0, 0.0));
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
  const QString length = metresText(box.width());
  paintMeasure(painter, {drawn.left(), below, drawn.right(), below},
               isDisc ? QString::fromUtf8("⌀ ") + length : length, ground);
  if (!isDisc) {
    const double beside = room.left() + 0.46 * kBesidePx;
    paintMeasure(painter, {beside, drawn.top(), beside, drawn.bottom()}, metresText(box.height()),
                 ground);
  }
}

void RobotPicture::paintSpecifications(QPainter& painter, const QRectF& room) const {
  const auto figures = specificationsOf(*robot_);
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

namespace {

using Head = Skin::Head;

const QColor kDark(0x3B, 0x2F, 0x2A);
const QColor kBlond(0xC9, 0x9A, 0x4A);
const QColor kGrey(0x8A, 0x8A, 0x8A);
const QColor kFace(0xE3, 0xB5, 0x94);

void paintHead(QPainter& painter, const Skin& skin) {
  painter.setBrush(kFace);
  painter.drawEllipse(QPointF(12.0, 9.0), 4.2, 4.8);
  painter.setBrush(skin.hair);
  QPainterPath hair;
  hair.moveTo(7.4, 9.2);
  hair.cubicTo(7.0, 2.0, 17.0, 2.0, 16.6, 9.2);
  hair.cubicTo(15.4, 6.6, 8.8, 6.4, 7.4, 9.2);
  painter.drawPath(hair);
  switch (skin.head) {
    case Head::Helmet:
      painter.setBrush(QColor(0xF2, 0xC0, 0x2E));
      painter.drawChord(QRectF(6.6, 2.2, 10.8, 10.6), 0, 180 * 16);
      painter.drawRect(QRectF(5.8, 7.0, 12.4, 1.3));
      break;
    case Head::Cap:
      painter.setBrush(QColor(0x1E, 0x2E, 0x4F));
      painter.drawChord(QRectF(6.8, 2.6, 10.4, 9.0), 0, 180 * 16);
      painter.drawRoundedRect(QRectF(6.4, 6.4, 11.2, 1.5), 0.7, 0.7);
      break;
    case Head::Dice:
      painter.setBrush(QColor(0xFF, 0xFF, 0xFF));
      painter.drawRoundedRect(QRectF(6.4, 3.2, 11.2, 11.2), 2.0, 2.0);
      painter.setBrush(kDark);
      for (const QPointF& dot : {QPointF(9.2, 6.0), QPointF(12.0, 8.8), QPointF(14.8, 11.6)}) {
        painter.drawEllipse(dot, 1.2, 1.2);
      }
      break;
    case Head::Hair:
    case Head::LongHair:
      break;
  }
}

}  // namespace

const std::vector<Skin>& skinsOf(const std::string& simulator) {
  static const std::vector<Skin> kGazebo = {
      {0, QT_TRANSLATE_NOOP("Skin", "Elegant man"), "#37424F", kDark},
      {1, QT_TRANSLATE_NOOP("Skin", "Casual man"), "#7A6A4F", kBlond},
      {2, QT_TRANSLATE_NOOP("Skin", "Elegant woman"), "#7B3F61", kDark, Head::LongHair},
      {3, QT_TRANSLATE_NOOP("Skin", "Regular man"), "#4F6D5A", kDark},
      {4, QT_TRANSLATE_NOOP("Skin", "Worker man"), "#E08A1E", kDark, Head::Helmet},
      {5, QT_TRANSLATE_NOOP("Skin", "Blue jeans"), "#3E5F8A", kBlond},
      {6, QT_TRANSLATE_NOOP("Skin", "Green t-shirt"), "#3C9A5F", kDark},
      {7, QT_TRANSLATE_NOOP("Skin", "Blue t-shirt"), "#2F7FD0", kDark},
      {8, QT_TRANSLATE_NOOP("Skin", "Red t-shirt"), "#C8453B", kDark}};
  static const std::vector<Skin> kIsaac = {
      {0, QT_TRANSLATE_NOOP("Skin", "Random (Isaac Sim)"), "#8A94A0", kGrey, Head::Dice},
      {1, "F_Business_02", "#4A4F6A", kDark, Head::LongHair},
      {2, "F_Medical_01", "#63B7B0", kBlond, Head::LongHair},
      {3, "M_Medical_01", "#63B7B0", kDark},
      {4, "male_adult_construction_01", "#E08A1E", kDark, Head::Helmet},
      {5, "male_adult_construction_05", "#C9B21E", kDark, Head::Helmet},
      {6, "female_adult_police_01", "#27406B", kDark, Head::Cap},
      {7, "female_adult_police_02", "#27406B", kBlond, Head::Cap},
      {8, "female_adult_police_03", "#3B5A8F", kDark, Head::Cap},
      {9, "male_adult_police_04", "#27406B", kGrey, Head::Cap},
      {10, "female_adult_business_02", "#6A4A5F", kBlond, Head::LongHair},
      {11, "female_adult_medical_01", "#8CC7E8", kDark, Head::LongHair}};
  static const std::vector<Skin> kWebots = {{0, "Robert", "#4C6A8C", kDark},
                                            {1, "Sandra", "#A34F6B", kBlond, Head::LongHair},
                                            {2, "Sophia", "#6B4FA3", kDark, Head::LongHair},
                                            {3, "Anthony", "#5B7F45", kGrey}};
  return simulator == "Isaac Sim" ? kIsaac : simulator == "Webots" ? kWebots : kGazebo;
}

QString skinName(const Skin& skin) {
  return QCoreApplication::translate("Skin", skin.name);
}

const Skin& skinFor(const std::string& simulator, int number) {
  const std::vector<Skin>& skins = skinsOf(simulator);
  const int last = static_cast<int>(skins.size()) - 1;
  const bool known = number >= 0 && number <= last;
  const int counts = known ? number : simulator == "Webots" ? 0 : std::clamp(number, 0, last);
  return skins[static_cast<std::size_t>(counts)];
}

QIcon skinIcon(const Skin& skin, const Theme& theme) {
  const auto draw = [&](QPainter& painter) {
    painter.translate(-12.0, -12.0);
    painter.setPen(QPen(theme.color(Role::Line), 0.6));
    if (skin.head == Head::LongHair) {
      painter.setBrush(skin.hair);
      painter.drawRoundedRect(QRectF(6.6, 5.0, 10.8, 10.6), 4.5, 4.5);
    }
    QPainterPath shoulders;
    shoulders.moveTo(3.0, 23.0);
    shoulders.cubicTo(3.2, 15.0, 8.0, 13.6, 12.0, 13.6);
    shoulders.cubicTo(16.0, 13.6, 20.8, 15.0, 21.0, 23.0);
    shoulders.closeSubpath();
    painter.setBrush(skin.clothes);
    painter.drawPath(shoulders);
    paintHead(painter, skin);
  };
  return drawnIcon(24, draw, {3});
}

}  // namespace editor
