#include <algorithm>

#include <QDataStream>
#include <QMimeData>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityModel.h"

namespace editor {

namespace {

QString dragType() {
  return QStringLiteral("application/x-hunavsim-entities");
}

}  // namespace

QStringList EntityModel::mimeTypes() const {
  return {dragType()};
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
  data->setData(dragType(), bytes);
  return data;
}

std::vector<EntityId> EntityModel::dragged(const QMimeData& data) const {
  std::vector<EntityId> ids;
  QDataStream from(data.data(dragType()));
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

}  // namespace editor
