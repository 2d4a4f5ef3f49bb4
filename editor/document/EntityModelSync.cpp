#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "editor/document/EntityModel.h"

// The functions of EntityModel that apply document changes to the rows. An edit of thousands of
// entities results in few row changes.
namespace editor {

namespace {

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

void EntityModel::follow() {
  std::array<std::vector<EntityId>, kGroupCount> changed;
  changed.swap(changed_);
  const bool isOther = std::exchange(settingsChanged_, false);
  isUpdating_ = true;
  for (int group = 0; group < kGroupCount; ++group) {
    const std::vector<EntityId> ids =
        isOther ? idsOfGroup(group) : changed[static_cast<std::size_t>(group)];
    if (isOther || !ids.empty()) {
      syncGroup(group, std::set<EntityId>(ids.begin(), ids.end()));
    }
  }
  isUpdating_ = false;
}

void EntityModel::syncGroup(int group, const std::set<EntityId>& changed) {
  const QModelIndex parentIndex = index(group, 0);
  const std::vector<EntityId> fresh = idsOfGroup(group);
  const std::size_t before = rows_[static_cast<std::size_t>(group)].size();
  removeDeletedRows(group, fresh);
  reorderRows(group, fresh);
  insertNewRows(group, fresh);
  const auto isChanged = [&](EntityId id) { return changed.count(id) > 0; };
  if (const auto runs = contiguousRanges(fresh, isChanged); !runs.empty()) {
    Q_EMIT dataChanged(index(runs.front().first, 0, parentIndex),
                       index(runs.back().second, ColumnCount - 1, parentIndex));
  }
  if (before != fresh.size()) {
    Q_EMIT dataChanged(parentIndex, parentIndex, {Qt::DisplayRole});
  }
}

void EntityModel::removeDeletedRows(int group, const std::vector<EntityId>& fresh) {
  std::vector<EntityId>& rows = rows_[static_cast<std::size_t>(group)];
  const std::set<EntityId> stay(fresh.begin(), fresh.end());
  const auto runs = contiguousRanges(rows, [&](EntityId id) { return stay.count(id) == 0; });
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    beginRemoveRows(index(group, 0), run->first, run->second);
    rows.erase(rows.begin() + run->first, rows.begin() + run->second + 1);
    endRemoveRows();
  }
}

/// Reorders the remaining rows as in the document.
void EntityModel::reorderRows(int group, const std::vector<EntityId>& fresh) {
  std::vector<EntityId>& rows = rows_[static_cast<std::size_t>(group)];
  const std::set<EntityId> known(rows.begin(), rows.end());
  std::vector<EntityId> wanted;
  std::copy_if(fresh.begin(), fresh.end(), std::back_inserter(wanted),
               [&](EntityId id) { return known.count(id) > 0; });
  if (wanted == rows) {
    return;
  }
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
  rows = std::move(wanted);
  changePersistentIndexList(old, moved);
  Q_EMIT layoutChanged({parentIndex});
}

void EntityModel::insertNewRows(int group, const std::vector<EntityId>& fresh) {
  std::vector<EntityId>& rows = rows_[static_cast<std::size_t>(group)];
  const std::set<EntityId> known(rows.begin(), rows.end());
  for (const auto& [first, last] :
       contiguousRanges(fresh, [&](EntityId id) { return known.count(id) == 0; })) {
    beginInsertRows(index(group, 0), first, last);
    rows.insert(rows.begin() + first, fresh.begin() + first, fresh.begin() + last + 1);
    endInsertRows();
  }
}

}  // namespace editor
