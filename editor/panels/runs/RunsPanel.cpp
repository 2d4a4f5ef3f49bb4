#include "editor/panels/runs/RunsPanel.h"

#include <algorithm>
#include <utility>

#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/runs/Playback.h"

namespace editor {

namespace {

enum RunColumn { RunNameColumn, LeftAtColumn, ChangedColumn, RunColumns };
constexpr int kRowRole = Qt::UserRole;
constexpr int kSwatch = 18;
constexpr int kLeastRunName = 100;
constexpr int kAfterHeading = 8;  // Also after the longest name [px].

/// A line in the style of a run with its letter, as on the map and in the plots.
QIcon styleIcon(int style, const Theme& theme) {
  return drawnIcon(kSwatch, [&](QPainter& painter) {
    QPen pen(theme.color(Role::Accent), 2.0);
    QString letter = QStringLiteral("A");
    if (style >= 0) {
      const GhostStyle look = ghostStyle(static_cast<std::size_t>(style), theme);
      pen.setColor(look.color);
      if (!look.dashes.isEmpty()) {
        pen.setDashPattern(look.dashes);
      }
      letter = look.letter;
    }
    painter.setPen(pen);
    painter.drawLine(QPointF(-8.0, 7.0), QPointF(8.0, 7.0));
    painter.setPen(theme.color(Role::Text));
    painter.setFont(theme.font(8.0, QFont::DemiBold));
    painter.drawText(QRectF(-9.0, -9.0, 18.0, 14.0), Qt::AlignCenter, letter);
  });
}

/// The name of the branch whose changes a branch keeps; empty: it branches from the first run.
QString parentBranchOf(const std::vector<RunnerBranch>& all, const RunnerBranch& branch) {
  const auto parent = std::find_if(all.begin(), all.end(), [&branch](const RunnerBranch& each) {
    return each.number == branch.from && each.from >= 0;
  });
  return parent == all.end() ? QString() : parent->name;
}

}  // namespace

RunsPanel::RunsPanel(PanelContext& context)
    : context_(context),
      table_(new CompareTable(context)),
      reading_([this](const std::shared_ptr<ReadRun>& read) { addReadRun(*read); }) {
  auto ghosts = std::make_unique<GhostLayer>(context.view.mapScene());
  ghosts_ = ghosts.get();
  context.view.mapScene().addRunLayer(std::move(ghosts));
  makeList();
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->setChildrenCollapsible(false);
  both->addWidget(list_);
  both->addWidget(table_);
  both->setStretchFactor(0, 2);
  both->setStretchFactor(1, 3);
  both->setSizes({290, 670});
  configuredLayout(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this)})
      ->addWidget(both, 1);
  connectRuns();
  fillList();
}

RunsPanel::~RunsPanel() {
  reading_.abandon();
}

QWidget* RunsPanel::makeHead() {
  auto* head = new QWidget(this);
  add_->setToolTip(tr("Add a recorded run to compare: the output folder of hunavsim run"));
  show_->setToolTip(tr("Show this run at the same time step"));
  remove_->setToolTip(tr("Remove this run from the list"));
  sideBySideButton_->setToolTip(tr("Show up to four compared runs beside the map"));
  sideBySideButton_->setCheckable(true);
  divergences_->setSizePolicy(QSizePolicy::Ignored,
                              QSizePolicy::Preferred);  // Keeps the dock narrow.
  configuredLayout(new QHBoxLayout(head), {12, 6, 12, 6}, 8,
                   {branchButton_, add_, show_, remove_, sideBySideButton_, divergences_})
      ->setStretch(5, 1);
  return head;
}

void RunsPanel::makeList() {
  styleList(*list_, tr("Runs"));
  makeTableSavable(*list_, tr("Runs"));
  list_->setRootIsDecorated(false);
  list_->setColumnCount(RunColumns);
  list_->setHeaderLabels({tr("Run"), tr("Branched at"), tr("Changed")});
  list_->setIconSize(QSize(kSwatch, kSwatch));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setUniformRowHeights(true);
  QHeaderView* header = list_->header();
  header->setStretchLastSection(false);
  header->setSectionResizeMode(ChangedColumn, QHeaderView::Stretch);
  header->resizeSection(LeftAtColumn, header->sectionSizeHint(LeftAtColumn) + kAfterHeading);
  list_->setMinimumWidth(240);
}

void RunsPanel::connectRuns() {
  connect(branchButton_, &QPushButton::clicked, context_.branch, &QAction::trigger);
  connect(add_, &QPushButton::clicked, this, [this] {
    QFileDialog dialog(window(), tr("Compare with a run folder"), context_.folder());
    dialog.setFileMode(QFileDialog::Directory);
    const QString folder = chosenFiles(dialog, false).value(0);
    if (!folder.isEmpty()) {
      addRecorded(folder);
    }
  });
  connect(show_, &QPushButton::clicked, this, &RunsPanel::showChosen);
  connect(remove_, &QPushButton::clicked, this, &RunsPanel::removeChosen);
  connect(sideBySideButton_, &QPushButton::toggled, this, &RunsPanel::showSideBySide);
  later_.setSingleShot(true);
  settled_.setSingleShot(true);
  settled_.setInterval(200);
  connect(&settled_, &QTimer::timeout, this, &RunsPanel::measure);
  connect(&later_, &QTimer::timeout, this, &RunsPanel::fillList);
  connect(list_, &QTreeWidget::itemChanged, this, &RunsPanel::handleCheckChange);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &RunsPanel::showChosen);
  connect(list_, &QTreeWidget::currentItemChanged, this, &RunsPanel::followChoice);
  SimulationRunner& runner = context_.runner;
  connect(&runner, &SimulationRunner::branchesChanged, this, &RunsPanel::handleBranches);
  connect(&runner, &SimulationRunner::stateChanged, this, [this] {
    followChoice();
    measure();
  });
  connect(&runner, &SimulationRunner::finished, this, &RunsPanel::measure);
  connect(&runner, &SimulationRunner::frameShown, this, [this] {
    afterEnd_ = 0.0;
    showGhosts();
    followChoice();
    const RecordingPtr recording = context_.runner.recording();
    if (recording != nullptr && recording->size() != measured_ &&
        context_.runner.state() == SimulationRunner::State::Paused) {
      settled_.start();  // A branch reached its start, or a step was made.
    }
  });
  connect(&context_, &PanelContext::timeAfterEndChosen, this, [this](double time) {
    afterEnd_ = time;
    showGhosts();
  });
  connect(&context_, &PanelContext::themeChanged, this, [this](const Theme& theme) {
    fillList();
    if (side_ != nullptr) {
      side_->setTheme(theme);
    }
  });
  connect(table_, &CompareTable::measuredAll, this, &RunsPanel::showDivergences);
}

std::vector<RunsPanel::Row> RunsPanel::rows() const {
  std::vector<Row> rows;
  for (const RunnerBranch& branch : context_.runner.branches()) {
    rows.push_back({branch.number, {}, branch.name, context_.runner.recordingOf(branch.number)});
  }
  rows.insert(rows.end(), recordedRuns_.begin(), recordedRuns_.end());
  return rows;
}

/// The ticked runs other than the shown one that have data.
std::vector<RunsPanel::Row> RunsPanel::compared() const {
  std::vector<Row> others;
  if (shownBranch() < 0) {
    return others;
  }
  for (const Row& row : rows()) {
    const bool isThere = row.recording != nullptr && row.recording->size() > 0;
    if (!isShown(row) && ticked_.count(row) > 0 && isThere) {
      others.push_back(row);
    }
  }
  return others;
}

int RunsPanel::styleOf(const Row& row) const {
  const std::vector<Row> others = compared();
  const auto found = std::find(others.begin(), others.end(), row);
  return found == others.end() ? -1 : static_cast<int>(found - others.begin());
}

/// Ticks the run that a new branch has left, for comparison.
void RunsPanel::handleBranches() {
  const std::vector<RunnerBranch>& branches = context_.runner.branches();
  const int newest = branches.empty() ? 0 : branches.back().number;
  if (newest > newestBranch_ && branches.back().from >= 0) {
    ticked_.insert(Row{branches.back().from, {}, {}, nullptr});
  }
  newestBranch_ = newest;
  fillList();
}

void RunsPanel::fillList() {
  if (isTakingEdit_) {  // Qt still uses the edited row.
    later_.start();
    return;
  }
  const QScopedValueRollback<bool> filling(isFilling_, true);
  const std::optional<Row> before = chosen();
  const std::vector<Row> all = rows();
  list_->clear();
  showBranchColumns();
  int index = 0;
  for (const Row& row : all) {
    auto* item = new QTreeWidgetItem(list_);
    item->setData(RunNameColumn, kRowRole, index++);
    fillItem(*item, row);
    if (before && *before == row) {
      list_->setCurrentItem(item);
    }
  }
  fitRunNames();
  Q_EMIT context_.counted(this, all.size() > 1 ? static_cast<int>(all.size()) : 0);
  followChoice();
  showGhosts();
  measure();
  showSideBySide();
  updateTimeline();
}

void RunsPanel::fillItem(QTreeWidgetItem& item, const Row& row) {
  item.setText(RunNameColumn, row.name);
  const bool isA = isShown(row);
  const int style = styleOf(row);
  Qt::ItemFlags flags = item.flags() | Qt::ItemIsUserCheckable;
  item.setFlags(row.branch >= 0 ? flags | Qt::ItemIsEditable : flags);
  item.setCheckState(RunNameColumn, isA || style >= 0 ? Qt::Checked : Qt::Unchecked);
  if (isA || style >= 0) {
    item.setIcon(RunNameColumn, styleIcon(isA ? -1 : style, context_.theme()));
  }
  if (isA) {
    QFont bold = item.font(RunNameColumn);
    bold.setWeight(QFont::DemiBold);
    item.setFont(RunNameColumn, bold);
  }
  for (const RunnerBranch& branch : context_.runner.branches()) {
    if (branch.number == row.branch && branch.from >= 0) {
      item.setText(LeftAtColumn, clockText(branch.branchTime));
      const QString changed = branch.changed.isEmpty() ? tr("nothing") : branch.changed;
      const QString parent = parentBranchOf(context_.runner.branches(), branch);
      item.setText(ChangedColumn,
                   parent.isEmpty() ? changed : tr("%1, from %2").arg(changed, parent));
      item.setToolTip(ChangedColumn, item.text(ChangedColumn));
    }
  }
  item.setToolTip(RunNameColumn, row.folder.isEmpty() ? tr("Press F2 to rename") : row.folder);
}

/// Without branches the columns are hidden, to leave space for the names.
void RunsPanel::showBranchColumns() {
  const std::vector<RunnerBranch>& branches = context_.runner.branches();
  const bool isAny = std::any_of(branches.begin(), branches.end(),
                                 [](const RunnerBranch& branch) { return branch.from >= 0; });
  if (list_->isColumnHidden(LeftAtColumn) != isAny) {
    return;
  }
  for (const int column : {int(LeftAtColumn), int(ChangedColumn)}) {
    list_->setColumnHidden(column, !isAny);
  }
  list_->header()->setSectionResizeMode(RunNameColumn,
                                        isAny ? QHeaderView::Interactive : QHeaderView::Stretch);
}

/// The names get the width that they need, at most that of "Changed".
void RunsPanel::fitRunNames() {
  if (!list_->isColumnHidden(LeftAtColumn)) {
    list_->resizeColumnToContents(RunNameColumn);
    const int room = list_->viewport()->width() - list_->columnWidth(LeftAtColumn);
    list_->setColumnWidth(
        RunNameColumn, std::clamp(list_->columnWidth(RunNameColumn) + kAfterHeading, kLeastRunName,
                                  std::max(kLeastRunName, room / 2)));
  }
}

void RunsPanel::updateTimeline() {
  std::vector<TimelineRun> runs;
  for (const Row& row : compared()) {
    TimelineRun& run = runs.emplace_back();
    run.style = static_cast<std::size_t>(styleOf(row));
    run.end = row.recording->timeOf(row.recording->size() - 1);
    for (std::size_t k = 0; k < row.recording->events().size(); ++k) {
      const auto& [step, event] = row.recording->events()[k];
      if (event.kind == sim2d::EventKind::Contact) {
        run.contacts.push_back(static_cast<double>(step) * row.recording->header()->dt);
      }
    }
  }
  Q_EMIT context_.comparedChanged(runs);
}

std::optional<RunsPanel::Row> RunsPanel::chosen() const {
  const QTreeWidgetItem* item = list_->currentItem();
  const std::vector<Row> all = rows();
  const auto index = item == nullptr
                         ? all.size()
                         : static_cast<std::size_t>(item->data(RunNameColumn, kRowRole).toInt());
  return index < all.size() ? std::optional(all[index]) : std::nullopt;
}

void RunsPanel::handleCheckChange(QTreeWidgetItem* item, int column) {
  const std::vector<Row> all = rows();
  const auto index = static_cast<std::size_t>(item->data(RunNameColumn, kRowRole).toInt());
  if (isFilling_ || column != RunNameColumn || index >= all.size()) {
    return;
  }
  const Row& row = all[index];
  if (item->checkState(RunNameColumn) == Qt::Checked) {
    ticked_.insert(row);
  } else {
    ticked_.erase(row);
  }
  const QScopedValueRollback<bool> taking(isTakingEdit_, true);
  if (const QString name = item->text(RunNameColumn); name != row.name) {
    context_.runner.renameBranch(row.branch, name);
  }
  later_.start();
}

void RunsPanel::showChosen() {
  const std::optional<Row> row = chosen();
  if (row && row->branch >= 0 && !isShown(*row)) {
    ticked_.insert(Row{shownBranch(), {}, {}, nullptr});  // Keeps the previous run visible.
    context_.runner.showBranch(row->branch);
  }
}

void RunsPanel::removeChosen() {
  const std::optional<Row> row = chosen();
  if (!row || isShown(*row)) {
    return;
  }
  ticked_.erase(*row);
  if (row->branch >= 0) {
    context_.runner.removeBranch(row->branch);
  } else {
    recordedRuns_.erase(std::find(recordedRuns_.begin(), recordedRuns_.end(), *row));
    fillList();
  }
}

void RunsPanel::followChoice() {
  const std::optional<Row> row = chosen();
  branchButton_->setEnabled(context_.runner.canBranchFromShown());
  branchButton_->setToolTip(branchButton_->isEnabled()
                                ? context_.branch->toolTip()
                                : context_.branch->property(kWhyDisabledProperty).toString());
  add_->setEnabled(shownBranch() >= 0);
  show_->setEnabled(row && row->branch >= 0 && !isShown(*row));
  remove_->setEnabled(row && !isShown(*row));
}

void RunsPanel::addRecorded(const QString& folder) {
  const QString path = QDir(folder).absolutePath();
  const std::size_t memory = context_.runner.historyMemory() / SimulationRunner::kMaxBranches;
  reading_.start([path, memory] {
    return std::make_shared<ReadRun>(ReadRun{
        path, app::readRecordedRun(path.toStdString(), memory, app::IncompleteRecordings::Shown)});
  });
}

void RunsPanel::addReadRun(const ReadRun& read) {
  if (!read.run) {
    Q_EMIT context_.problemsFound(read.run.diagnostics());
    return;
  }
  const QString name = QDir(read.folder).dirName();
  const Row row{-1, read.folder, read.run->cut ? tr("%1 (truncated)").arg(name) : name,
                read.run->recording};
  if (read.run->cut) {
    Q_EMIT context_.problemsFound(read.run.diagnostics());
  }
  recordedRuns_.erase(std::remove(recordedRuns_.begin(), recordedRuns_.end(), row),
                      recordedRuns_.end());
  recordedRuns_.push_back(row);
  ticked_.insert(row);
  fillList();
}

/// The metrics of a running simulation change continuously, so they are compared only while it is
/// paused.
void RunsPanel::measure() {
  if (context_.runner.state() == SimulationRunner::State::Running &&
      !context_.runner.isFinished()) {
    table_->showWaiting(compared().empty() ? CompareTable::Waiting::ForRuns
                                           : CompareTable::Waiting::ForPause);
    return;
  }
  std::vector<CompareTable::Run> runs;
  const RecordingPtr recording = context_.runner.recording();
  measured_ = recording == nullptr ? 0 : recording->size();
  if (measured_ > 0) {
    runs.push_back({recording, QStringLiteral("A"), -1});
    for (const Row& row : compared()) {
      const int style = styleOf(row);
      runs.push_back({row.recording,
                      ghostStyle(static_cast<std::size_t>(style), context_.theme()).letter, style});
    }
  }
  const bool isExpected = runs.empty() && !compared().empty();  // The branch has no states yet.
  table_->compare(std::move(runs));
  if (isExpected || shownBranch() < 0) {
    table_->showWaiting(isExpected ? CompareTable::Waiting::ForResults
                                   : CompareTable::Waiting::ForStart);
  }
  showDivergences();
}

void RunsPanel::showDivergences() {
  QStringList words = endedRuns();
  if (!table_->divergences().isEmpty()) {
    words.prepend(table_->divergences());
  }
  divergences_->setText(words.join(QStringLiteral(" · ")));
  divergences_->setToolTip(divergences_->text());
}

void addRunsPanel(PanelRegistry& to) {
  to.add(closedBottomPanel(72, QObject::tr("Runs")),
         [](PanelContext& context) { return new RunsPanel(context); });
}

}  // namespace editor
