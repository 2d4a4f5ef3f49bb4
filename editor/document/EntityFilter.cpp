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
