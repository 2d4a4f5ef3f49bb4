#include "editor/panels/properties/RouteEditor.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <QtWidgets>

#include "editor/document/EntityModel.h"
#include "editor/look/Form.h"

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
    painter.setPen(palette().color(hasFocus() || underMouse() ? QPalette::Link : QPalette::Mid));
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
  for (QWidget* part : parts_) {
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

}  // namespace editor
