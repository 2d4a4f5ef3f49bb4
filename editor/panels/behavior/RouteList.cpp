#include "editor/panels/behavior/RouteList.h"

#include <algorithm>

#include "editor/document/Entity.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

constexpr int kGoalRole = Qt::UserRole + 1;
constexpr int kPinSize = 20;

QString dragType() {
  return QStringLiteral("application/x-hunavsim-goals");
}

}  // namespace

QVBoxLayout* titledColumn(const QString& title, const Theme& theme, QWidget* content) {
  QLabel* heading = headingLabel(title, theme.font(9.5, QFont::DemiBold));
  heading->setBuddy(content);
  auto* column = configuredLayout(new QVBoxLayout, {}, 4, {heading, content});
  column->setStretchFactor(content, 1);
  return column;
}

HintList::HintList(const Theme& theme, const QString& name, QWidget* parent) : QListWidget(parent) {
  setAccessibleName(name);
  QPalette colors = palette();
  colors.setColor(QPalette::Base, theme.color(Role::Panel));
  setPalette(colors);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setUniformItemSizes(true);
  setItemDelegate(new RowDelegate(this));
}

void HintList::setHint(const QString& hint) {
  hint_ = hint;
  viewport()->update();
}

std::vector<int> HintList::selectedRows() const {
  std::vector<int> rows;
  for (int row = 0; row < count(); ++row) {
    if (item(row)->isSelected()) {
      rows.push_back(row);
    }
  }
  return rows;
}

void HintList::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() == 0) {
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(16, 16, -16, -16),
                     Qt::AlignCenter | Qt::TextWordWrap, hint_);
  }
}

GoalList::GoalList(const Theme& theme, const QString& name, QWidget* parent)
    : HintList(theme, name, parent), theme_(theme) {
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  setDefaultDropAction(Qt::CopyAction);
}

void GoalList::addGoal(const sim2d::GlobalGoal* goal, int number, const QString& sideText) {
  const FigurePainter painter(theme_);
  auto* item = new QListWidgetItem(
      painter.goalIcon(QString::number(number), kPinSize),
      goal != nullptr ? goalName(number) : tr("%1 (missing)").arg(goalName(number)), this);
  item->setData(kGoalRole, number);
  item->setData(kSideTextRole, sideText);
}

std::vector<int> GoalList::selectedGoals() const {
  std::vector<int> result;
  for (const int row : selectedRows()) {
    result.push_back(item(row)->data(kGoalRole).toInt());
  }
  return result;
}

std::vector<int> GoalList::goals() const {
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(count()));
  for (int row = 0; row < count(); ++row) {
    result.push_back(item(row)->data(kGoalRole).toInt());
  }
  return result;
}

void GoalList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    Q_EMIT addRequested();
    return;
  }
  HintList::keyPressEvent(event);
}

QStringList GoalList::mimeTypes() const {
  return {dragType()};
}

/// Source list, then row and number of each goal.
QMimeData* GoalList::mimeData(const QList<QListWidgetItem*> items) const {
  QByteArray bytes;
  QDataStream to(&bytes, QIODevice::WriteOnly);
  to << static_cast<quint64>(reinterpret_cast<quintptr>(this));
  for (int i = 0; i < count(); ++i) {
    if (items.contains(item(i))) {
      to << i << item(i)->data(kGoalRole).toInt();
    }
  }
  auto* mime = new QMimeData;
  mime->setData(dragType(), bytes);
  return mime;
}

RouteList::RouteList(const Theme& theme, const QString& name, QWidget* parent)
    : GoalList(theme, name, parent) {
  setDragDropMode(QAbstractItemView::DragDrop);
  setDropIndicatorShown(true);
  setDragDropOverwriteMode(false);
}

void RouteList::showRoute(const std::vector<int>& route, const sim2d::Scenario& scenario) {
  clear();
  for (std::size_t i = 0; i < route.size(); ++i) {
    addGoal(scenario.goal(route[i]), route[i], QStringLiteral("%1.").arg(i + 1));
  }
}

void RouteList::removeSelected() {
  std::vector<int> route = goals();
  const std::vector<int> rows = selectedRows();
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    route.erase(route.begin() + *row);
  }
  if (!rows.empty()) {
    Q_EMIT edited(route);
  }
}

void RouteList::moveSelected(int by) {
  const std::vector<int> rows = selectedRows();
  if (!rows.empty()) {
    moveRows(rows, by < 0 ? std::max(rows.front() - 1, 0) : std::min(rows.back() + 2, count()));
  }
}

/// Moves rows together to before the current row `before`.
void RouteList::moveRows(const std::vector<int>& rows, int before) {
  const std::vector<int> route = goals();
  std::vector<int> head;
  std::vector<int> moved;
  std::vector<int> tail;
  for (int row = 0; row < static_cast<int>(route.size()); ++row) {
    const bool moves = std::find(rows.begin(), rows.end(), row) != rows.end();
    (moves ? moved : row < before ? head : tail).push_back(route[static_cast<std::size_t>(row)]);
  }
  const int first = static_cast<int>(head.size());
  head.insert(head.end(), moved.begin(), moved.end());
  head.insert(head.end(), tail.begin(), tail.end());
  if (head == route) {
    return;
  }
  Q_EMIT edited(head);
  clearSelection();
  for (int row = first; row < std::min(first + static_cast<int>(moved.size()), count()); ++row) {
    item(row)->setSelected(true);
  }
  setCurrentRow(first, QItemSelectionModel::NoUpdate);
}

/// The rows are moved here, not by Qt. A copy action makes the source keep its rows.
void RouteList::dropEvent(QDropEvent* event) {
  quint64 source = 0;
  QDataStream from(event->mimeData()->data(dragType()));
  from >> source;
  std::vector<int> rows;
  std::vector<int> goals;
  while (!from.atEnd()) {
    int row = 0;
    int goal = 0;
    from >> row >> goal;
    rows.push_back(row);
    goals.push_back(goal);
  }
  const QModelIndex under = indexAt(event->pos());
  const bool isBelow = event->pos().y() > visualRect(under).center().y();
  const int before = under.isValid() ? under.row() + (isBelow ? 1 : 0) : count();
  event->setDropAction(Qt::CopyAction);
  event->accept();
  if (source == static_cast<quint64>(reinterpret_cast<quintptr>(static_cast<GoalList*>(this)))) {
    moveRows(rows, before);
  } else if (!goals.empty()) {
    Q_EMIT dropped(goals, before);
  }
  setState(QAbstractItemView::NoState);
  viewport()->update();
}

void RouteList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    removeSelected();
  } else if (event->modifiers().testFlag(Qt::AltModifier) && event->key() == Qt::Key_Up) {
    moveSelected(-1);
  } else if (event->modifiers().testFlag(Qt::AltModifier) && event->key() == Qt::Key_Down) {
    moveSelected(1);
  } else {
    GoalList::keyPressEvent(event);
  }
}

}  // namespace editor
