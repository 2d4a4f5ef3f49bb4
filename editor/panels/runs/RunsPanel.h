#pragma once

#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include <QtWidgets>

#include "app/run/RecordedRun.h"
#include "editor/canvas/ComparedRunLayers.h"
#include "editor/document/LatestTask.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/CompareTable.h"
#include "editor/panels/runs/SideBySide.h"

namespace editor {

/// The shown run, its branches and recorded runs. The others can be compared with the shown one as
/// ghosts on the map, side by side, by their metrics and over time.
class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(PanelContext& context);
  ~RunsPanel() override;
  Q_DISABLE_COPY_MOVE(RunsPanel)

  QTreeWidget& list() const { return *list_; }
  CompareTable& comparison() const { return *table_; }
  const GhostLayer& ghosts() const { return *ghosts_; }
  QPushButton& branchButton() const { return *branchButton_; }
  QPushButton& sideBySideButton() const { return *sideBySideButton_; }
  SideBySide* sideBySide() const { return side_.get(); }  // Null: no side-by-side view.
  void addRecorded(const QString& folder);                // Reads the run outside the GUI thread.
  void createBranch();                                    // Opens a dialog.

 private:
  /// A row: a branch of the run, or a recorded run from a folder.
  struct Row {
    int branch = -1;
    QString folder, name;
    RecordingPtr recording;
    bool operator<(const Row& other) const {
      return std::tie(branch, folder) < std::tie(other.branch, other.folder);
    }
    bool operator==(const Row& other) const {
      return branch == other.branch && folder == other.folder;
    }
  };
  struct ReadRun {
    QString folder;
    base::Result<app::RecordedRun> run;
  };
  QWidget* makeHead();
  void makeList();
  void connectRuns();
  void addReadRun(const ReadRun& read);
  std::vector<Row> rows() const;
  bool isShown(const Row& row) const { return row.branch >= 0 && row.branch == shownBranch(); }
  int shownBranch() const { return context_.runner.branch(); }
  std::vector<Row> compared() const;
  int styleOf(const Row& row) const;
  void fillList();
  void fillItem(QTreeWidgetItem& item, const Row& row);
  void handleCheckChange(QTreeWidgetItem* item, int column);
  void showChosen();
  void removeChosen();
  void followChoice();
  void showGhosts();
  void measure();
  void showSideBySide();
  void showBranchColumns();
  void showDivergences();
  void updateTimeline();
  std::optional<Row> chosen() const;
  GhostLayer::Ghost ghostOf(const Row& row, double time) const;

  PanelContext& context_;
  GhostLayer* ghosts_;  // Belongs to the scene.
  QTreeWidget* list_;
  CompareTable* table_;
  QPushButton *branchButton_, *add_, *show_, *remove_, *sideBySideButton_;
  QLabel* divergences_;
  std::vector<Row> recordedRuns_;  // Recorded runs.
  std::set<Row> ticked_;
  std::unique_ptr<SideBySide> side_;
  bool isFilling_ = false;
  bool isTakingEdit_ = false;  // The rows of the list must not change meanwhile.
  QTimer later_;               // Fills the list after the edit.
  LatestTask<std::shared_ptr<ReadRun>> reading_;
};

}  // namespace editor
