#include "editor/panels/RunsPanel.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QVBoxLayout>

#include "editor/look/FileDialog.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "editor/panels/ForkDialog.h"
#include "editor/panels/Playback.h"
#include "editor/panels/RowDelegate.h"

namespace editor {

namespace {

enum RunColumn { RunNameColumn, LeftAtColumn, ChangedColumn, RunColumns };
constexpr int kRowRole = Qt::UserRole;
constexpr int kSwatch = 18;
constexpr int kRunNameWidth = 130;

/// The letter of a run on its line, as on the map and in the plots.
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

}  // namespace

RunsPanel::RunsPanel(PanelContext& context)
    : context_(context),
      list_(new QTreeWidget(this)),
      table_(new CompareTable(context)),
      fork_(new QPushButton(tr("Go on from here…"), this)),
      add_(new QPushButton(tr("Add a run…"), this)),
      show_(new QPushButton(tr("Show"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      beside_(new QPushButton(tr("Side by side"), this)),
      partings_(secondaryLabel({}, this)),
      reading_([this](const std::shared_ptr<ReadRun>& read) { takeRead(*read); }) {
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
  arranged(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this)})->addWidget(both, 1);
  connectRuns();
  fillList();
}

RunsPanel::~RunsPanel() {
  reading_.abandon();
}

QWidget* RunsPanel::makeHead() {
  auto* head = new QWidget(this);
  add_->setToolTip(tr("A recorded run, to be compared: the folder that `run` has written"));
  show_->setToolTip(tr("Show this run, at the same time"));
  remove_->setToolTip(tr("Forget this run"));
  beside_->setToolTip(tr("The runs that are compared stand beside the map, up to four"));
  beside_->setCheckable(true);
  partings_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the dock stays narrow
  arranged(new QHBoxLayout(head), {12, 6, 12, 6}, 8,
           {fork_, add_, show_, remove_, beside_, partings_})
      ->setStretch(5, 1);
  return head;
}

void RunsPanel::makeList() {
  styleList(*list_, tr("Runs"));
  list_->setRootIsDecorated(false);
  list_->setColumnCount(RunColumns);
  list_->setHeaderLabels({tr("Run"), tr("Left at"), tr("Changed")});
  list_->setIconSize(QSize(kSwatch, kSwatch));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setUniformRowHeights(true);
  QHeaderView* header = list_->header();
  header->setStretchLastSection(true);
  header->resizeSection(RunNameColumn, kRunNameWidth);
  header->resizeSection(LeftAtColumn, 56);
  list_->setMinimumWidth(240);
}

void RunsPanel::connectRuns() {
  connect(fork_, &QPushButton::clicked, this, &RunsPanel::forkShown);
  connect(add_, &QPushButton::clicked, this, [this] {
    QFileDialog dialog(window(), tr("Compare with the run of a folder"), context_.folder());
    dialog.setFileMode(QFileDialog::Directory);
    keepFiles(dialog, false);
    const bool isChosen = dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty();
    const QString folder = isChosen ? dialog.selectedFiles().front() : QString();
    if (!folder.isEmpty()) {
      addRecorded(folder);
    }
  });
  connect(show_, &QPushButton::clicked, this, &RunsPanel::showChosen);
  connect(remove_, &QPushButton::clicked, this, &RunsPanel::removeChosen);
  connect(beside_, &QPushButton::toggled, this, &RunsPanel::showBeside);
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, &RunsPanel::fillList);
  connect(list_, &QTreeWidget::itemChanged, this, &RunsPanel::takeCheck);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &RunsPanel::showChosen);
  connect(list_, &QTreeWidget::currentItemChanged, this, &RunsPanel::followChoice);
  SimulationRunner& runner = context_.runner;
  connect(&runner, &SimulationRunner::branchesChanged, this, &RunsPanel::fillList);
  connect(&runner, &SimulationRunner::stateChanged, this, [this] {
    followChoice();
    measure();
  });
  connect(&runner, &SimulationRunner::finished, this, &RunsPanel::measure);
  connect(&runner, &SimulationRunner::frameShown, this, [this] {
    showGhosts();
    followChoice();
  });
  connect(&context_, &PanelContext::themeChanged, this, [this](const Theme& theme) {
    fillList();
    if (side_ != nullptr) {
      side_->setTheme(theme);
    }
  });
  connect(table_, &CompareTable::measuredAll, this, &RunsPanel::showPartings);
}

std::vector<RunsPanel::Row> RunsPanel::rows() const {
  std::vector<Row> rows;
  for (const RunBranch& branch : context_.runner.branches()) {
    rows.push_back({branch.number, {}, branch.name, context_.runner.recordingOf(branch.number)});
  }
  rows.insert(rows.end(), guests_.begin(), guests_.end());
  return rows;
}

/// Those that are ticked beside the one that is shown and have something to show.
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

void RunsPanel::fillList() {
  if (isTakingEdit_) {  // Qt still uses the edited row
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
  Q_EMIT context_.counted(this, all.size() > 1 ? static_cast<int>(all.size()) : 0);
  followChoice();
  showGhosts();
  measure();
  showBeside();
  tellTimeline();
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
  for (const RunBranch& branch : context_.runner.branches()) {
    if (branch.number == row.branch && branch.from >= 0) {
      item.setText(LeftAtColumn, clockText(branch.leftAt));
      item.setText(ChangedColumn, branch.changed.isEmpty() ? tr("nothing") : branch.changed);
      item.setToolTip(ChangedColumn, branch.changed);
    }
  }
  item.setToolTip(RunNameColumn,
                  row.folder.isEmpty() ? tr("F2 gives it another name") : row.folder);
}

/// Recorded runs have left none: their names have the room.
void RunsPanel::showBranchColumns() {
  const std::vector<RunBranch>& branches = context_.runner.branches();
  const bool isAny = std::any_of(branches.begin(), branches.end(),
                                 [](const RunBranch& branch) { return branch.from >= 0; });
  if (list_->isColumnHidden(LeftAtColumn) != isAny) {
    return;
  }
  for (const int column : {int(LeftAtColumn), int(ChangedColumn)}) {
    list_->setColumnHidden(column, !isAny);
  }
  list_->header()->resizeSection(RunNameColumn, kRunNameWidth);
}

void RunsPanel::tellTimeline() {
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

void RunsPanel::takeCheck(QTreeWidgetItem* item, int column) {
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
    ticked_.insert(Row{shownBranch(), {}, {}, nullptr});  // the one before stays in sight
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
    guests_.erase(std::find(guests_.begin(), guests_.end(), *row));
    fillList();
  }
}

void RunsPanel::followChoice() {
  const std::optional<Row> row = chosen();
  fork_->setEnabled(context_.runner.canGoOnFromShown());
  const bool isFull = context_.runner.branches().size() >= SimulationRunner::kMostBranches;
  fork_->setToolTip(fork_->isEnabled()
                        ? tr("From the moment that is shown, as a branch beside this run: another "
                             "planner, another seed, or by hand")
                    : isFull ? tr("There are as many branches as there can be: remove one first")
                             : tr("From a moment that is past: go back on the timeline first"));
  add_->setEnabled(shownBranch() >= 0);
  show_->setEnabled(row && row->branch >= 0 && !isShown(*row));
  remove_->setEnabled(row && !isShown(*row));
}

void RunsPanel::forkShown() {
  SimulationRunner& runner = context_.runner;
  if (!runner.canGoOnFromShown()) {
    return;
  }
  runner.pause();
  const auto number = static_cast<int>(runner.branches().size());
  ForkDialog dialog(*runner.recording()->header(), runner.shownFrame()->time,
                    tr("Branch %1").arg(number), context_.theme(), window());
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  ticked_.insert(Row{shownBranch(), {}, {}, nullptr});  // to be compared with
  runner.goOnFromShown(dialog.changes(), dialog.name());
}

void RunsPanel::addRecorded(const QString& folder) {
  const QString path = QDir(folder).absolutePath();
  const std::size_t memory = context_.runner.historyMemory() / SimulationRunner::kMostBranches;
  reading_.start([path, memory] {
    return std::make_shared<ReadRun>(
        ReadRun{path, app::readRecordedRun(path.toStdString(), memory, app::CutRecords::Shown)});
  });
}

void RunsPanel::takeRead(const ReadRun& read) {
  if (!read.run) {
    Q_EMIT context_.problemsFound(read.run.diagnostics());
    return;
  }
  const QString name = QDir(read.folder).dirName();
  const Row row{-1, read.folder, read.run->cut ? tr("%1 (cut)").arg(name) : name,
                read.run->recording};
  if (read.run->cut) {
    Q_EMIT context_.problemsFound(read.run.diagnostics());
  }
  guests_.erase(std::remove(guests_.begin(), guests_.end(), row), guests_.end());
  guests_.push_back(row);
  ticked_.insert(row);
  fillList();
}

/// While a run goes on its metrics change all the time: they are compared when it rests.
void RunsPanel::measure() {
  if (context_.runner.state() == SimulationRunner::State::Running &&
      !context_.runner.isFinished()) {
    return;
  }
  std::vector<CompareTable::Run> runs;
  const RecordingPtr recording = context_.runner.recording();
  if (recording != nullptr && recording->size() > 0) {
    runs.push_back({recording, QStringLiteral("A"), -1});
    for (const Row& row : compared()) {
      const int style = styleOf(row);
      runs.push_back({row.recording,
                      ghostStyle(static_cast<std::size_t>(style), context_.theme()).letter, style});
    }
  }
  table_->compare(std::move(runs));
  showPartings();
}

void RunsPanel::showPartings() {
  partings_->setText(table_->partings());
  partings_->setToolTip(table_->partings());
}

void addRunsPanel(PanelRegistry& to) {
  to.add(closedBelow(72, QObject::tr("Runs")),
         [](PanelContext& context) { return new RunsPanel(context); });
}

}  // namespace editor
