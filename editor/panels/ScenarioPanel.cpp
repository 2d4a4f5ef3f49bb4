#include "editor/panels/ScenarioPanel.h"

#include <QAction>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QMenu>
#include <QPainter>
#include <QVBoxLayout>

#include "editor/document/EditCommands.h"
#include "editor/look/Icons.h"
#include "editor/panels/Form.h"

namespace editor {

namespace {

constexpr int kRowHeight = 24;
constexpr int kRightMargin = 12;

}  // namespace

EntityRowDelegate::EntityRowDelegate(const Theme& theme, QObject* parent)
    : QStyledItemDelegate(parent), theme_(theme) {}

QSize EntityRowDelegate::sizeHint(const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRowHeight};
}

void EntityRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  const bool group = !index.parent().isValid();
  if (group || option.state.testFlag(QStyle::State_Selected)) {
    row.font.setWeight(QFont::DemiBold);
    row.fontMetrics = QFontMetrics(row.font);
  }
  const QString secondary =
      index.siblingAtColumn(EntityModel::BehaviorColumn).data(Qt::DisplayRole).toString();
  const int room = option.fontMetrics.horizontalAdvance(secondary) + kRightMargin;
  const int nameRoom = option.rect.width() - room - 8 - (row.icon.isNull() ? 0 : 24);
  row.text = row.fontMetrics.elidedText(row.text, Qt::ElideRight, std::max(nameRoom, 40));
  const QStyle* style = option.widget != nullptr ? option.widget->style() : nullptr;
  if (style != nullptr) {
    style->drawControl(QStyle::CE_ItemViewItem, &row, painter, option.widget);
  }
  painter->save();
  painter->setFont(option.font);
  painter->setPen(theme_.color(Role::TextSecondary));
  painter->drawText(option.rect.adjusted(0, 0, -kRightMargin, 0), Qt::AlignRight | Qt::AlignVCenter,
                    secondary);
  painter->restore();
}

ScenarioPanel::ScenarioPanel(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      theme_(theme),
      model_(new EntityModel(document, theme, this)),
      filter_(new EntityFilter(*model_, this)),
      filterField_(new QLineEdit(this)),
      tree_(new QTreeView(this)),
      delegate_(new EntityRowDelegate(theme, this)),
      empty_(
          emptyState(tr("Nothing on the map yet.\nPress P and click to place a person."), this)) {
  filterField_->setPlaceholderText(tr("Filter people, goals, areas"));
  filterField_->setClearButtonEnabled(true);
  filterField_->setAccessibleName(tr("Filter"));
  searchMark_ = filterField_->addAction(QIcon(), QLineEdit::LeadingPosition);
  tree_->setModel(filter_);
  tree_->setItemDelegate(delegate_);
  tree_->setHeaderHidden(true);
  tree_->setFrameShape(QFrame::NoFrame);
  tree_->setUniformRowHeights(true);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setIndentation(16);
  tree_->viewport()->setAutoFillBackground(false);
  tree_->setAccessibleName(tr("Scenario"));
  for (int column = 1; column < EntityModel::ColumnCount; ++column) {
    tree_->hideColumn(column);
  }
  tree_->header()->setStretchLastSection(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(12, 0, 12, 0);
  top->addWidget(filterField_);
  layout->addLayout(top);
  layout->addWidget(tree_, 1);
  layout->addWidget(empty_);
  connect(filterField_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter_->setFilterFixedString(text);
    expandGroups();
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ScenarioPanel::giveSelection);
  connect(tree_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const EntityId id = filter_->idOf(index)) {
      Q_EMIT activated(id);
    }
  });
  connect(tree_, &QTreeView::customContextMenuRequested, this, &ScenarioPanel::offerMenu);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &ScenarioPanel::takeSelection);
  connect(&document_, &ScenarioDocument::changed, this, [this](const Change& change) {
    empty_->setVisible(document_.scenario().humans.empty() && document_.scenario().goals.empty());
    if (change.what == Change::What::Everything) {
      expandGroups();
      takeSelection();
    }
  });
  setTheme(theme);
  expandGroups();
  empty_->setVisible(document_.scenario().humans.empty() && document_.scenario().goals.empty());
}

void ScenarioPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  delegate_->setTheme(theme);
  model_->setTheme(theme);
  searchMark_->setIcon(tintedIcon(QStringLiteral("search"), theme.color(Role::TextSecondary)));
  tree_->viewport()->update();
}

void ScenarioPanel::expandGroups() {
  const bool all = !filterField_->text().isEmpty();
  for (int row = 0; row < filter_->rowCount(); ++row) {
    const QModelIndex group = filter_->index(row, 0);
    const int people = 0;
    const int robots = 2;
    const int source = filter_->mapToSource(group).row();
    tree_->setExpanded(group, all || source == people || source == robots);
  }
}

void ScenarioPanel::giveSelection() {
  if (syncing_) {
    return;
  }
  std::vector<EntityId> ids;
  for (const QModelIndex& index : tree_->selectionModel()->selectedRows()) {
    if (const EntityId id = filter_->idOf(index)) {
      ids.push_back(id);
    }
  }
  syncing_ = true;
  document_.setSelection(std::move(ids));
  syncing_ = false;
}

void ScenarioPanel::takeSelection() {
  if (syncing_) {
    return;
  }
  syncing_ = true;
  QItemSelection rows;
  QModelIndex last;
  for (const EntityId id : document_.selection()) {
    const QModelIndex index = filter_->indexOf(id);
    if (index.isValid()) {
      rows.select(index, index);
      last = index;
    }
  }
  tree_->selectionModel()->select(rows,
                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (last.isValid()) {
    tree_->selectionModel()->setCurrentIndex(last, QItemSelectionModel::NoUpdate);
    tree_->scrollTo(last);
  }
  syncing_ = false;
}

void ScenarioPanel::offerMenu(const QPoint& at) {
  const QModelIndex index = tree_->indexAt(at);
  const EntityId id = filter_->idOf(index);
  if (!id) {
    return;
  }
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(tr("Show on the map")), &QAction::triggered, this,
          [this, id] { Q_EMIT activated(id); });
  connect(menu->addAction(tr("Rename")), &QAction::triggered, this,
          [this, index] { tree_->edit(index); });
  menu->addSeparator();
  connect(menu->addAction(tr("Duplicate")), &QAction::triggered, this, [this] {
    document_.setSelection(pushDuplicate(document_, document_.selection(), Vec2(0.5, -0.5)));
  });
  connect(menu->addAction(tr("Delete")), &QAction::triggered, this,
          [this] { pushRemove(document_, document_.selection()); });
  menu->popup(tree_->viewport()->mapToGlobal(at));
}

}  // namespace editor
