#include "editor/panels/behavior/GoalAssignment.h"

#include <algorithm>

#include "editor/document/Entity.h"
#include "editor/document/EntityModel.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Icons.h"
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

namespace {

constexpr int kSpace = 8;

QString routeText(const std::vector<int>& route) {
  QStringList numbers;
  for (const int goal : route) {
    numbers << QString::number(goal);
  }
  return numbers.isEmpty() ? QObject::tr("no goals") : numbers.join(QStringLiteral(" › "));
}

}  // namespace

GoalAssignment::GoalAssignment(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QDialog(parent),
      document_(document),
      theme_(theme),
      plan_(document),
      people_(new HintList(theme, tr("People"), this)),
      goals_(new GoalList(theme, tr("Goals"), this)),
      route_(new RouteList(theme, tr("Route"), this)) {
  setWindowTitle(tr("Assign goals"));
  resize(780, limitedToScreen(*this, 480));
  auto* columns = configuredLayout(new QHBoxLayout, {}, kSpace);
  columns->addLayout(titledColumn(tr("People"), theme, people_), 5);
  columns->addSpacing(kSpace);
  columns->addLayout(titledColumn(tr("Goals"), theme, goals_), 4);
  columns->addWidget(makeMiddle());
  columns->addWidget(makeRouteColumn(), 4);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Assign"));
  connect(buttons, &QDialogButtonBox::accepted, this, &GoalAssignment::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* below = new QHBoxLayout;
  below->addWidget(secondaryLabel(tr("Drag goals to add and reorder them. Assign applies the "
                                     "changes; Undo reverts them."),
                                  this),
                   1);
  below->addWidget(buttons);
  auto* layout = configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 16);
  layout->addLayout(columns, 1);
  layout->addLayout(below);
  people_->setHint(tr("No people yet: press P and drag on the map"));
  goals_->setHint(tr("No goals yet: press G and click on the map"));
  fillLists();
  connect(people_, &QListWidget::itemSelectionChanged, this, &GoalAssignment::showRoute);
  loadSelection();
  addSelectedGoals();
  showRoute();
}

QPushButton* GoalAssignment::moveButton(const QString& icon, const QString& says,
                                        const std::function<void()>& action) {
  auto* button = new QPushButton(themedIcon(icon, theme_), {}, this);
  button->setToolTip(says);
  button->setAccessibleName(says);
  button->setFixedSize(36, 28);
  button->setAutoDefault(false);
  connect(button, &QPushButton::clicked, this, action);
  return button;
}

QWidget* GoalAssignment::makeMiddle() {
  auto* middle = new QWidget(this);
  auto* layout = configuredLayout(new QVBoxLayout(middle), {0, 24, 0, 0}, 4);
  const auto addSelected = [this] { add(goals_->selectedGoals(), route_->count()); };
  add_ = moveButton(QStringLiteral("chevron-right"), tr("Add to the end of the route (Return)"),
                    addSelected);
  remove_ = moveButton(QStringLiteral("remove"), tr("Remove from the route (Del)"),
                       [this] { route_->removeSelected(); });
  earlier_ = moveButton(QStringLiteral("chevron-up"), tr("Earlier (Alt+Up)"),
                        [this] { route_->moveSelected(-1); });
  later_ = moveButton(QStringLiteral("chevron-down"), tr("Later (Alt+Down)"),
                      [this] { route_->moveSelected(1); });
  layout->addStretch();
  for (QPushButton* button : {add_, remove_, earlier_, later_}) {
    layout->addWidget(button);
  }
  layout->addStretch();
  connect(goals_, &GoalList::addRequested, this, addSelected);
  connect(goals_, &QListWidget::itemDoubleClicked, this, addSelected);
  connect(goals_, &QListWidget::itemSelectionChanged, this,
          [this] { add_->setEnabled(!chosen().empty() && !goals_->selectedGoals().empty()); });
  return middle;
}

QWidget* GoalAssignment::makeRouteColumn() {
  auto* box = new QWidget(this);
  auto* layout = configuredLayout(new QVBoxLayout(box), {}, 4, {whose_, route_});
  layout->setStretchFactor(route_, 1);
  clear_ = new QPushButton(tr("Clear"), this);
  clear_->setToolTip(tr("Clear the route of the selected people"));
  clear_->setAutoDefault(false);
  whose_->setTextFormat(Qt::PlainText);
  whose_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* foot = new QHBoxLayout;
  foot->addWidget(repeat_, 1);
  foot->addWidget(clear_);
  layout->addLayout(foot);
  connect(clear_, &QPushButton::clicked, this, [this] {
    plan_.setRoute(chosen(), {});
    showRoute();
  });
  connect(route_, &RouteList::edited, this, [this](const std::vector<int>& route) {
    plan_.setRoute(chosen(), route);
    showRoute();
  });
  connect(route_, &RouteList::dropped, this, &GoalAssignment::add);
  connect(route_, &RouteList::addRequested, this, &GoalAssignment::accept);
  connect(repeat_, &QCheckBox::clicked, this, [this](bool on) {
    plan_.setRepeat(chosen(), on);
    showRoute();
  });
  return box;
}

void GoalAssignment::fillLists() {
  const FigurePainter painter(theme_);
  for (const EntityId person : plan_.people()) {
    const sim2d::Human* human = document_.human(person);
    auto* item = new QListWidgetItem(painter.markIcon(lookOfPerson(document_, *human)),
                                     QString::fromStdString(human->name), people_);
    item->setSelected(document_.isSelected(person));
  }
  showPeople();
  for (const sim2d::GlobalGoal& goal : document_.scenario().goals) {
    goals_->addGoal(&goal, goal.id, positionText(goal));
    goals_->item(goals_->count() - 1)->setSelected(document_.isSelected(goal.key));
  }
}

/// Chooses the people selected on the map, else the first one without goals, or all without goals
/// if goals are selected.
void GoalAssignment::loadSelection() {
  if (!chosen().empty()) {
    people_->setCurrentItem(people_->selectedItems().front(), QItemSelectionModel::NoUpdate);
    return;
  }
  const std::vector<EntityId>& all = plan_.people();
  std::vector<int> idle;
  for (std::size_t row = 0; row < all.size(); ++row) {
    if (plan_.route(all[row]).empty()) {
      idle.push_back(static_cast<int>(row));
    }
  }
  people_->setCurrentRow(idle.empty() ? 0 : idle.front());
  for (const int row : goals_->selectedGoals().empty() ? std::vector<int>() : idle) {
    people_->item(row)->setSelected(true);
  }
}

/// Puts the goals selected on the map together with people into the route of these people, in the
/// order of their selection, unless they have goals already.
void GoalAssignment::addSelectedGoals() {
  std::vector<int> goals;
  bool isWithPeople = false;
  for (const EntityId id : document_.selection()) {
    isWithPeople = isWithPeople || id.kind == EntityKind::Human;
    if (const sim2d::GlobalGoal* goal = document_.goal(id)) {
      goals.push_back(goal->id);
    }
  }
  const std::optional<std::vector<int>> route = plan_.commonRoute(chosen());
  if (isWithPeople && !goals.empty() && route && route->empty()) {
    plan_.setRoute(chosen(), goals);
  }
}

std::vector<EntityId> GoalAssignment::chosen() const {
  std::vector<EntityId> result;
  for (const int row : people_->selectedRows()) {
    result.push_back(plan_.people()[static_cast<std::size_t>(row)]);
  }
  return result;
}

/// Inserts goals at that row of a common route; different routes get them at their ends.
void GoalAssignment::add(const std::vector<int>& goals, int row) {
  const std::vector<EntityId> people = chosen();
  if (std::optional<std::vector<int>> route = plan_.commonRoute(people)) {
    const int at = std::clamp(row, 0, static_cast<int>(route->size()));
    route->insert(route->begin() + at, goals.begin(), goals.end());
    plan_.setRoute(people, *route);
  } else {
    plan_.append(people, goals);
  }
  showRoute();
}

void GoalAssignment::showPeople() {
  for (int row = 0; row < people_->count(); ++row) {
    const EntityId person = plan_.people()[static_cast<std::size_t>(row)];
    people_->item(row)->setData(kSideTextRole, routeText(plan_.route(person)));
  }
}

void GoalAssignment::showRoute() {
  const std::vector<EntityId> people = chosen();
  const std::optional<std::vector<int>> route = plan_.commonRoute(people);
  const bool any = !people.empty();
  whose_->setText(!any ? tr("Route")
                  : people.size() == 1
                      ? tr("Route of %1").arg(displayName(*document_.entity(people.front())))
                      : tr("Route of %1 people").arg(people.size()));
  route_->showRoute(route.value_or(std::vector<int>()), document_.scenario());
  route_->setHint(!any     ? tr("Select people on the left")
                  : !route ? tr("These people have different routes. Added goals go to the end of "
                                "each.")
                           : tr("No goals: people stand still. Add goals from the middle list."));
  route_->setEnabled(any);
  const std::optional<bool> repeat = plan_.commonRepeat(people);
  repeat_->setEnabled(any);
  repeat_->setTristate(any && !repeat);
  repeat_->setCheckState(any && !repeat          ? Qt::PartiallyChecked
                         : repeat.value_or(true) ? Qt::Checked
                                                 : Qt::Unchecked);
  add_->setEnabled(any && !goals_->selectedGoals().empty());
  const bool isRoute = route && !route->empty();
  remove_->setEnabled(isRoute);
  earlier_->setEnabled(isRoute && route->size() > 1);
  later_->setEnabled(earlier_->isEnabled());
  clear_->setEnabled(any && (!route || isRoute));
  showPeople();
}

/// Selects the people with new goals, so that the map shows their complete routes.
void GoalAssignment::accept() {
  const std::vector<EntityId> changed = plan_.push(document_);
  if (!changed.empty()) {
    document_.setSelection(changed);
  }
  QDialog::accept();
}

void openGoalAssignment(ScenarioDocument& document, const Theme& theme, QWidget* parent) {
  auto* dialog = new GoalAssignment(document, theme, parent->window());
  deleteWhenClosed(*dialog);
  dialog->open();
}

}  // namespace editor
