#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include "editor/document/Entity.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace editor {

class LiveCheck;

/// A value at its place in its list. Without a value: not there. index -1 = where it was, else at
/// the end.
struct EntitySlot {
  std::optional<Entity> value;
  int index = -1;
};

/// The scenario being edited, with its map, trees, undo stack and selection. GUI thread.
/// Only commands (EditCommands.h) write: `exchange` and `exchangeTree` are for them.
class ScenarioDocument : public QObject {
  Q_OBJECT
 public:
  explicit ScenarioDocument(QObject* parent = nullptr);
  ~ScenarioDocument() override;
  Q_DISABLE_COPY_MOVE(ScenarioDocument)

  // model
  const sim2d::Scenario& scenario() const { return scenario_; }
  std::optional<Entity> entity(EntityId id) const;
  bool contains(EntityId id) const;
  std::vector<EntityId> entities(EntityKind kind) const;  // in file order
  /// The entity as its own type; null when it is not there. Valid until the next edit.
  const sim2d::Human* human(EntityId id) const;
  const sim2d::GlobalGoal* goal(EntityId id) const;
  EntityId goalKey(int goalId) const;  // of the goal with this number
  int indexOf(EntityId id) const;      // in its list, -1 = not there
  EntityId newId(EntityKind kind);     // never given before in this document
  EntitySlot exchange(EntityId id, EntitySlot slot);

  /// A person's own tree (XML text); none = the generated one of the behaviour.
  std::optional<std::string> tree(EntityId human) const;
  std::optional<std::string> exchangeTree(EntityId human, std::optional<std::string> xml);

  // map; never null, an empty grid is the open plane
  std::shared_ptr<const sim2d::OccupancyGrid> map() const { return map_; }
  QString mapPath() const { return mapPath_; }  // of the YAML; empty: none, or not from a file
  void setMap(std::shared_ptr<const sim2d::OccupancyGrid> map, const QString& path = {});

  // undo
  QUndoStack& undoStack() { return undoStack_; }
  bool isDirty() const { return !undoStack_.isClean() || neverSaved_; }

  // selection (not undoable, in the order of selecting)
  const std::vector<EntityId>& selection() const { return selection_; }
  bool isSelected(EntityId id) const;
  void setSelection(std::vector<EntityId> ids);
  void toggleSelected(EntityId id);

  // files; all problems are returned, errors among them = nothing has changed
  QString path() const { return path_; }  // empty: not saved yet
  QString displayName() const;            // "cafe.yaml" or "Untitled"
  void clear();                           // a new, empty scenario
  void load(sim2d::Scenario scenario);    // from code (templates, tests): new, unsaved
  base::Diagnostics open(const QString& path);
  /// Canonical YAML and one tree per person: in ../behavior_trees when the folder is called
  /// scenarios, else beside. A new file name becomes yaml_base_name and the stem of the trees.
  base::Diagnostics save(const QString& path);
  /// Comments in the file that was opened; saving over it loses them.
  int commentCount() const { return commentCount_; }
  /// Read a nav2 map and remember its place in the scenario (one undoable command).
  base::Diagnostics openMap(const QString& yamlPath);
  void setShippedMaps(const QString& folder) { shippedMaps_ = folder; }

  // messages
  const base::Diagnostics& loadDiagnostics() const { return loadDiagnostics_; }
  base::Diagnostics issues() const;  // of loading, then of the live check
  void checkNow();                   // without the pause that follows edits

 Q_SIGNALS:
  void changed(editor::Change change);
  void mapChanged();
  void selectionChanged();
  void pathChanged();
  void dirtyChanged(bool dirty);
  void issuesChanged(const base::Diagnostics& issues);

 private:
  void replaceAll(sim2d::Scenario scenario);
  void dropFromSelection(EntityId id);
  base::Diagnostics loadMapOf(const sim2d::Scenario& scenario, const QString& path);
  base::Diagnostics loadTrees();
  base::Diagnostics placeMap(sim2d::Scenario& scenario, const QString& path);
  base::Diagnostics writeTrees(const sim2d::Scenario& scenario, const QString& path) const;

  sim2d::Scenario scenario_;
  std::shared_ptr<const sim2d::OccupancyGrid> map_;
  std::map<EntityId, std::string> trees_;
  QUndoStack undoStack_;
  std::vector<EntityId> selection_;
  QString path_, mapPath_, shippedMaps_;
  base::Diagnostics loadDiagnostics_, checkIssues_;
  QTimer checkTimer_;
  std::unique_ptr<LiveCheck> liveCheck_;
  int nextKey_ = 1;
  int commentCount_ = 0;
  bool neverSaved_ = false;
  bool mapIsMissing_ = false;  // named by the scenario, but not found
};

}  // namespace editor
