#include "editor/document/EntityModel.h"

#include <iterator>

#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/RunValues.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

const QLatin1String kDragType("application/x-hunavsim-entities");

struct Group {
  const char* title;
  std::vector<EntityKind> kinds;
};

const QVector<Group>& groups() {
  static const QVector<Group> kGroups = {
      {QT_TRANSLATE_NOOP("editor::EntityModel", "People"), {EntityKind::Human}},
      {QT_TRANSLATE_NOOP("editor::EntityModel", "Goals"), {EntityKind::Goal}},
      {QT_TRANSLATE_NOOP("editor::EntityModel", "Robots and docks"),
       {EntityKind::Robot, EntityKind::Dock}},
      {QT_TRANSLATE_NOOP("editor::EntityModel", "Obstacles"),
       {EntityKind::Obstacle, EntityKind::Door}},
      {QT_TRANSLATE_NOOP("editor::EntityModel", "Areas"), {EntityKind::Area}},
  };
  return kGroups;
}

int groupOf(EntityKind kind) {
  const auto found = std::find_if(groups().begin(), groups().end(), [kind](const Group& group) {
    return std::count(group.kinds.begin(), group.kinds.end(), kind) > 0;
  });
  return found == groups().end() ? -1 : static_cast<int>(found - groups().begin());
}

/// The first and last index of each contiguous range of ids that satisfy the predicate.
template <class IsMeant>
std::vector<std::pair<int, int>> contiguousRanges(const std::vector<EntityId>& ids,
                                                  IsMeant&& isMeant) {
  std::vector<std::pair<int, int>> runs;
  for (int i = 0; i < static_cast<int>(ids.size()); ++i) {
    if (!isMeant(ids[static_cast<std::size_t>(i)])) {
      continue;
    }
    if (!runs.empty() && runs.back().second == i - 1) {
      runs.back().second = i;
    } else {
      runs.emplace_back(i, i);
    }
  }
  return runs;
}

}  // namespace

QString positionText(const Entity& entity) {
  const std::optional<Vec2> at = positionOf(entity);
  return at ? QStringLiteral("%1, %2 m").arg(at->x(), 0, 'f', 1).arg(at->y(), 0, 'f', 1)
            : QString();
}

QString shapeIcon(const Entity& entity) {
  if (kindOf(entity) == EntityKind::Dock) {
    return QStringLiteral("tool-dock");
  }
  const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
  if (obstacle == nullptr) {
    return QStringLiteral("tool-door");
  }
  static const char* const kIcons[] = {"tool-box", "tool-circle", "tool-polygon", "tool-wall"};
  return QString::fromLatin1(kIcons[static_cast<int>(obstacle->kind)]);
}

EntityModel::EntityModel(ScenarioDocument& document, const Theme& theme, QObject* parent)
    : QAbstractItemModel(parent), document_(document), theme_(theme) {
  for (int group = 0; group < groups().size(); ++group) {
    rows_.push_back(idsOfGroup(group));
  }
  connect(&document_, &ScenarioDocument::changed, this, [this](const Change& change) {
    isReplaced_ = isReplaced_ || change.what == Change::What::Everything;
    changed_.insert(change.entity);
  });
  connect(&document_, &ScenarioDocument::stepFinished, this, &EntityModel::follow);
  connect(&document_, &ScenarioDocument::runChanged, this, &EntityModel::refreshAll);
}

void EntityModel::setTheme(const Theme& theme) {
  theme_ = theme;
  refreshAll();
}

void EntityModel::refreshAll() {
  for (int group = 0; group < rows_.size(); ++group) {
    const QModelIndex parentIndex = index(group, 0);
    const int rows = rowCount(parentIndex);
    if (rows > 0) {
      Q_EMIT dataChanged(index(0, 0, parentIndex), index(rows - 1, ColumnCount - 1, parentIndex));
    }
  }
}

std::vector<EntityId> EntityModel::idsOfGroup(int group) const {
  std::vector<EntityId> ids;
  for (const EntityKind kind : groups()[group].kinds) {
    const std::vector<EntityId> more = document_.entities(kind);
    ids.insert(ids.end(), more.begin(), more.end());
  }
  return ids;
}

void EntityModel::follow() {
  const std::set<EntityId> changed = std::exchange(changed_, {});
  const bool isAll = std::exchange(isReplaced_, false);
  isUpdating_ = true;
  for (int group = 0; group < rows_.size(); ++group) {
    if (isAll || std::any_of(changed.begin(), changed.end(),
                             [group](EntityId id) { return groupOf(id.kind) == group; })) {
      syncGroup(group, [&](EntityId id) { return isAll || changed.count(id) > 0; });
    }
  }
  isUpdating_ = false;
}

/// Applies document changes to the rows of a group. An edit of thousands of entities results in few
/// row changes.
void EntityModel::syncGroup(int group, const std::function<bool(EntityId)>& isChanged) {
  const QModelIndex parentIndex = index(group, 0);
  std::vector<EntityId>& rows = rows_[group];
  const std::vector<EntityId> fresh = idsOfGroup(group);
  const std::size_t before = rows.size();
  const std::set<EntityId> kept(fresh.begin(), fresh.end());
  const auto removed = contiguousRanges(rows, [&](EntityId id) { return kept.count(id) == 0; });
  for (auto run = removed.rbegin(); run != removed.rend(); ++run) {
    beginRemoveRows(parentIndex, run->first, run->second);
    rows.erase(rows.begin() + run->first, rows.begin() + run->second + 1);
    endRemoveRows();
  }
  const std::set<EntityId> known(rows.begin(), rows.end());
  std::vector<EntityId> wanted;
  std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(wanted),
               [&](EntityId id) { return known.count(id) > 0; });
  if (wanted != rows) {
    reorder(group, std::move(wanted));
  }
  for (const auto& [first, last] :
       contiguousRanges(fresh, [&](EntityId id) { return known.count(id) == 0; })) {
    beginInsertRows(parentIndex, first, last);
    rows.insert(rows.begin() + first, fresh.begin() + first, fresh.begin() + last + 1);
    endInsertRows();
  }
  if (const auto runs = contiguousRanges(fresh, isChanged); !runs.empty()) {
    Q_EMIT dataChanged(index(runs.front().first, 0, parentIndex),
                       index(runs.back().second, ColumnCount - 1, parentIndex));
  }
  if (before != fresh.size()) {
    Q_EMIT dataChanged(parentIndex, parentIndex, {Qt::DisplayRole});
  }
}

void EntityModel::reorder(int group, std::vector<EntityId> wanted) {
  const QModelIndex parentIndex = index(group, 0);
  Q_EMIT layoutAboutToBeChanged({parentIndex});
  std::map<EntityId, int> places;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    places[wanted[i]] = static_cast<int>(i);
  }
  const QModelIndexList old = persistentIndexList();
  QModelIndexList moved;
  for (const QModelIndex& each : old) {
    const EntityId id = each.parent() == parentIndex ? idOf(each) : EntityId{};
    moved.push_back(id ? index(places.at(id), each.column(), parentIndex) : each);
  }
  rows_[group] = std::move(wanted);
  changePersistentIndexList(old, moved);
  Q_EMIT layoutChanged({parentIndex});
}

EntityId EntityModel::idOf(const QModelIndex& at) const {
  if (!at.isValid() || isGroup(at)) {
    return {};
  }
  const auto& rows = rows_[static_cast<int>(at.internalId()) - 1];
  const auto row = static_cast<std::size_t>(at.row());
  return row < rows.size() ? rows[row] : EntityId{};
}

QModelIndex EntityModel::indexOf(EntityId id) const {
  const int group = groupOf(id.kind);
  if (group < 0) {
    return {};
  }
  const auto& rows = rows_[group];
  const auto found = std::find(rows.begin(), rows.end(), id);
  return found == rows.end() ? QModelIndex()
                             : index(static_cast<int>(found - rows.begin()), 0, index(group, 0));
}

QModelIndex EntityModel::index(int row, int column, const QModelIndex& parentIndex) const {
  if (row < 0 || column < 0 || column >= ColumnCount || row >= rowCount(parentIndex)) {
    return {};
  }
  return createIndex(row, column,
                     parentIndex.isValid() ? static_cast<quintptr>(parentIndex.row()) + 1 : 0);
}

QModelIndex EntityModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == 0) {
    return {};
  }
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
}

int EntityModel::rowCount(const QModelIndex& parentIndex) const {
  if (!parentIndex.isValid()) {
    return rows_.size();
  }
  if (!isGroup(parentIndex) || parentIndex.column() != 0) {
    return 0;
  }
  return static_cast<int>(rows_[parentIndex.row()].size());
}

QVariant EntityModel::data(const QModelIndex& at, int role) const {
  if (!at.isValid()) {
    return {};
  }
  return isGroup(at) ? groupData(at.row(), at.column(), role)
                     : entityData(idOf(at), at.column(), role);
}

QVariant EntityModel::groupData(int group, int column, int role) const {
  if (role == Qt::DisplayRole && column == NameColumn) {
    return tr(groups()[group].title);
  }
  if (role == Qt::DisplayRole && column == BehaviorColumn) {
    return QString::number(rows_[group].size());
  }
  if (role == Qt::FontRole && column == NameColumn) {
    return theme_.font(9.5, QFont::DemiBold);
  }
  if (role == Qt::ForegroundRole && column != NameColumn) {
    return theme_.color(Role::TextSecondary);
  }
  if (role == Qt::TextAlignmentRole && column == BehaviorColumn) {
    return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  }
  return {};
}

QString EntityModel::text(const Entity& entity, int column) const {
  if (column == NameColumn) {
    return displayName(entity);
  }
  if (column == KindColumn) {
    const auto* obstacle = std::get_if<sim2d::Obstacle>(&entity);
    return obstacle == nullptr ? kindName(kindOf(entity)) : obstacleKindName(obstacle->kind);
  }
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    const QString own = lookName(lookOfPerson(document_, *human));
    const QString shown = lookName(shownLookOf(document_, *human));
    return own == shown ? own : shown + QString::fromUtf8(" → ") + own;
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    return QString::fromStdString(robot->type.value_or("generic"));
  }
  if (const auto* area = std::get_if<sim2d::Area>(&entity)) {
    return areaKindName(area->kind);
  }
  return positionText(entity);
}

/// States that an edited behaviour applies at the next start; nothing: it was not edited in a run.
QVariant EntityModel::pendingTip(const Entity& entity) const {
  const auto* human = std::get_if<sim2d::Human>(&entity);
  const Look own = human == nullptr ? Look::Regular : lookOfPerson(document_, *human);
  return human == nullptr || own == shownLookOf(document_, *human)
             ? QVariant()
             : tr("%1 in this run; %2 applies at the next start")
                   .arg(lookName(shownLookOf(document_, *human)), lookName(own));
}

QVariant EntityModel::icon(const Entity& entity) const {
  const FigurePainter painter(theme_);
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    return painter.markIcon(shownLookOf(document_, *human));
  }
  if (const auto* goal = std::get_if<sim2d::GlobalGoal>(&entity)) {
    return painter.goalIcon(QString::number(goal->id), 20);
  }
  if (const auto* area = std::get_if<sim2d::Area>(&entity)) {
    return areaIcon(area->kind, theme_);
  }
  if (kindOf(entity) == EntityKind::Robot) {
    return painter.robotIcon(16);
  }
  return tintedIcon(shapeIcon(entity), theme_.color(Role::TextSecondary));
}

QVariant EntityModel::entityData(EntityId id, int column, int role) const {
  const std::optional<Entity> entity = document_.entity(id);
  if (!entity) {
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      return text(*entity, column);
    case Qt::EditRole:
      return QString::fromStdString(nameOf(*entity));
    case Qt::DecorationRole:
      return column == NameColumn ? icon(*entity) : QVariant();
    case Qt::ForegroundRole:
      return column == NameColumn ? QVariant() : QVariant(theme_.color(Role::TextSecondary));
    case Qt::TextAlignmentRole:
      return column == BehaviorColumn ? static_cast<int>(Qt::AlignRight | Qt::AlignVCenter)
                                      : static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      return pendingTip(*entity);
    case ListedRole:
      return isListed(*entity);
    case IdKindRole:
      return static_cast<int>(id.kind);
    default:
      return {};
  }
}

bool EntityModel::setData(const QModelIndex& at, const QVariant& value, int role) {
  const EntityId id = idOf(at);
  if (role != Qt::EditRole || !id) {
    return false;
  }
  if (id.kind == EntityKind::Goal) {
    bool isNumber = false;
    const int number = value.toInt(&isNumber);
    return isNumber && pushGoalNumber(document_, id, number);
  }
  return pushRename(document_, id, value.toString().trimmed().toStdString());
}

Qt::ItemFlags EntityModel::flags(const QModelIndex& at) const {
  if (!at.isValid()) {
    return Qt::NoItemFlags;
  }
  if (isGroup(at)) {
    return Qt::ItemIsEnabled | Qt::ItemIsDropEnabled;
  }
  const Qt::ItemFlags common =
      Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren | Qt::ItemIsDragEnabled;
  return at.column() == NameColumn ? common | Qt::ItemIsEditable : common;
}

QVariant EntityModel::headerData(int section, Qt::Orientation orientation, int role) const {
  static const char* const kTitles[] = {QT_TR_NOOP("Name"), QT_TR_NOOP("Kind"),
                                        QT_TR_NOOP("Behaviour")};
  const bool isTitle = orientation == Qt::Horizontal && role == Qt::DisplayRole && section >= 0 &&
                       section < ColumnCount;
  return isTitle ? QVariant(tr(kTitles[section])) : QVariant();
}

QStringList EntityModel::mimeTypes() const {
  return {kDragType};
}

QMimeData* EntityModel::mimeData(const QModelIndexList& indexes) const {
  QByteArray bytes;
  QDataStream to(&bytes, QIODevice::WriteOnly);
  for (const QModelIndex& each : indexes) {
    const EntityId id = idOf(each);
    if (id && each.column() == NameColumn) {
      to << static_cast<int>(id.kind) << id.key;
    }
  }
  auto* data = new QMimeData;
  data->setData(kDragType, bytes);
  return data;
}

std::vector<EntityId> EntityModel::dragged(const QMimeData& data) const {
  std::vector<EntityId> ids;
  QDataStream from(data.data(kDragType));
  while (!from.atEnd()) {
    int kind = 0;
    int key = 0;
    from >> kind >> key;
    const EntityId id{static_cast<EntityKind>(kind), key};
    if (document_.contains(id)) {
      ids.push_back(id);
    }
  }
  return ids;
}

bool EntityModel::canDropMimeData(const QMimeData* data, Qt::DropAction action, int, int,
                                  const QModelIndex& parentIndex) const {
  if (data == nullptr || action != Qt::MoveAction || !isGroup(parentIndex)) {
    return false;
  }
  const std::vector<EntityId> ids = dragged(*data);
  return !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](EntityId id) {
    return indexOf(id).parent() == parentIndex.siblingAtColumn(0) && id.kind == ids.front().kind;
  });
}

bool EntityModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                               const QModelIndex& parentIndex) {
  if (!canDropMimeData(data, action, row, column, parentIndex)) {
    return false;
  }
  const std::vector<EntityId> ids = dragged(*data);
  // Rows of another kind above, such as obstacles above doors, do not count.
  int before = 0;
  const int last = row < 0 ? rowCount(parentIndex) : row;
  for (int i = 0; i < last; ++i) {
    before += idOf(index(i, 0, parentIndex)).kind == ids.front().kind ? 1 : 0;
  }
  pushReorder(document_, ids, before);
  return true;
}

EntityFilter::EntityFilter(EntityModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(&model);
  // The visibility of a group depends on its rows. Qt's own recursive filter miscounts rows that
  // are inserted into a hidden group.
  const auto look = [this] {
    if (!text_.isEmpty()) {
      invalidateFilter();
    }
  };
  connect(&model_, &QAbstractItemModel::rowsInserted, this, look);
  connect(&model_, &QAbstractItemModel::rowsRemoved, this, look);
  connect(&model_, &QAbstractItemModel::dataChanged, this, look);
}

void EntityFilter::setText(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
  if (rowCount() > 0) {  // The text of each group shows the number of visible rows.
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1), {Qt::DisplayRole});
  }
}

QVariant EntityFilter::data(const QModelIndex& at, int role) const {
  const bool isCount = at.isValid() && !at.parent().isValid() &&
                       at.column() == EntityModel::BehaviorColumn && role == Qt::DisplayRole;
  const int seen = isCount && !text_.isEmpty() ? rowCount(at.siblingAtColumn(0)) : -1;
  const int all = seen < 0 ? 0 : model_.rowCount(mapToSource(at.siblingAtColumn(0)));
  return seen >= 0 && seen < all ? QVariant(tr("%1 of %2").arg(seen).arg(all))
                                 : QSortFilterProxyModel::data(at, role);
}

bool EntityFilter::filterAcceptsRow(int row, const QModelIndex& parentIndex) const {
  if (text_.isEmpty()) {
    return true;
  }
  const QModelIndex first = model_.index(row, 0, parentIndex);
  if (!parentIndex.isValid()) {  // Groups are kept if one of their rows matches.
    for (int child = 0; child < model_.rowCount(first); ++child) {
      if (filterAcceptsRow(child, first)) {
        return true;
      }
    }
    return false;
  }
  for (int column = 0; column < model_.columnCount(); ++column) {
    const QString cell = first.siblingAtColumn(column).data().toString();
    if (cell.contains(text_, Qt::CaseInsensitive)) {
      return true;
    }
  }
  return false;
}

}  // namespace editor
