#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "editor/document/EntityModel.h"

// The part of EntityModel that does what the document did: a step of thousands is a few changes of
// rows.
namespace editor {

namespace {

/// First and last place of those that stand side by side and are meant.
template <class IsMeant>
std::vector<std::pair<int, int>> runsOf(const std::vector<EntityId>& ids, IsMeant&& isMeant) {
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
  const bool isOther = std::exchange(isOther_, false);
  isFollowing_ = true;
  for (int group = 0; group < kGroupCount; ++group) {
    const std::vector<EntityId> ids =
        isOther ? idsOfGroup(group) : changed[static_cast<std::size_t>(group)];
    if (isOther || !ids.empty()) {
      followGroup(group, std::set<EntityId>(ids.begin(), ids.end()));
    }
  }
  isFollowing_ = false;
}

void EntityModel::followGroup(int group, const std::set<EntityId>& changed) {
  const QModelIndex parentIndex = index(group, 0);
  const std::vector<EntityId> fresh = idsOfGroup(group);
  const std::size_t before = rows_[static_cast<std::size_t>(group)].size();
  removeGone(group, fresh);
  orderLike(group, fresh);
  insertNew(group, fresh);
  const auto isChanged = [&](EntityId id) { return changed.count(id) > 0; };
  if (const auto runs = runsOf(fresh, isChanged); !runs.empty()) {
    Q_EMIT dataChanged(index(runs.front().first, 0, parentIndex),
                       index(runs.back().second, ColumnCount - 1, parentIndex));
  }
  if (before != fresh.size()) {
    Q_EMIT dataChanged(parentIndex, parentIndex, {Qt::DisplayRole});
  }
}

void EntityModel::removeGone(int group, const std::vector<EntityId>& fresh) {
  std::vector<EntityId>& rows = rows_[static_cast<std::size_t>(group)];
  const std::set<EntityId> stay(fresh.begin(), fresh.end());
  const auto runs = runsOf(rows, [&](EntityId id) { return stay.count(id) == 0; });
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    beginRemoveRows(index(group, 0), run->first, run->second);
    rows.erase(rows.begin() + run->first, rows.begin() + run->second + 1);
    endRemoveRows();
  }
}

/// The rows that are left, in the order of the document.
void EntityModel::orderLike(int group, const std::vector<EntityId>& fresh) {
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

void EntityModel::insertNew(int group, const std::vector<EntityId>& fresh) {
  std::vector<EntityId>& rows = rows_[static_cast<std::size_t>(group)];
  const std::set<EntityId> known(rows.begin(), rows.end());
  for (const auto& [first, last] :
       runsOf(fresh, [&](EntityId id) { return known.count(id) == 0; })) {
    beginInsertRows(index(group, 0), first, last);
    rows.insert(rows.begin() + first, fresh.begin() + first, fresh.begin() + last + 1);
    endInsertRows();
  }
}

}  // namespace editor
