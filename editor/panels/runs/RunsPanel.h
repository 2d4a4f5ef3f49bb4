#pragma once

#include <set>
#include <tuple>

#include "app/run/RecordedRun.h"
#include "app/run/RunComparison.h"
#include "app/run/RunSpec.h"
#include "editor/canvas/ComparedRunLayers.h"
#include "editor/document/LatestTask.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/RunPlots.h"
#include "editor/panels/runs/SideBySide.h"
#include "sim2d/trace/Trace.h"

namespace editor {

/// Metrics of several runs side by side with the differences from the first run, and the selected
/// metric over time. Measured outside the GUI thread.
class CompareTable : public QWidget {
  Q_OBJECT
 public:
  struct Run {
    RecordingPtr recording;
    QString letter;
    int style = -1;  // -1: the shown run, which is the first.
  };
  explicit CompareTable(PanelContext& context);
  ~CompareTable() override;
  Q_DISABLE_COPY_MOVE(CompareTable)

  void compare(std::vector<Run> runs);
  /// What is missing before there is a comparison, as shown in place of one.
  enum class Waiting { ForStart, ForRuns, ForPause, ForResults };
  void showWaiting(Waiting what);
  bool isBusy() const { return task_.isBusy(); }
  QTableWidget& table() const { return *table_; }
  MetricPlot& plot() const { return *plot_; }
  /// The times at which the other runs diverge from the first, as text; empty: no comparison.
  QString divergences() const { return divergences_; }
  /// The lengths of the runs and the part that is compared.
  QString lengths() const { return lengths_->text(); }
  QAbstractButton& wholeRunsButton() const { return *wholeRuns_; }

 Q_SIGNALS:
  void measuredAll();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Measured {
    std::vector<Run> runs;
    std::vector<std::size_t> sizes;  // Sizes of the recordings.
    std::vector<app::RecordingMetrics> measures;
    std::optional<double> end;  // The end of the shortest run [s]; none: all are equally long.
    std::vector<app::RecordingMetrics> upToEnd;      // Empty without `end`.
    std::vector<std::optional<double>> divergences;  // Divergence times of the other runs [s].
  };
  static Measured measured(std::vector<Run> runs, const app::MetricsSetup& setup,
                           const Measured& before, const base::StopFlagPtr& stop);
  QWidget* makeTable();
  base::Result<app::MetricsSetup> setup() const;
  void showLengths();
  void fillHead();
  void fitNames();
  void fillRow(int row);
  bool isShortened() const { return shown_.end.has_value() && !wholeRuns_->isChecked(); }
  void deliver(Measured measured);
  bool hasOtherScenario(const Run& run) const;
  void fill();
  void showSelected();

  PanelContext& context_;
  QStackedLayout* stack_ = new QStackedLayout(this);
  QLabel* nothing_ = emptyState({}, this);
  QTableWidget* table_ = new QTableWidget(this);
  ElidedLabel* lengths_ = new ElidedLabel(this, Qt::ElideRight);
  QAbstractButton* wholeRuns_ = nullptr;
  MetricPlot* plot_;
  QString divergences_;
  Measured shown_;
  std::vector<app::ComparedMetric> rows_;
  std::string chosen_;  // Key of the metric.
  std::shared_ptr<base::StopFlag> stop_ = std::make_shared<base::StopFlag>();
  LatestTask<Measured> task_;
};

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
  QAbstractButton& branchButton() const { return *branchButton_; }
  QPushButton& sideBySideButton() const { return *sideBySideButton_; }
  SideBySide* sideBySide() const { return side_.get(); }  // Null: no side-by-side view.
  void addRecorded(const QString& folder);                // Reads the run outside the GUI thread.

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
  void showCanvasTitle();
  double comparedTime() const;
  QStringList endedRuns() const;
  QString letterOf(const Row& row) const;
  QString titleOf(const Row& row) const;
  void showBranchColumns();
  void fitRunNames();
  void showDivergences();
  void updateTimeline();
  void handleBranches();
  std::optional<Row> chosen() const;
  GhostLayer::Ghost ghostOf(const Row& row, double time) const;

  PanelContext& context_;
  GhostLayer* ghosts_;  // Belongs to the scene.
  QTreeWidget* list_ = new QTreeWidget(this);
  CompareTable* table_;
  QPushButton *branchButton_ = new QPushButton(tr("Branch here…"), this),
              *add_ = new QPushButton(tr("Add a run…"), this),
              *show_ = new QPushButton(tr("Show"), this),
              *remove_ = new QPushButton(tr("Remove"), this),
              *sideBySideButton_ = new QPushButton(tr("Side by side"), this);
  QLabel* divergences_ = secondaryLabel({}, this);
  std::vector<Row> recordedRuns_;  // Recorded runs.
  std::set<Row> ticked_;
  int newestBranch_ = 0;  // The branches up to this number have been seen.
  std::unique_ptr<SideBySide> side_;
  double afterEnd_ = 0.0;  // Chosen time after the end of the shown run [s]; 0: none.
  QString canvasTitle_;
  bool isFilling_ = false;
  bool isTakingEdit_ = false;  // The rows of the list must not change meanwhile.
  QTimer later_;               // Fills the list after the edit.
  QTimer settled_;             // Measures after the last new state of a paused run.
  std::size_t measured_ = 0;   // Number of states of the shown run when it was measured.
  LatestTask<std::shared_ptr<ReadRun>> reading_;
};

}  // namespace editor
