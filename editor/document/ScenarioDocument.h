#pragma once

#include <map>
#include <memory>
#include <set>

#include "editor/document/Entity.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {
struct Bundle;
class SurroundingsCache;
}  // namespace app

namespace editor {

template <class T>
class LatestTask;
struct DocumentDiskState;
struct DocumentSnapshot;
struct SavePlan;

/// A value and its index in its list. No value: the entity does not exist. Index -1 = unchanged;
/// new entities and those switched on or off go to their default position.
struct EntitySlot {
  std::optional<Entity> value;
  int index = -1;
};

/// The map cells and the file that contains them; empty path: not in a file yet.
struct MapState {
  std::shared_ptr<const sim2d::OccupancyGrid> grid;
  QString path;
  bool isMissing = false;      // The scenario names a map that is missing or unreadable.
  base::Diagnostics problems;  // Problems of finding and reading the map.
};

/// The scenarios of a run: at its start, and with the changes of its branches. Null: no run, or a
/// recorded one.
struct RunScenarios {
  std::shared_ptr<const sim2d::Scenario> start, now;
  std::set<int> customTrees = {};  // Ids of people with custom trees in a recorded run.
};

/// A save would replace a hand-written tree file.
struct TreeConflict {
  enum class Why {
    ChangedOnDisk,     // The file on disk is unknown to this document.
    BehaviourChanged,  // Behaviour or goals have changed since the tree was written.
  };
  EntityId human;
  std::string name;         // Name of the person.
  std::string path;         // Path of the tree file.
  std::string mine;         // The hand-written tree.
  std::string replacement;  // The tree of the document: generated, or edited here.
  Why why = Why::ChangedOnDisk;
};

/// The people whose tree files are replaced; those of other people are kept.
using TreeReplacements = std::set<EntityId>;

/// The scenario being edited, with its map, trees, undo stack and selection. GUI thread. Only
/// commands (EditCommands.h, MapEdit.h) modify it, through the `exchange…` functions.
class ScenarioDocument : public QObject {
  Q_OBJECT
 public:
  explicit ScenarioDocument(QObject* parent = nullptr);
  ~ScenarioDocument() override;
  Q_DISABLE_COPY_MOVE(ScenarioDocument)

  // Model
  const sim2d::Scenario& scenario() const { return scenario_; }
  std::optional<Entity> entity(EntityId id) const;
  bool contains(EntityId id) const { return id == kSettingsId || indexOf(id) >= 0; }
  std::vector<EntityId> entities(EntityKind kind) const;  // In file order.
  /// The entity as its own type; null if it does not exist. Valid until the next edit.
  const sim2d::Human* human(EntityId id) const;
  const sim2d::GlobalGoal* goal(EntityId id) const;
  /// Goal with this number.
  EntityId goalKey(int goalId) const {
    const sim2d::GlobalGoal* found = scenario_.goal(goalId);
    return found == nullptr ? EntityId{} : found->key;
  }
  int indexOf(EntityId id) const;                                 // Index in its list; -1 = none.
  EntityId newId(EntityKind kind) { return {kind, nextKey_++}; }  // Never used before here.
  EntitySlot exchange(EntityId id, EntitySlot slot);
  /// All exchanges during its lifetime form one step, including nested steps: `changed` is emitted
  /// per entity, `stepFinished` and `selectionChanged` once when the outermost step ends.
  class Step {
   public:
    explicit Step(ScenarioDocument& document) : document_(document) { ++document_.steps_; }
    ~Step() { document_.finishStep(); }
    Q_DISABLE_COPY_MOVE(Step)

   private:
    ScenarioDocument& document_;
  };

  /// The custom tree of a person (XML text); none = the tree generated from the behaviour.
  std::optional<std::string> tree(EntityId human) const {
    const auto found = trees_.find(human);
    return found == trees_.end() ? std::nullopt : std::optional<std::string>(found->second);
  }
  std::optional<std::string> exchangeTree(EntityId human, std::optional<std::string> xml);
  /// The tree that a run uses: the custom tree, else that of the file while it still matches the
  /// person, else one in the style of the file; none = the generator's.
  std::optional<std::string> treeToRun(EntityId human) const;

  /// Returns true if behaviour or goals have changed since the custom tree was written. Saving asks
  /// about such a tree.
  bool isTreeOutdated(EntityId human) const;

  /// All inputs of a run in their current state, saved or not.
  app::Bundle bundle() const;
  const std::shared_ptr<app::SurroundingsCache>& surroundings() const { return surroundings_; }
  /// The stop flag of all background work on the current map.
  base::StopFlagPtr mapStopFlag() const { return mapStopFlag_; }
  void stopMapTasks();

  // Map; never null, an empty grid is the open plane
  std::shared_ptr<const sim2d::OccupancyGrid> map() const { return map_.grid; }
  QString mapPath() const { return map_.path; }  // YAML file; empty: none, or not from a file.
  void setMap(std::shared_ptr<const sim2d::OccupancyGrid> map) {
    exchangeMap({std::move(map), {}, false, {}});
  }
  const MapState& mapState() const { return map_; }
  MapState exchangeMap(MapState map);

  // The run that is shown beside the document, which may have been edited since
  void setRun(RunScenarios run);
  /// The entity in the shown run; none: no run, or not in it.
  std::optional<Entity> entityInRun(EntityId id) const {
    return run_.now == nullptr ? std::nullopt : entityIn(*run_.now, id);
  }
  /// The person has a custom tree here or in the recorded run that is shown.
  bool hasCustomTree(const sim2d::Human& human) const {
    return trees_.count(human.key) > 0 || run_.customTrees.count(human.id) > 0;
  }
  std::optional<Entity> entityAtRunStart(EntityId id) const {
    return run_.start == nullptr ? std::nullopt : entityIn(*run_.start, id);
  }

  // Undo
  QUndoStack& undoStack() { return undoStack_; }
  bool isDirty() const { return !undoStack_.isClean() || neverSaved_; }

  // Selection (not undoable, in order of selection)
  const std::vector<EntityId>& selection() const { return selection_; }
  bool isSelected(EntityId id) const {
    return std::find(selection_.begin(), selection_.end(), id) != selection_.end();
  }
  void setSelection(std::vector<EntityId> ids);
  void toggleSelected(EntityId id);

  // Files; all problems are returned
  QString path() const { return path_; }  // Empty: not saved yet.
  QString displayName() const;            // "cafe.yaml" or "Untitled"
  void clear();                           // Starts a new, empty scenario.
  void load(sim2d::Scenario scenario);    // From code (templates, tests): new and unsaved.
  /// Opens a file. On errors the document does not change, unless it isReadOnly afterwards: a
  /// damaged file is shown as far as it can be read. A file of which nothing can be read replaces
  /// only an empty document.
  base::Diagnostics open(const QString& path);
  /// Overrides the map and the tree folder of the scenarios that are opened next.
  void setSearchOverrides(const QString& map, const QString& trees) {
    search_.mapOption = map.toStdString();
    search_.treesOption = trees.toStdString();
  }
  /// The file was read only partly; it can be saved only under another name.
  bool isReadOnly() const;
  /// Writes canonical YAML and one tree per person: in ../behavior_trees if the folder is called
  /// scenarios, else in the same folder. A new file name becomes yaml_base_name and the stem of the
  /// tree files. Either all files are written or none; on errors nothing changes on disk.
  base::Diagnostics save(const QString& path, const TreeReplacements& replaced = {});
  /// The conflicts that the user must resolve before saving there. Unresolved conflicts keep the
  /// tree file on disk.
  std::vector<TreeConflict> treeConflicts(const QString& path) const;
  /// Number of comments in the opened file, which saving loses.
  int commentCount() const { return commentCount_; }
  /// Reads a nav2 map and stores its path in the scenario (one undoable command).
  base::Diagnostics openMap(const QString& yamlPath);
  /// Starts a new scenario on a map. On errors the document does not change.
  base::Diagnostics newOnMap(const QString& yamlPath);
  void setShippedMaps(const QString& folder) { search_.shippedMaps = folder.toStdString(); }
  bool isShipped(const QString& file) const;  // The file is one of the program's own files.
  /// All files that were read or written, and those of them that other programs have changed since.
  QStringList files() const;
  QStringList changedOnDisk() const;
  void acceptDiskChanges();  // Accepts the current files on disk as known. Edits are kept.

  // All unsaved state, for another start of the program; it is restored as unsaved, or as saved
  DocumentSnapshot snapshot() const;
  void restore(DocumentSnapshot snapshot, bool isSaved = false);

  // Messages
  base::Diagnostics issues() const;  // Of loading, the map, and the live check, in this order.
  void checkNow();                   // Runs the check immediately and waits until it is complete.
  void checkSoon();                  // Runs the check immediately and waits for a short time only.

 Q_SIGNALS:
  void changed(editor::Change change);  // A change of one entity; more may follow immediately.
  void stepFinished();                  // Emitted after the last `changed` of a step.
  void aboutToBeReplaced();             // By another document. Typed text is committed to this one.
  void mapChanged();
  void selectionChanged();
  void pathChanged();
  void runChanged();  // Another run or branch is shown, or none.
  void dirtyChanged(bool dirty);
  void issuesChanged(const base::Diagnostics& issues);

 private:
  base::Diagnostics reportedMapProblems() const;
  /// The same entity in another scenario: with its key, or else with its name.
  std::optional<Entity> entityIn(const sim2d::Scenario& scenario, EntityId id) const;
  void resetScenario(sim2d::Scenario scenario);
  void replaced();  // Emits the signals after another file was loaded.
  void emitFileSignals();
  sim2d::FileSearchPaths places() const;
  void finishStep();
  void loadMap();
  void putMap(MapState map);
  void restoreMap(const DocumentSnapshot& snapshot);
  base::Diagnostics loadTrees();
  void startCheck();
  /// The plan of a save at `path`. Reads the disk, changes nothing.
  SavePlan planSave(const QString& path) const;
  void planMap(SavePlan& plan) const;
  void planTrees(SavePlan& plan) const;
  /// The tree to save and run for a person: custom, from the file, or generated.
  std::string effectiveTree(const sim2d::Scenario& scenario, const sim2d::Human& human) const;
  void applyTreeAnswers(const QString& path, const TreeReplacements& replaced);
  void adoptSaved(SavePlan plan);

  sim2d::Scenario scenario_;
  RunScenarios run_;
  MapState map_{std::make_shared<sim2d::OccupancyGrid>(), {}, false, {}};
  std::map<EntityId, std::string> trees_;
  QUndoStack undoStack_;
  std::vector<EntityId> selection_;
  QString path_;
  sim2d::FileSearchPaths search_;  // All but the path of the scenario.
  base::Diagnostics loadDiagnostics_, checkIssues_;
  QTimer checkTimer_;
  const std::shared_ptr<app::SurroundingsCache> surroundings_;
  std::shared_ptr<base::StopFlag> mapStopFlag_ = std::make_shared<base::StopFlag>();
  std::unique_ptr<LatestTask<base::Diagnostics>> liveCheck_;
  std::unique_ptr<DocumentDiskState> disk_;
  int nextKey_ = 1;
  int steps_ = 0;  // Number of nested steps that have not ended.
  int commentCount_ = 0;
  bool selectionShrank_ = false;  // A selected entity was removed in the current step.
  bool neverSaved_ = false;
};

}  // namespace editor
