#pragma once

#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

#include "app/run/RecordedRun.h"
#include "editor/canvas/GhostLayer.h"
#include "editor/document/LatestTask.h"
#include "editor/panels/CompareTable.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/SideBySide.h"

namespace editor {

/// The run that is shown, its branches and recorded runs beside them: one of them is shown, others
/// are compared with it, as ghosts on the map or beside it, by their metrics, over time.
class RunsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RunsPanel(PanelContext& context);
  ~RunsPanel() override;
  Q_DISABLE_COPY_MOVE(RunsPanel)

  QTreeWidget& list() const { return *list_; }
  CompareTable& comparison() const { return *table_; }
  const GhostLayer& ghosts() const { return *ghosts_; }
  QPushButton& forkButton() const { return *fork_; }
  QPushButton& besideButton() const { return *beside_; }
  SideBySide* beside() const { return side_.get(); }  // null: nothing stands beside the map
  void addRecorded(const QString& folder);            // read beside the window
  void forkShown();                                   // asks how

 private:
  /// A row: a branch of the run, or a recorded run of a folder.
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
  void takeRead(const ReadRun& read);
  std::vector<Row> rows() const;
  bool isShown(const Row& row) const { return row.branch >= 0 && row.branch == shownBranch(); }
  int shownBranch() const { return context_.runner.branch(); }
  std::vector<Row> compared() const;
  int styleOf(const Row& row) const;
  void fillList();
  void fillItem(QTreeWidgetItem& item, const Row& row);
  void takeCheck(QTreeWidgetItem* item, int column);
  void showChosen();
  void removeChosen();
  void followChoice();
  void showGhosts();
  void measure();
  void showBeside();
  void showBranchColumns();
  void showPartings();
  void tellTimeline();
  std::optional<Row> chosen() const;
  GhostLayer::Ghost ghostOf(const Row& row, double time) const;

  PanelContext& context_;
  GhostLayer* ghosts_;  // of the scene
  QTreeWidget* list_;
  CompareTable* table_;
  QPushButton *fork_, *add_, *show_, *remove_, *beside_;
  QLabel* partings_;
  std::vector<Row> guests_;  // recorded runs
  std::set<Row> ticked_;
  std::unique_ptr<SideBySide> side_;
  bool isFilling_ = false;
  bool isTakingEdit_ = false;  // the rows of the list must stay meanwhile
  QTimer later_;               // fills the list after the edit
  LatestTask<std::shared_ptr<ReadRun>> reading_;
};

}  // namespace editor
