#include "app/window/StudyPanel.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QSaveFile>
#include <QSplitter>
#include <QUrl>

#include "editor/look/FileDialog.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr int kFormWidth = 300;
constexpr int kRoom = 400;
constexpr QSize kLeastSize(240, 80);
constexpr int kHeadHeight = 40;
constexpr int kBarHeight = 8;
constexpr int kLeastColumn = 48;
constexpr int kMostColumn = 240;
constexpr int kColumnMargin = 32;  // beside a title, with the arrow of the order
constexpr int kCheckMs = 300;
constexpr int kCompareMs = 500;
constexpr int kEarlierMs = 500;
constexpr int kProgressSteps = 1000;
enum Page { NothingPage, ComparisonPage, RunsPage };

int cores() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// "48 s", "12 min", "3 h 20 min".
QString durationText(double seconds) {
  const auto minutes = static_cast<long long>(seconds / 60.0);
  return seconds < 100.0 ? QObject::tr("%1 s").arg(qRound(seconds))
         : minutes < 100 ? QObject::tr("%1 min").arg(minutes)
                         : QObject::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

/// "2 scenarios × 3 planners × 30 seeds = 180 runs"
QString sizeText(const Experiment& experiment) {
  QStringList parts = {editor::counted(experiment.scenarios.size(), QObject::tr("scenario"),
                                       QObject::tr("scenarios"))};
  for (const ExperimentValue& value : experiment.values) {
    if (!value.isDrawn() && value.texts.size() > 1) {
      const QString path = QString::fromStdString(value.path);
      parts.append(path.endsWith(QLatin1String(".planner"))
                       ? QObject::tr("%1 planners").arg(value.texts.size())
                       : QStringLiteral("%1 %2").arg(value.texts.size()).arg(path));
    }
  }
  parts.append(editor::counted(experiment.seeds.size(), QObject::tr("seed"), QObject::tr("seeds")));
  return parts.join(QStringLiteral(" × ")) + QStringLiteral(" = ") +
         editor::counted(experiment.runCount(), QObject::tr("run"), QObject::tr("runs"));
}

/// "error: this went wrong" -> "This went wrong"
QString withoutSeverity(const QString& line) {
  const QString head = QStringLiteral("error: ");
  return editor::capitalized(line.startsWith(head) ? line.mid(head.size()) : line);
}

/// Titles of metrics take two lines.
void styleHead(QHeaderView& head) {
  head.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter | Qt::Alignment(Qt::TextWordWrap));
  head.setFixedHeight(kHeadHeight);
  head.setMinimumSectionSize(kLeastColumn);
}

/// As wide as what is in them, at least as wide as half of their titles and each word of them.
void fitColumns(QTableView& table) {
  const QFontMetrics metrics(table.horizontalHeader()->font());
  for (int column = 0; column < table.model()->columnCount(); ++column) {
    const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
    int lines = metrics.horizontalAdvance(title) / 2;
    for (const QString& word : title.split(QLatin1Char(' '))) {
      lines = std::max(lines, metrics.horizontalAdvance(word));
    }
    lines += kColumnMargin;
    const int cells = static_cast<const QAbstractItemView&>(table).sizeHintForColumn(column);
    table.setColumnWidth(
        column, std::clamp(std::max(lines, cells + kColumnMargin / 2), kLeastColumn, kMostColumn));
  }
}

}  // namespace

StudyPanel::StudyPanel(editor::PanelContext& context)
    : context_(context),
      form_(new StudyForm(context)),
      process_(this),
      name_(new editor::ElidedLabel(this)),
      says_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      start_(new QPushButton(this)),
      report_(new QPushButton(tr("Report"), this)),
      anew_(editor::linkButton(tr("Begin anew"), tr("Throws away the results in the folder"), this,
                               [this] { start(StudyProcess::Begin::Anew); })),
      tabs_(new QTabBar(this)),
      pages_(new QStackedWidget(this)),
      comparison_(new QTableWidget(this)),
      runTable_(new QTableView(this)) {
  auto* rows = editor::arranged(new QVBoxLayout(this), {}, 0);
  rows->addWidget(makeHead());
  rows->addWidget(editor::dividerLine(this));
  auto* halves = new QSplitter(Qt::Horizontal, this);
  halves->setChildrenCollapsible(false);
  halves->addWidget(editor::scrollArea(form_, halves));
  halves->addWidget(makeResults());
  halves->setStretchFactor(0, 0);
  halves->setStretchFactor(1, 1);
  halves->setSizes({kFormWidth, 3 * kFormWidth});
  rows->addWidget(halves, 1);
  setMinimumSize(kLeastSize);  // it asks for no more room than its neighbours while it is hidden
  check_.setSingleShot(true);
  check_.setInterval(kCheckMs);
  compareSoon_.setSingleShot(true);
  compareSoon_.setInterval(kCompareMs);
  connect(&check_, &QTimer::timeout, this, &StudyPanel::check);
  connect(&compareSoon_, &QTimer::timeout, this, &StudyPanel::compare);
  connect(form_, &StudyForm::changed, this, &StudyPanel::checkSoon);
  connect(&process_, &StudyProcess::rowsCame, this, &StudyPanel::take);
  connect(&process_, &StudyProcess::ended, this, &StudyPanel::finish);
  anew_->hide();
  follow();
  check();
}

QWidget* StudyPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* row = editor::arranged(new QHBoxLayout(head), {12, 6, 12, 6}, 12);
  name_->setMinimumWidth(kFormWidth / 2);
  row->addWidget(name_, 1);
  row->addWidget(
      editor::linkButton(tr("Open…"), tr("An experiment file"), head, [this] { askFile(false); }));
  row->addWidget(editor::linkButton(tr("Save as…"),
                                    tr("Where the experiment is kept, and beside it its results"),
                                    head, [this] { askFile(true); }));
  row->addWidget(start_);
  row->addWidget(report_);
  report_->setToolTip(tr("A page with tables, intervals, tests and pictures"));
  connect(start_, &QPushButton::clicked, this, [this] { isRunning() ? stop() : start(); });
  connect(report_, &QPushButton::clicked, this, &StudyPanel::openReport);
  return head;
}

QWidget* StudyPanel::makeResults() {
  auto* part = new QWidget(this);
  auto* rows = editor::arranged(new QVBoxLayout(part), {}, 0);
  tabs_->addTab(tr("Comparison"));
  tabs_->addTab(tr("Runs"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  auto* state = editor::arranged(new QHBoxLayout, {12, 8, 12, 4}, 12);
  says_->setWordWrap(true);
  state->addWidget(says_, 1);
  state->addWidget(anew_);
  progress_->setRange(0, kProgressSteps);
  progress_->setTextVisible(false);
  progress_->setFixedSize(kFormWidth / 3, kBarHeight);
  state->addWidget(progress_);
  rows->addLayout(state);
  auto* strip = new QWidget(part);
  strip->setAutoFillBackground(true);
  strip->setBackgroundRole(QPalette::Window);
  editor::arranged(new QHBoxLayout(strip), {}, 0, {tabs_})->addStretch();
  rows->addWidget(strip);
  pages_->addWidget(
      editor::emptyState(tr("Choose scenarios and planners at the left, then press Start.\n"
                            "All planners meet the same people in each seed."),
                         part));
  editor::styleTable(*comparison_, tr("Comparison"));
  styleHead(*comparison_->horizontalHeader());
  comparison_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  comparison_->setSelectionMode(QAbstractItemView::NoSelection);
  pages_->addWidget(comparison_);
  sorted_.setSourceModel(&runs_);
  sorted_.setSortRole(Qt::UserRole);
  runTable_->setModel(&sorted_);
  editor::styleTable(*runTable_, tr("Runs"));
  runTable_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  styleHead(*runTable_->horizontalHeader());
  runTable_->setSortingEnabled(true);
  runTable_->sortByColumn(0, Qt::AscendingOrder);
  runTable_->setToolTip(tr("Double click plays a run"));
  pages_->addWidget(runTable_);
  rows->addWidget(pages_, 1);
  const auto playRow = [this](const QModelIndex& at) {
    play(runs_.rows()[static_cast<std::size_t>(sorted_.mapToSource(at).row())].run);
  };
  connect(runTable_, &QTableView::activated, this, playRow);
  connect(tabs_, &QTabBar::currentChanged, this, &StudyPanel::follow);
  return part;
}

void StudyPanel::follow() {
  const bool hasRows = !runs_.rows().empty();
  pages_->setCurrentIndex(!hasRows                     ? NothingPage
                          : tabs_->currentIndex() == 0 ? ComparisonPage
                                                       : RunsPage);
  tabs_->parentWidget()->setVisible(hasRows);
  start_->setText(isRunning()                               ? tr("Stop")
                  : hasRows && runs_.rows().size() < total_ ? tr("Go on")
                                                            : tr("Start"));
  start_->setDefault(!isRunning());
  report_->setEnabled(hasRows && !isRunning());
  progress_->setVisible(isRunning());
  form_->setEditable(!isRunning());
  name_->setWords(file_.isEmpty() ? tr("New study") : QFileInfo(file_).fileName());
}

void StudyPanel::say(const QString& text, bool isProblem) {
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText,
                  context_.theme().color(isProblem ? editor::Role::Error : editor::Role::Text));
  says_->setPalette(colors);
  says_->setText(text);
}

QString StudyPanel::resultsFolder() const {
  const QFileInfo file(file_);
  return file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral("_results"));
}

void StudyPanel::setFile(const QString& path) {
  file_ = path;
  runs_.begin({});
  anew_->hide();
  follow();
  checkSoon();
}

void StudyPanel::askFile(bool toSave) {
  QFileDialog dialog(this, toSave ? tr("Save the study") : tr("Open a study"),
                     file_.isEmpty() ? context_.folder() : QFileInfo(file_).absolutePath(),
                     tr("Experiments (*.yaml *.yml)"));
  dialog.setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog.setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog.setDefaultSuffix(QStringLiteral("yaml"));
  if (toSave) {
    dialog.selectFile(file_.isEmpty() ? QStringLiteral("study.yaml") : QFileInfo(file_).fileName());
  }
  editor::keepFiles(dialog, toSave);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const QString path = dialog.selectedFiles().value(0);
  if (toSave) {
    setFile(path);
    save();
  } else {
    openFile(path);
  }
}

bool StudyPanel::openFile(const QString& path) {
  const base::Result<Experiment> read = readExperiment(path.toStdString());
  if (!read) {
    say(QString::fromStdString(read.diagnostics().front().text()), true);
    return false;
  }
  setFile(path);
  form_->show(*read);
  return true;
}

base::Result<Experiment> StudyPanel::experiment() const {
  const QString folder = file_.isEmpty() ? context_.folder() : QFileInfo(file_).absolutePath();
  const QString path =
      file_.isEmpty() ? QDir(folder).filePath(QStringLiteral("study.yaml")) : file_;
  return parseExperiment(form_->textFor(folder).toStdString(), path.toStdString());
}

/// What it would be, or what is wrong with it, while nothing runs.
void StudyPanel::check() {
  if (isRunning()) {
    return;
  }
  const base::Result<Experiment> checked = experiment();
  const bool hasScenarios = !form_->scenarios().isEmpty();
  start_->setEnabled(bool(checked));
  if (!hasScenarios) {
    say({});
    return;
  }
  if (!checked) {
    say(QString::fromStdString(checked.diagnostics().front().message), true);
    return;
  }
  total_ = checked->runCount();
  compared_ = comparedPath(*checked);
  say(checked.diagnostics().empty()
          ? sizeText(*checked)
          : sizeText(*checked) + QStringLiteral(": ") +
                QString::fromStdString(checked.diagnostics().front().message));
  follow();
}

bool StudyPanel::save() {
  const QByteArray text = form_->textFor(QFileInfo(file_).absolutePath()).toUtf8();
  QFile there(file_);
  if (there.open(QIODevice::ReadOnly) && there.readAll() == text) {
    return true;
  }
  QSaveFile file(file_);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
    say(tr("%1 cannot be written: %2").arg(file_, file.errorString()), true);
    return false;
  }
  return true;
}

void StudyPanel::start(StudyProcess::Begin begin) {
  if (isRunning()) {
    return;
  }
  if (file_.isEmpty()) {
    askFile(true);
  }
  const base::Result<Experiment> checked = experiment();
  if (file_.isEmpty() || !checked || !save()) {
    check();
    return;
  }
  QStringList paths;
  for (const ExperimentValue& value : checked->values) {
    paths.append(QString::fromStdString(value.path));
  }
  total_ = checked->runCount();
  compared_ = comparedPath(*checked);
  before_ = 0;
  runs_.begin(paths);
  anew_->hide();
  since_.start();
  process_.start(file_, resultsFolder(), cores(), begin, false);
  say(tr("Begins…"));
  follow();
}

void StudyPanel::stop() {
  process_.stop();
  say(tr("Stops…"));
}

void StudyPanel::take(const std::vector<StudyRow>& rows) {
  const bool wasEmpty = runs_.rows().empty();
  for (const StudyRow& row : rows) {
    runs_.add(row);
  }
  if (since_.elapsed() < kEarlierMs) {
    before_ = runs_.rows().size();  // those of before come at once
  }
  showProgress();
  if (!compareSoon_.isActive()) {
    compareSoon_.start();
  }
  if (wasEmpty) {
    compare();
    fitColumns(*runTable_);
    follow();
  }
}

void StudyPanel::showProgress() {
  const std::size_t finished = runs_.rows().size();
  const std::size_t made = finished - before_;
  QString text = tr("%1 of %2 runs").arg(finished).arg(total_);
  if (made > 0 && finished < total_) {
    const double seconds = 1e-3 * static_cast<double>(since_.elapsed());
    const double left =
        seconds / static_cast<double>(made) * static_cast<double>(total_ - finished);
    text += tr(", %1 left").arg(durationText(left));
  }
  const auto failed = static_cast<std::size_t>(std::count_if(
      runs_.rows().begin(), runs_.rows().end(), [](const StudyRow& row) { return !row.isOk; }));
  if (failed > 0) {
    text += tr(", %1 failed").arg(failed);
  }
  progress_->setValue(total_ == 0 ? 0 : static_cast<int>(kProgressSteps * finished / total_));
  say(text);
  Q_EMIT counted(static_cast<int>(finished));
}

/// Options side by side, as far as they have come.
void StudyPanel::compare() {
  const auto options = runs_.byOption(compared_);
  QStringList titles = {compared_.isEmpty() ? tr("Scenario") : pathTitle(compared_), tr("Runs")};
  for (const StudyMetric& metric : studyMetrics()) {
    titles.append(metric.unit.isEmpty() ? metric.title
                                        : QStringLiteral("%1 [%2]").arg(metric.title, metric.unit));
  }
  comparison_->setColumnCount(titles.size());
  comparison_->setHorizontalHeaderLabels(titles);
  comparison_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  comparison_->setRowCount(static_cast<int>(options.size()));
  for (std::size_t k = 0; k < options.size(); ++k) {
    QStringList cells = {options[k].first, QString::number(options[k].second.size())};
    for (const StudyMetric& metric : studyMetrics()) {
      cells.append(estimateText(metric, options[k].second));
    }
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setTextAlignment(
          int((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter));
      item->setToolTip(column < 2 ? QString() : tr("Mean and 95 % interval"));
      comparison_->setItem(static_cast<int>(k), column, item);
    }
  }
  fitColumns(*comparison_);
}

void StudyPanel::finish(bool isComplete, const QString& problems) {
  compare();
  if (!problems.isEmpty()) {
    const QStringList lines = problems.split(QLatin1Char('\n'));
    say(withoutSeverity(lines.front()), true);
    says_->setToolTip(problems);
    anew_->setVisible(QFileInfo::exists(resultsFolder()));
  } else {
    showProgress();
    says_->setToolTip({});
    if (!isComplete) {
      say(says_->text() + tr(": stopped, what is finished is kept"));
    }
  }
  follow();
}

/// One after the other: the second click waits for nothing.
void StudyPanel::runProgram(const QStringList& words, const QString& saying,
                            const std::function<void()>& then) {
  if (helper_.state() != QProcess::NotRunning) {
    return;
  }
  say(saying);
  helper_.disconnect(this);
  connect(&helper_, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
          [this, then](int code, QProcess::ExitStatus status) {
            const bool isFine = status == QProcess::NormalExit && code <= 1;
            if (isFine) {
              showProgress();
              then();
            } else {
              say(QString::fromUtf8(helper_.readAllStandardError()).trimmed(), true);
            }
          });
  helper_.start(process_.program(), words);
}

/// The folder of a run that was kept, else the run is made once more.
void StudyPanel::play(int run) {
  const QString kept = QDir(resultsFolder()).filePath(QStringLiteral("runs/%1").arg(run));
  if (QFileInfo::exists(kept)) {
    Q_EMIT runWanted(kept);
    return;
  }
  const base::Result<Experiment> read = readExperiment(file_.toStdString());
  if (!read || static_cast<std::size_t>(run) >= read->runCount()) {
    return;
  }
  QStringList words;
  for (const std::string& word : read->wordsOf(static_cast<std::size_t>(run))) {
    words.append(QString::fromStdString(word));
  }
  played_ = std::make_unique<QTemporaryDir>();
  const QString folder = played_->filePath(QStringLiteral("run_%1").arg(run));
  words << QStringLiteral("--quiet") << QStringLiteral("-o") << folder;
  runProgram(words, tr("Makes run %1 once more…").arg(run),
             [this, folder] { Q_EMIT runWanted(folder); });
}

void StudyPanel::openReport() {
  const QString folder = resultsFolder();
  runProgram({QStringLiteral("report"), folder, QStringLiteral("--quiet")},
             tr("Writes the report…"), [folder] {
               QDesktopServices::openUrl(
                   QUrl::fromLocalFile(QDir(folder).filePath(QStringLiteral("report.html"))));
             });
}

editor::PanelRegistry windowPanels() {
  editor::PanelRegistry panels = editor::standardPanels();
  panels.add({90, QObject::tr("Study"), Qt::BottomDockWidgetArea, true, kRoom},
             [](editor::PanelContext& context) {
               auto* panel = new StudyPanel(context);
               QObject::connect(
                   panel, &StudyPanel::counted, &context,
                   [&context, panel](int count) { Q_EMIT context.counted(panel, count); });
               return panel;
             });
  return panels;
}

}  // namespace app
