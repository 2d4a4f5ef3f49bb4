#include "editor/document/EntityModel.h"

namespace editor {

EntityFilter::EntityFilter(EntityModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(&model);
  setRecursiveFilteringEnabled(true);
}

void EntityFilter::setText(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
  if (rowCount() > 0) {  // of each group it is told how many are seen
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1), {Qt::DisplayRole});
  }
}

QVariant EntityFilter::data(const QModelIndex& at, int role) const {
  const bool isCount = at.isValid() && !at.parent().isValid() &&
                       at.column() == EntityModel::BehaviorColumn && role == Qt::DisplayRole;
  const int seen = isCount && !text_.isEmpty() ? rowCount(at.siblingAtColumn(0)) : -1;
  const int all = seen < 0 ? 0 : at.data(EntityModel::CountRole).toInt();
  return seen >= 0 && seen < all ? QVariant(tr("%1 of %2").arg(seen).arg(all))
                                 : QSortFilterProxyModel::data(at, role);
}

bool EntityFilter::filterAcceptsRow(int row, const QModelIndex& parentIndex) const {
  if (text_.isEmpty()) {
    return true;
  }
  for (int column = 0; parentIndex.isValid() && column < model_.columnCount(); ++column) {
    const QString cell = model_.index(row, column, parentIndex).data().toString();
    if (cell.contains(text_, Qt::CaseInsensitive)) {
      return true;
    }
  }
  return false;  // groups are kept for the sake of their rows
}

EntityId EntityFilter::idOf(const QModelIndex& at) const {
  return model_.idOf(mapToSource(at));
}

QModelIndex EntityFilter::indexOf(EntityId id) const {
  return mapFromSource(model_.indexOf(id));
}

}  // namespace editor
