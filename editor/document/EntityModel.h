#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// Icon name for the shape of an obstacle, or for a door.
QString shapeIcon(const Entity& entity);
/// "1.5, 2.0 m"; empty for entities without a position.
QString positionText(const Entity& entity);

/// The scenario as a tree: People, Goals, Robots, Obstacles (with doors), Areas. Columns: name,
/// kind, behaviour or position. Names are editable, and rows can be dragged within their kind (one
/// undoable command each).
class EntityModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, KindColumn, BehaviorColumn, ColumnCount };
  enum DataRole { IdKindRole = Qt::UserRole + 1, ListedRole };

  EntityModel(ScenarioDocument& document, const Theme& theme, QObject* parent = nullptr);
  void setTheme(const Theme& theme);

  EntityId idOf(const QModelIndex& index) const;  // None for group rows.
  QModelIndex indexOf(EntityId id) const;
  bool isGroup(const QModelIndex& at) const { return at.isValid() && at.internalId() == 0; }
  bool isUpdating() const { return isUpdating_; }  // Rows are being updated from the document.

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  bool canDropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                       const QModelIndex& parent) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

 private:
  std::vector<EntityId> dragged(const QMimeData& data) const;
  std::vector<EntityId> idsOfGroup(int group) const;
  QVariant groupData(int group, int column, int role) const;
  QVariant entityData(EntityId id, int column, int role) const;
  QString text(const Entity& entity, int column) const;
  QVariant icon(const Entity& entity) const;
  QVariant pendingTip(const Entity& entity) const;
  void follow();
  void refreshAll();
  void syncGroup(int group, const std::function<bool(EntityId)>& isChanged);
  void reorder(int group, std::vector<EntityId> wanted);

  ScenarioDocument& document_;
  Theme theme_;
  QVector<std::vector<EntityId>> rows_;  // Of each group.
  std::set<EntityId> changed_;           // Changes in the current step.
  bool isReplaced_ = false;              // The document was replaced in the current step.
  bool isUpdating_ = false;
};

/// Keeps groups that contain a match and shows the number of matches. Matches name, kind and
/// behaviour, case-insensitively.
class EntityFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit EntityFilter(EntityModel& model, QObject* parent = nullptr);
  void setText(const QString& text);
  QVariant data(const QModelIndex& index, int role) const override;
  EntityId idOf(const QModelIndex& at) const { return model_.idOf(mapToSource(at)); }
  QModelIndex indexOf(EntityId id) const { return mapFromSource(model_.indexOf(id)); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parentIndex) const override;

 private:
  EntityModel& model_;
  QString text_;
};

}  // namespace editor
