#include "editor/panels/ScenarioPanel.h"

#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/look/Fields.h"
#include "editor/look/Icons.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/behavior/BehaviorDialogs.h"

namespace editor {

namespace {

constexpr int kEmptyHeight = 72;  // Two lines and their margins.

bool canBeOff(const QModelIndex& index) {
  const auto kind = static_cast<EntityKind>(index.data(EntityModel::IdKindRole).toInt());
  return index.parent().isValid() && kind != EntityKind::Goal;
}

bool isOff(const QModelIndex& index) {
  return canBeOff(index) && !index.data(EntityModel::ListedRole).toBool();
}

bool showsEye(const QStyleOptionViewItem& option, const QModelIndex& index) {
  return isOff(index) || (option.state.testFlag(QStyle::State_MouseOver) && canBeOff(index));
}

/// Draws name and secondary text of an entity, and at the right end an eye icon that switches it on
/// and off; the eye is visible in the hovered row and in rows that are switched off.
class EntityRowDelegate : public RowDelegate {
 public:
  EntityRowDelegate(std::function<void(const QModelIndex&)> eyeClicked, QObject* parent)
      : RowDelegate(parent), eyeClicked_(std::move(eyeClicked)) {}

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    RowDelegate::paint(painter, option, index);
    if (showsEye(option, index)) {
      tintedIcon(isOff(index) ? QStringLiteral("eye-off") : QStringLiteral("eye"),
                 option.palette.color(QPalette::PlaceholderText))
          .paint(painter, ScenarioPanel::eyeRect(option.rect));
    }
  }

  bool editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
    const bool press = event->type() == QEvent::MouseButtonPress;
    if (!canBeOff(index) || (!press && event->type() != QEvent::MouseButtonRelease)) {
      return false;
    }
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton ||
        !ScenarioPanel::eyeRect(option.rect).contains(mouse->pos())) {
      return false;
    }
    if (!press) {
      eyeClicked_(index);
    }
    return true;
  }

 protected:
  bool isDimmed(const QModelIndex& index) const override { return isOff(index); }
  bool isHeading(const QModelIndex& index) const override { return !index.parent().isValid(); }
  int rightMargin(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return showsEye(option, index) ? 32 : 12;
  }
  QString sideText(const QModelIndex& index) const override {
    return isOff(index) ? QObject::tr("off")
                        : index.siblingAtColumn(EntityModel::BehaviorColumn).data().toString();
  }

 private:
  std::function<void(const QModelIndex&)> eyeClicked_;
};

/// Contiguous rows as one range: a selection of thousands of ranges is slow.
QItemSelection contiguousSelection(QModelIndexList rows) {
  std::sort(rows.begin(), rows.end(), [](const QModelIndex& a, const QModelIndex& b) {
    return std::pair(a.parent().row(), a.row()) < std::pair(b.parent().row(), b.row());
  });
  QItemSelection runs;
  for (auto first = rows.begin(); first != rows.end();) {
    auto last = first;
    while (last + 1 != rows.end() && (last + 1)->parent() == first->parent() &&
           (last + 1)->row() == last->row() + 1) {
      ++last;
    }
    runs.select(*first, *last);
    first = last + 1;
  }
  return runs;
}

void styleTree(QTreeView& tree) {
  styleList(tree, QObject::tr("Scenario"));
  tree.setHeaderHidden(true);
  tree.setUniformRowHeights(true);
  tree.setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree.setEditTriggers(QAbstractItemView::EditKeyPressed);
  tree.setContextMenuPolicy(Qt::CustomContextMenu);
  tree.setIndentation(16);
  tree.setMouseTracking(true);
  tree.setDragDropMode(QAbstractItemView::DragDrop);
  tree.setDefaultDropAction(Qt::MoveAction);
  tree.setDropIndicatorShown(true);
  for (int column = 1; column < EntityModel::ColumnCount; ++column) {
    tree.hideColumn(column);
  }
  tree.header()->setStretchLastSection(true);
}

QAction& offer(QMenu& menu, const QString& text, const QString& says,
               const std::function<void()>& action) {
  QAction* offered = menu.addAction(text, action);
  describe(*offered, says);
  return *offered;
}

}  // namespace

QRect ScenarioPanel::eyeRect(const QRect& row) {
  return {row.right() - 27, row.center().y() - 7, 16, 16};
}

ScenarioPanel::ScenarioPanel(ScenarioDocument& document, const Theme& theme)
    : document_(document), theme_(theme), model_(new EntityModel(document, theme, this)) {
  tree_->setModel(filter_);
  tree_->setItemDelegate(
      new EntityRowDelegate([this](const QModelIndex& index) { toggleListed(index); }, this));
  styleTree(*tree_);
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 0}, 4);
  layout->addLayout(configuredLayout(new QVBoxLayout, {12, 0, 12, 0}, 0, {filterField_}));
  auto* rows = new WholeRows(*tree_, this);
  nothing_ = new NoMatchesPlaceholder(*filterField_, *rows, this);
  layout->addWidget(rows, 1);
  layout->addWidget(nothing_, 1);
  empty_->setMinimumHeight(kEmptyHeight);
  layout->addWidget(empty_);
  connect(filterField_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setText(text);
    tree_->setDragEnabled(text.isEmpty());  // Hidden rows have no drop position.
    expandGroups();
    updatePlaceholder();
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ScenarioPanel::storeSelection);
  connect(tree_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const EntityId id = filter_->idOf(index)) {
      Q_EMIT activated(id);
    }
  });
  connect(tree_, &QTreeView::customContextMenuRequested, this, &ScenarioPanel::offerMenu);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &ScenarioPanel::loadSelection);
  connect(&document_, &ScenarioDocument::stepFinished, this, &ScenarioPanel::updatePlaceholder);
  auto* scroll = new QTimer(this);  // Scrolls up when another scenario has its rows.
  scroll->setSingleShot(true);
  connect(scroll, &QTimer::timeout, tree_, &QTreeView::scrollToTop);
  connect(&document_, &ScenarioDocument::changed, scroll, [scroll](const Change& change) {
    if (change.what == Change::What::Everything) {
      scroll->start(0);
    }
  });
  setTheme(theme);
  expandGroups();
  updatePlaceholder();
}

void ScenarioPanel::updatePlaceholder() {
  const sim2d::Scenario& scenario = document_.scenario();
  const int groups = filter_->rowCount();
  const bool isFound = groups > 0;
  if (groups > std::exchange(groups_, groups) && !filterField_->text().isEmpty()) {
    expandGroups();  // Makes restored rows visible.
  }
  const bool isEmpty = scenario.humans.empty() && scenario.goals.empty() &&
                       scenario.robots.empty() && scenario.areas.empty() &&
                       scenario.docks.empty();  // Obstacles are often the walls of a new room.
  empty_->setVisible(isFound && isEmpty);
  nothing_->setMatchFound(isFound);
}

void ScenarioPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  model_->setTheme(theme);
  filterField_->setTheme(theme);
  tree_->viewport()->update();
}

void ScenarioPanel::expandGroups() {
  const bool all = !filterField_->text().isEmpty();
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const QModelIndex group = filter_->index(row, 0);
    const int kind = filter_->mapToSource(group).row();  // 0 = people, 2 = robots
    tree_->setExpanded(group, all || kind == 0 || kind == 2);
  }
}

void ScenarioPanel::storeSelection() {
  if (syncing_ || model_->isUpdating()) {
    return;
  }
  std::vector<EntityId> ids;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows()) {
    if (const EntityId id = filter_->idOf(index)) {
      ids.push_back(id);
    }
  }
  const QScopedValueRollback<bool> syncing(syncing_, true);
  document_.setSelection(std::move(ids));
}

void ScenarioPanel::loadSelection() {
  if (syncing_) {
    return;
  }
  menu_.close();  // The menu belongs to the previous selection.
  const QScopedValueRollback<bool> syncing(syncing_, true);
  QModelIndexList chosen;
  for (const EntityId id : document_.selection()) {
    const QModelIndex index = filter_->indexOf(id);
    if (index.isValid()) {
      chosen.push_back(index);
    }
  }
  const QModelIndex last = chosen.isEmpty() ? QModelIndex() : chosen.back();
  const QItemSelection rows = contiguousSelection(std::move(chosen));
  tree_->selectionModel()->select(rows,
                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (last.isValid()) {
    tree_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    tree_->scrollTo(last);
  }
}

/// Shows the row and edits the name in it.
void ScenarioPanel::rename(EntityId id) {
  for (QWidget* widget = parentWidget(); widget != nullptr; widget = widget->parentWidget()) {
    if (auto* dock = qobject_cast<QDockWidget*>(widget)) {
      dock->show();
      dock->raise();
    }
  }
  if (!filter_->indexOf(id).isValid()) {
    filterField_->clear();
  }
  commitPendingEdit(*tree_);  // Also without focus: a list has one editor at a time.
  const QModelIndex row = filter_->indexOf(id);
  if (row.isValid()) {  // The entity may have been removed since the menu was opened.
    tree_->scrollTo(row);
    tree_->setFocus();
    tree_->edit(row);
  }
}

void ScenarioPanel::toggleListed(const QModelIndex& index) {
  const EntityId id = filter_->idOf(index);
  const bool listed = index.data(EntityModel::ListedRole).toBool();
  const bool whole = document_.isSelected(id);  // One of several selected entities.
  std::vector<EntityId> ids = whole ? document_.selection() : std::vector<EntityId>{id};
  pushListed(document_, ids, !listed);
}

void addScenarioPanel(PanelRegistry& to) {
  to.add({10, QObject::tr("Scenario"), Qt::RightDockWidgetArea, false}, [](PanelContext& context) {
    auto* panel = new ScenarioPanel(context.document, context.theme());
    QObject::connect(&context, &PanelContext::themeChanged, panel, &ScenarioPanel::setTheme);
    QObject::connect(&context.runner, &SimulationRunner::stateChanged, panel,
                     [panel](SimulationRunner::State state) {
                       panel->setEditing(state == SimulationRunner::State::Editing);
                     });
    QObject::connect(panel, &ScenarioPanel::activated, &context.view, &MapView::centerOnEntity);
    QObject::connect(panel, &ScenarioPanel::goalsRequested, &context,
                     &PanelContext::goalsRequested);
    return panel;
  });
}

void ScenarioPanel::offerMenu(const QPoint& at) {
  const EntityId id = filter_->idOf(tree_->indexAt(at));
  if (!id) {
    return;
  }
  QMenu& menu = menu_.begin(*this);
  offer(menu, tr("Show on the map"), tr("Centre the map on it"),
        [this, id] { Q_EMIT activated(id); });
  fillMenu(menu, id);
  menu.addSeparator();
  offer(menu, tr("Duplicate"), tr("Duplicate the selection"), [this] {
    document_.setSelection(pushDuplicate(document_, document_.selection(), Vec2(0.5, -0.5)));
  });
  offer(menu, tr("Delete"), tr("Remove the selection; routes are updated"),
        [this] { pushRemove(document_, document_.selection()); });
  menu.popup(tree_->viewport()->mapToGlobal(at));
}

void ScenarioPanel::fillMenu(QMenu& menu, EntityId id) {
  menu.setToolTipsVisible(true);
  offer(menu, tr("Rename"),
        id.kind == EntityKind::Goal ? tr("Change the number of the goal")
                                    : tr("Rename it; references are updated"),
        [this, id] { rename(id); });
  if (id.kind != EntityKind::Goal) {
    const bool listed = model_->indexOf(id).data(EntityModel::ListedRole).toBool();
    offer(menu, listed ? tr("Switch off") : tr("Switch on"),
          listed ? tr("Keep it in the file, but not in the simulation")
                 : tr("Include it in the simulation again"),
          [this, listed] { pushListed(document_, document_.selection(), !listed); });
  }
  offer(menu, tr("Select all of this kind"),
        tr("Select everything of this kind to change it together"),
        [this, id] { document_.setSelection(document_.entities(id.kind)); });
  if (id.kind == EntityKind::Human) {
    addPeopleActions(menu);
  }
}

void ScenarioPanel::addPeopleActions(QMenu& menu) {
  int people = 0;
  int grouped = 0;
  for (const EntityId id : document_.selection()) {
    if (const sim2d::Human* human = document_.human(id)) {
      ++people;
      grouped += isInGroup(*human) ? 1 : 0;
    }
  }
  menu.addSeparator();
  fillBehaviorMenu(*menu.addMenu(tr("Behaviour")), document_, theme_, this, isEditing_);
  offer(menu, tr("Assign goals…"), tr("Choose the goals that people visit, and their order"),
        [this] { Q_EMIT goalsRequested(); });
  offer(menu, tr("Walk as a group"),
        people > 1 ? tr("Make these people walk together as a group")
                   : tr("A group needs two or more people: select more"),
        [this] { pushGroup(document_, document_.selection()); })
      .setEnabled(people > 1);
  offer(menu, tr("Walk alone"),
        grouped > 0   ? tr("Leave the group")
        : people == 1 ? tr("This person is in no group")
                      : tr("None of these people is in a group"),
        [this] { pushJoinGroup(document_, document_.selection(), -1); })
      .setEnabled(grouped > 0);
}

}  // namespace editor
