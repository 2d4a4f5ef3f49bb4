#include <cmath>

#include "editor/look/CoreText.h"
#include "editor/look/TableExport.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/runs/Playback.h"
#include "editor/panels/runs/RunsPanel.h"

namespace editor {

namespace {

constexpr int kNumberWidth = 58;
constexpr int kPartWidth = 88;
constexpr int kNameWidth = 150;  // Least width of the metric names.

QString valueText(const metrics::MetricInfo& info, const std::optional<double>& value) {
  metrics::MetricResult result;
  result.info = info;
  result.value.value = value;
  return metricText(result);
}

/// "Path length [m]"
QString titleOf(const metrics::MetricInfo& info) {
  const QString name = coreText(info.name);
  return info.unit.empty() ? name
                           : QStringLiteral("%1 [%2]").arg(name, QString::fromStdString(info.unit));
}

/// "+0.12", "0": the difference of the other run from the first.
QString differenceText(const metrics::MetricInfo& info, const std::optional<double>& difference) {
  if (!difference) {
    return QStringLiteral("–");
  }
  metrics::MetricInfo number = info;
  number.kind = info.kind == metrics::Kind::Boolean ? metrics::Kind::Count : info.kind;
  const QString text = valueText(number, std::fabs(*difference));
  const bool isZero = text.count(QLatin1Char('0')) + text.count(QLatin1Char('.')) == text.size();
  return isZero ? QStringLiteral("=")
                : (*difference > 0.0 ? QStringLiteral("+") : QStringLiteral("−")) + text;
}

}  // namespace

CompareTable::CompareTable(PanelContext& context)
    : context_(context),
      plot_(new MetricPlot(context.theme())),
      task_([this](Measured measured) { deliver(std::move(measured)); }) {
  styleTable(*table_, tr("Metrics of the runs"));
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);  // Needed for five runs.
  table_->setWordWrap(false);  // A name that is cut in the middle keeps its unit.
  table_->viewport()->installEventFilter(this);
  auto* both = new QSplitter(Qt::Horizontal, this);
  both->addWidget(makeTable());
  both->addWidget(plot_);
  both->setStretchFactor(0, 3);
  both->setStretchFactor(1, 2);
  both->setSizes({480, 190});
  stack_->addWidget(nothing_);
  showWaiting(Waiting::ForRuns);
  stack_->addWidget(both);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &CompareTable::showSelected);
  connect(&context.runner, &SimulationRunner::frameShown, this, [this](const FramePtr& frame) {
    if (frame != nullptr) {
      plot_->setCursor(frame->time);
    }
  });
  connect(&context, &PanelContext::themeChanged, plot_, &MetricPlot::setTheme);
  connectExport(*plot_, context);
  makeTableSavable(*table_, tr("Metrics of the runs"));
}

QWidget* CompareTable::makeTable() {
  wholeRuns_ =
      linkButton(tr("Whole runs"), tr("Compare the whole runs, although they differ in length"),
                 this, [this] { fill(); });
  wholeRuns_->setCheckable(true);
  QSizePolicy policy = wholeRuns_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  wholeRuns_->setSizePolicy(policy);
  auto* part = new QWidget(this);
  auto* head = configuredLayout(new QHBoxLayout, {12, 4, 12, 4}, 8);
  head->addWidget(lengths_, 1);
  head->addWidget(wholeRuns_);
  auto* rows = configuredLayout(new QVBoxLayout(part), {}, 0);
  rows->addLayout(head);
  rows->addWidget(table_, 1);
  return part;
}

CompareTable::~CompareTable() {
  stop_->stop();
  task_.abandon();
}

base::Result<app::MetricsSetup> CompareTable::setup() const {
  base::Result<app::MetricsSetup> setup =
      app::metricsSetupOf(context_.document.scenario(), context_.document.path().toStdString());
  if (setup) {
    setup->selection = context_.feed.selection();
  }
  return setup;
}

void CompareTable::showWaiting(Waiting what) {
  nothing_->setText(what == Waiting::ForStart
                        ? tr("Start a run to branch from it or to compare it with recorded runs.")
                    : what == Waiting::ForRuns
                        ? tr("Branch from an earlier moment, or add a recorded run. Checked runs "
                             "are compared with the displayed run.")
                    : what == Waiting::ForPause ? tr("Pause the run to compare it.")
                                                : tr("Comparing the runs…"));
}

void CompareTable::compare(std::vector<Run> runs) {
  showWaiting(runs.size() < 2 ? Waiting::ForRuns : Waiting::ForResults);
  if (runs.size() < 2) {
    stop_->stop();
    stop_ = std::make_shared<base::StopFlag>();
    task_.forget();  // The task may have passed its last check of the flag.
    shown_ = {};
    divergences_.clear();
    fill();
    return;
  }
  const base::Result<app::MetricsSetup> setup = this->setup();
  if (!setup) {
    Q_EMIT context_.problemsFound(setup.diagnostics());
    return;
  }
  stop_->stop();
  stop_ = std::make_shared<base::StopFlag>();
  task_.start([runs = std::move(runs), setup = *setup, before = shown_,
               stop = base::StopFlagPtr(stop_)] { return measured(runs, setup, before, stop); });
}

/// Measures the runs; values that are known from before are reused.
CompareTable::Measured CompareTable::measured(std::vector<Run> runs, const app::MetricsSetup& setup,
                                              const Measured& before,
                                              const base::StopFlagPtr& stop) {
  Measured all;
  all.runs = std::move(runs);
  std::vector<const sim2d::Recording*> recordings;
  for (const Run& run : all.runs) {
    recordings.push_back(run.recording.get());
    all.sizes.push_back(run.recording->size());
  }
  all.end = app::commonEnd(recordings);
  for (std::size_t run = 0; run < all.runs.size(); ++run) {
    std::optional<std::size_t> known;
    for (std::size_t k = 0; k < before.runs.size(); ++k) {
      const bool isSame =
          before.runs[k].recording == all.runs[run].recording && before.sizes[k] == all.sizes[run];
      known = isSame ? std::optional(k) : known;
    }
    const sim2d::Recording& recording = *recordings[run];
    all.measures.push_back(known ? before.measures[*known]
                                 : app::measureRun(recording, setup, stop));
    if (all.end) {
      all.upToEnd.push_back(known && before.end == all.end
                                ? before.upToEnd[*known]
                                : app::measureRun(recording, setup, stop, *all.end));
    }
    if (run > 0) {
      all.divergences.push_back(app::divergenceTime(*recordings.front(), recording));
    }
  }
  return all;
}

/// True if the run has another scenario than the first one: its positions, and possibly its ids,
/// have other meanings.
bool CompareTable::hasOtherScenario(const Run& run) const {
  const std::string& ours = shown_.runs.front().recording->header()->scenario;
  const std::string& theirs = run.recording->header()->scenario;
  return !ours.empty() && !theirs.empty() && ours != theirs;
}

void CompareTable::deliver(Measured measured) {
  shown_ = std::move(measured);
  QStringList words;
  for (std::size_t k = 1; k < shown_.runs.size(); ++k) {
    const std::optional<double>& parting = shown_.divergences[k - 1];
    const QString& letter = shown_.runs[k].letter;
    words << (hasOtherScenario(shown_.runs[k]) ? tr("%1 has another scenario").arg(letter)
              : parting ? tr("%1 diverges at %2").arg(letter, clockText(*parting))
                        : tr("%1 is identical").arg(letter));
  }
  divergences_ = words.join(QStringLiteral(" · "));
  fill();
  Q_EMIT measuredAll();
}

/// "Values of whole runs · A 30.8 s, B 30.8 s", or "Compared up to 13.7 s · A 30.8 s, B 13.7 s ·
/// outcomes over whole runs"
void CompareTable::showLengths() {
  QStringList lengths;
  for (std::size_t k = 0; k < shown_.runs.size(); ++k) {
    const sim2d::Recording& recording = *shown_.runs[k].recording;
    lengths << tr("%1 %2 s").arg(shown_.runs[k].letter,
                                 tenthsText(recording.timeOf(shown_.sizes[k] - 1)));
  }
  QStringList parts = {lengths.join(QStringLiteral(", "))};
  if (isShortened()) {
    parts.prepend(tr("Compared up to %1 s").arg(tenthsText(*shown_.end)));
    parts.append(tr("outcomes over whole runs"));
  } else if (shown_.end) {
    parts.prepend(tr("Different lengths"));
  } else {
    parts.prepend(tr("Values of whole runs"));
  }
  lengths_->setFullText(parts.join(QStringLiteral(" · ")));
  wholeRuns_->setVisible(shown_.end.has_value());
}

void CompareTable::fill() {
  rows_ = isShortened() ? app::compareRecordingMetrics(shown_.measures, shown_.upToEnd)
                        : app::compareRecordingMetrics(shown_.measures);
  const auto runs = static_cast<int>(shown_.runs.size());
  stack_->setCurrentIndex(runs > 1 ? 1 : 0);
  showLengths();
  table_->clear();
  fillHead();
  table_->setRowCount(static_cast<int>(rows_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    fillRow(row);
  }
  showSelected();
}

void CompareTable::fillHead() {
  const auto runs = static_cast<int>(shown_.runs.size());
  QStringList heads = {tr("Metric")};
  for (const Run& run : shown_.runs) {
    heads << run.letter;
  }
  for (int k = 1; k < runs; ++k) {
    heads << QStringLiteral("%1 − A").arg(shown_.runs[static_cast<std::size_t>(k)].letter);
  }
  if (shown_.end) {
    heads << tr("Compared");
  }
  table_->setColumnCount(heads.size());
  table_->setHorizontalHeaderLabels(heads);
  QHeaderView* header = table_->horizontalHeader();
  for (int column = 1; column < heads.size(); ++column) {
    header->setSectionResizeMode(column, QHeaderView::Fixed);
    const bool isNumber = column < 2 * runs;
    header->resizeSection(column, isNumber ? kNumberWidth : kPartWidth);
    table_->horizontalHeaderItem(column)->setTextAlignment(
        static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
  }
  table_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  fitNames();
}

/// The names take the width that the other columns leave.
void CompareTable::fitNames() {
  int others = 0;
  for (int column = 1; column < table_->columnCount(); ++column) {
    others += table_->columnWidth(column);
  }
  if (table_->columnCount() == 0) {
    return;
  }
  const bool hasRoom = table_->viewport()->width() - others >= kNameWidth;
  table_->horizontalHeader()->setSectionResizeMode(
      0, hasRoom ? QHeaderView::Stretch : QHeaderView::Interactive);
  if (!hasRoom) {
    table_->setColumnWidth(0, kNameWidth);
  }
}

bool CompareTable::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Resize) {
    fitNames();
  }
  return QWidget::eventFilter(watched, event);
}

void CompareTable::fillRow(int row) {
  const auto runs = static_cast<int>(shown_.runs.size());
  const app::ComparedMetric& metric = rows_[static_cast<std::size_t>(row)];
  const auto put = [&](int column, const QString& text, bool isNumber) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(
        static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
    item->setToolTip(coreText(metric.info.name) + QLatin1Char('\n') +
                     QString::fromStdString(metric.info.formula));
    table_->setItem(row, column, item);
  };
  put(0, titleOf(metric.info), false);
  table_->item(row, 0)->setData(kSavedKeyRole, QString::fromStdString(metric.info.key));
  for (int k = 0; k < runs; ++k) {
    put(1 + k, valueText(metric.info, metric.values[static_cast<std::size_t>(k)]), true);
  }
  for (int k = 1; k < runs; ++k) {
    put(runs + k, differenceText(metric.info, metric.difference(static_cast<std::size_t>(k))),
        true);
  }
  if (shown_.end) {
    put(2 * runs, metric.isWholeRun ? tr("whole run") : tr("to %1 s").arg(tenthsText(*shown_.end)),
        false);
  }
  if (metric.info.key == chosen_) {
    table_->setCurrentCell(row, 0);
  }
}

/// Shows the selected row, else the first that differs.
void CompareTable::showSelected() {
  int row = table_->currentRow();
  if (row < 0) {
    const auto differs = std::find_if(rows_.begin(), rows_.end(), [](const auto& each) {
      return each.values.size() > 1 && each.difference(1).value_or(0.0) != 0.0;
    });
    row = differs == rows_.end() ? (rows_.empty() ? -1 : 0)
                                 : static_cast<int>(differs - rows_.begin());
  } else {
    chosen_ = rows_[static_cast<std::size_t>(row)].info.key;
  }
  std::vector<MetricPlot::Line> lines;
  if (row < 0) {
    plot_->show({}, {}, lines);
    return;
  }
  const metrics::MetricInfo& info = rows_[static_cast<std::size_t>(row)].info;
  for (std::size_t k = 0; k < shown_.runs.size(); ++k) {
    const auto curve = shown_.measures[k].curves.find(info.key);
    lines.push_back({curve == shown_.measures[k].curves.end() ? nullptr : &curve->second,
                     shown_.runs[k].style, shown_.runs[k].letter});
  }
  plot_->show(coreText(info.name), QString::fromStdString(info.unit), lines);
}

}  // namespace editor
