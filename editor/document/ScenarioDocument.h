#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>

#include "editor/document/Entity.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Stop.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {
struct Bundle;
class KnownSurroundings;
}  // namespace app

namespace editor {

template <class T>
class LatestTask;
struct DocumentDisk;
struct DocumentSnapshot;
struct SavePlan;

/// A value at its place in its list. Without a value: not there. index -1 = where it was; what is
/// new, or switched on or off: where it belongs.
struct EntitySlot {
  std::optional<Entity> value;
  int index = -1;
};

/// The cells under the scenario and the file they are in; no path: not in a file yet.
struct MapState {
  std::shared_ptr<const sim2d::OccupancyGrid> grid;
  QString path;
  bool isMissing = false;      // named by the scenario, but not found or not readable
  base::Diagnostics problems;  // of finding and reading it
};

/// Saving would put another tree in the place of one that somebody wrote.
struct TreeQuestion {
  enum class Why {
    ChangedOnDisk,     // the file that would be replaced is nobody's that we know
    BehaviourChanged,  // behaviour or goals are others than when the tree was written
  };
  EntityId human;
  std::string name;         // of the person
  std::string path;         // of the tree's file
  std::string mine;         // the tree that was written by hand
  std::string replacement;  // what the document says: the generated tree, or one edited here
  Why why = Why::ChangedOnDisk;
};

/// The people whose tree is to be replaced; those of others are kept.
using TreesToReplace = std::set<EntityId>;

/// The scenario being edited, with its map, trees, undo stack and selection. GUI thread.
/// Only commands (EditCommands.h, MapEdit.h) write: the functions `exchange…` are for them.
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
  EntityId goalKey(int goalId) const;                             // of the goal with this number
  int indexOf(EntityId id) const;                                 // in its list, -1 = not there
  EntityId newId(EntityKind kind) { return {kind, nextKey_++}; }  // never given before here
  EntitySlot exchange(EntityId id, EntitySlot slot);
  /// What is exchanged while it lives is one step, steps within it included: `changed` tells of
  /// each thing, `settled` and `selectionChanged` of all at once when the outermost ends.
  class Step {
   public:
    explicit Step(ScenarioDocument& document) : document_(document) { ++document_.steps_; }
    ~Step() { document_.endStep(); }
    Q_DISABLE_COPY_MOVE(Step)

   private:
    ScenarioDocument& document_;
  };

  /// A person's own tree (XML text); none = the generated one of the behaviour.
  std::optional<std::string> tree(EntityId human) const;
  std::optional<std::string> exchangeTree(EntityId human, std::optional<std::string> xml);
  /// The tree that a run uses: the person's own, else that of the file while it still says what
  /// the person does, else one in the style of the file; none = the generator's.
  std::optional<std::string> treeToRun(EntityId human) const;

  /// The person's own tree does what behaviour and goals said when it was written; they say
  /// something else now. Saving asks about it.
  bool isTreeBehind(EntityId human) const;

  /// All that a run takes, as it is now, saved or not.
  app::Bundle bundle() const;
  const std::shared_ptr<app::KnownSurroundings>& surroundings() const { return surroundings_; }
  /// Ends work on the map as it is now, wherever it goes on.
  base::StopFlagPtr mapWork() const { return mapWork_; }
  void stopMapWork();

  // map; never null, an empty grid is the open plane
  std::shared_ptr<const sim2d::OccupancyGrid> map() const { return map_.grid; }
  QString mapPath() const { return map_.path; }  // of the YAML; empty: none, or not from a file
  void setMap(std::shared_ptr<const sim2d::OccupancyGrid> map) {
    exchangeMap({std::move(map), {}, false, {}});
  }
  const MapState& mapState() const { return map_; }
  MapState exchangeMap(MapState map);

  // undo
  QUndoStack& undoStack() { return undoStack_; }
  bool isDirty() const { return !undoStack_.isClean() || neverSaved_; }

  // selection (not undoable, in the order of selecting)
  const std::vector<EntityId>& selection() const { return selection_; }
  bool isSelected(EntityId id) const;
  void setSelection(std::vector<EntityId> ids);
  void toggleSelected(EntityId id);

  // files; all problems are returned
  QString path() const { return path_; }  // empty: not saved yet
  QString displayName() const;            // "cafe.yaml" or "Untitled"
  void clear();                           // a new, empty scenario
  void load(sim2d::Scenario scenario);    // from code (templates, tests): new, unsaved
  /// With errors the document has not changed, unless it isReadOnly then: a damaged file is shown
  /// as far as it can be read. One of which nothing can be read takes the place of an empty
  /// document only.
  base::Diagnostics open(const QString& path);
  /// Map and folder with trees in place of the scenario's, for the next files that are opened.
  void setSearch(const QString& map, const QString& trees);
  /// Read in part: saved only under another name.
  bool isReadOnly() const;
  /// Canonical YAML and one tree per person: in ../behavior_trees when the folder is called
  /// scenarios, else beside. A new file name becomes yaml_base_name and the stem of the trees. All
  /// files are written or none; with errors nothing has changed on the disk.
  base::Diagnostics save(const QString& path, const TreesToReplace& replaced = {});
  /// What must be decided before saving there; without an answer the tree that is there is kept.
  std::vector<TreeQuestion> treeQuestions(const QString& path) const;
  /// Comments in the file that was opened; saving over it loses them.
  int commentCount() const { return commentCount_; }
  /// Read a nav2 map and remember its place in the scenario (one undoable command).
  base::Diagnostics openMap(const QString& yamlPath);
  /// A new scenario on it; with errors the document has not changed.
  base::Diagnostics newOnMap(const QString& yamlPath);
  void setShippedMaps(const QString& folder) { search_.shippedMaps = folder.toStdString(); }
  bool isShipped(const QString& file) const;  // lies among the program's own
  /// Files that were read or written, and those of them that someone else has changed since.
  QStringList files() const;
  QStringList changedOnDisk() const;
  void acceptDisk();  // they count as known from now on; what is edited stays

  // all that is not saved, for another start of the program; it comes back unsaved, or as if saved
  DocumentSnapshot snapshot() const;
  void restore(DocumentSnapshot snapshot, bool isSaved = false);

  // messages
  base::Diagnostics issues() const;  // of loading, of the map, then of the live check
  void checkNow();                   // without the pause that follows edits, to its end
  void checkSoon();                  // without that pause; waits a moment only

 Q_SIGNALS:
  void changed(editor::Change change);  // of one thing; more may follow at once
  void settled();                       // behind the last `changed` of a step
  void aboutToBeReplaced();             // by another document; typed text is committed to this one
  void mapChanged();
  void selectionChanged();
  void pathChanged();
  void dirtyChanged(bool dirty);
  void issuesChanged(const base::Diagnostics& issues);

 private:
  base::Diagnostics mapProblemsToTell() const;
  void replaceAll(sim2d::Scenario scenario);
  void replaced();  // by another file or nothing: tells of everything
  void tellOfFile();
  sim2d::FilePlaces places() const;
  void endStep();
  void loadMap();
  void putMap(MapState map);
  void restoreMap(const DocumentSnapshot& snapshot);
  base::Diagnostics loadTrees();
  void startCheck();
  /// What saving there would do; looks at the disk, changes nothing.
  SavePlan planSave(const QString& path) const;
  void placeMap(SavePlan& plan) const;
  void planTrees(SavePlan& plan) const;
  /// The tree that is saved for a person, and run: the own one, that of the file or the generated.
  std::string wantedTree(const sim2d::Scenario& scenario, const sim2d::Human& human) const;
  void answerTrees(const QString& path, const TreesToReplace& replaced);
  void takeSaved(SavePlan plan);

  sim2d::Scenario scenario_;
  MapState map_{std::make_shared<sim2d::OccupancyGrid>(), {}, false, {}};
  std::map<EntityId, std::string> trees_;
  QUndoStack undoStack_;
  std::vector<EntityId> selection_;
  QString path_;
  sim2d::FilePlaces search_;  // but for the path
  base::Diagnostics loadDiagnostics_, checkIssues_;
  QTimer checkTimer_;
  const std::shared_ptr<app::KnownSurroundings> surroundings_;
  std::shared_ptr<base::StopFlag> mapWork_ = std::make_shared<base::StopFlag>();
  std::unique_ptr<LatestTask<base::Diagnostics>> liveCheck_;
  std::unique_ptr<DocumentDisk> disk_;
  int nextKey_ = 1;
  int steps_ = 0;  // that have not ended
  int commentCount_ = 0;
  bool lostSelected_ = false;  // in the step that has not ended
  bool neverSaved_ = false;
};

}  // namespace editor
