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
constexpr int kBarHeight = 8;
constexpr int kCheckMs = 300;
constexpr int kProgressSteps = 1000;

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

}  // namespace

StudyPanel::StudyPanel(editor::PanelContext& context)
    : context_(context),
      form_(new StudyForm(context)),
      results_(new StudyResults(this)),
      process_(this),
      name_(new editor::ElidedLabel(this)),
      says_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      start_(new QPushButton(this)),
      report_(new QPushButton(tr("Report"), this)),
      anew_(editor::linkButton(tr("Begin anew"), tr("Throws away the results in the folder"), this,
                               [this] { start(StudyProcess::Begin::Anew); })) {
  auto* rows = editor::arranged(new QVBoxLayout(this), {}, 0);
  rows->addWidget(makeHead());
  rows->addWidget(editor::dividerLine(this));
  auto* halves = new QSplitter(Qt::Horizontal, this);
  halves->setChildrenCollapsible(false);
  halves->addWidget(editor::scrollArea(form_, halves));
  auto* right = new QWidget(halves);
  editor::arranged(new QVBoxLayout(right), {}, 0, {makeState()})->addWidget(results_, 1);
  halves->addWidget(right);
  halves->setStretchFactor(0, 0);
  halves->setStretchFactor(1, 1);
  halves->setSizes({kFormWidth, 3 * kFormWidth});
  rows->addWidget(halves, 1);
  setMinimumSize(kLeastSize);  // it asks for no more room than its neighbours while it is hidden
  listen();
  anew_->hide();
  follow();
  check();
}

void StudyPanel::listen() {
  check_.setSingleShot(true);
  check_.setInterval(kCheckMs);
  connect(&check_, &QTimer::timeout, this, &StudyPanel::check);
  connect(form_, &StudyForm::changed, this, [this] {
    isEdited_ = true;
    checkSoon();
  });
  connect(&context_.document, &editor::ScenarioDocument::dirtyChanged, this,
          &StudyPanel::checkSoon);
  connect(&context_, &editor::PanelContext::themeChanged, this, &StudyPanel::paintWords);
  connect(results_, &StudyResults::playWanted, this, &StudyPanel::play);
  connect(&process_, &StudyProcess::began, this, [this](const StudyBegin& begin) {
    total_ = begin.runs;
    before_ = begin.finished;
    since_.start();
  });
  connect(&process_, &StudyProcess::rowsCame, this, [this](const std::vector<StudyRow>& came) {
    results_->add(came);
    showProgress();
    follow();
  });
  connect(&process_, &StudyProcess::ended, this, &StudyPanel::finish);
}

StudyPanel::~StudyPanel() {
  helper_.disconnect(this);
}

QWidget* StudyPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* row = editor::arranged(new QHBoxLayout(head), {12, 6, 12, 6}, 12);
  name_->setMinimumWidth(kFormWidth / 2);
  row->addWidget(name_, 1);
  open_ =
      editor::linkButton(tr("Open…"), tr("An experiment file"), head, [this] { askFile(false); });
  saveAs_ = editor::linkButton(tr("Save as…"),
                               tr("Where the experiment is kept, and beside it its results"), head,
                               [this] { askFile(true); });
  row->addWidget(open_);
  row->addWidget(saveAs_);
  row->addWidget(start_);
  row->addWidget(report_);
  report_->setToolTip(tr("A page with tables, intervals, tests and pictures"));
  connect(start_, &QPushButton::clicked, this, [this] { isRunning() ? stop() : start(); });
  connect(report_, &QPushButton::clicked, this, &StudyPanel::openReport);
  return head;
}

QWidget* StudyPanel::makeState() {
  auto* state = new QWidget(this);
  says_->setWordWrap(true);
  progress_->setRange(0, kProgressSteps);
  progress_->setTextVisible(false);
  progress_->setFixedSize(kFormWidth / 3, kBarHeight);
  auto* row = editor::arranged(new QHBoxLayout(state), {12, 8, 12, 4}, 12);
  row->addWidget(says_, 1);
  row->addWidget(anew_);
  row->addWidget(progress_);
  return state;
}

void StudyPanel::follow() {
  const std::size_t finished = results_->runs().rows().size();
  const bool goesOn = finished > 0 && finished < total_ && !isEdited_;
  start_->setText(isRunning() ? tr("Stop") : goesOn ? tr("Go on") : tr("Start"));
  start_->setDefault(!isRunning());
  report_->setEnabled(finished > 0 && !isRunning());
  open_->setEnabled(!isRunning());
  saveAs_->setEnabled(!isRunning());
  progress_->setVisible(isRunning());
  form_->setEditable(!isRunning());
  name_->setWords(file_.isEmpty() ? tr("New study") : QFileInfo(file_).fileName());
}

void StudyPanel::say(const QString& text, bool isProblem) {
  saysProblem_ = isProblem;
  says_->setText(text);
  paintWords();
}

void StudyPanel::paintWords() {
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText,
                  context_.theme().color(saysProblem_ ? editor::Role::Error : editor::Role::Text));
  says_->setPalette(colors);
}

QString StudyPanel::resultsFolder() const {
  const QFileInfo file(file_);
  return file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral("_results"));
}

void StudyPanel::setFile(const QString& path) {
  file_ = path;
  isEdited_ = true;  // until it is written
  results_->begin({}, {});
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
  if (isRunning()) {
    return false;
  }
  const base::Result<Experiment> read = readExperiment(path.toStdString());
  if (!read) {
    say(QString::fromStdString(read.diagnostics().front().text()), true);
    return false;
  }
  setFile(path);
  form_->show(*read);
  isEdited_ = false;
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
  QStringList words = {sizeText(*checked)};
  if (!checked.diagnostics().empty()) {
    words.append(QString::fromStdString(checked.diagnostics().front().message));
  }
  if (context_.document.isDirty() && form_->scenarios().contains(context_.document.path())) {
    words.append(
        tr("changes of %1 that are not saved do not count").arg(context_.document.displayName()));
  }
  say(words.join(QStringLiteral(": ")));
  follow();
}

/// A file whose study is as it was read stays as it is, with its comments.
bool StudyPanel::save() {
  if (!isEdited_) {
    return true;
  }
  const QByteArray text = form_->textFor(QFileInfo(file_).absolutePath()).toUtf8();
  QSaveFile file(file_);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
    say(tr("%1 cannot be written: %2").arg(file_, file.errorString()), true);
    return false;
  }
  isEdited_ = false;
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
  before_ = 0;
  results_->begin(paths, comparedPath(*checked));
  anew_->hide();
  process_.start(file_, resultsFolder(), cores(), begin, false);
  say(tr("Begins…"));
  follow();
}

void StudyPanel::stop() {
  process_.stop();
  say(tr("Stops…"));
}

void StudyPanel::showProgress() {
  const std::vector<StudyRow>& rows = results_->runs().rows();
  const std::size_t finished = rows.size();
  const std::size_t made = finished - std::min(before_, finished);
  QString text = tr("%1 of %2 runs").arg(finished).arg(total_);
  if (isRunning() && made > 0 && finished < total_) {
    const double seconds = 1e-3 * static_cast<double>(since_.elapsed());
    const double left =
        seconds / static_cast<double>(made) * static_cast<double>(total_ - finished);
    text += tr(", %1 left").arg(durationText(left));
  }
  const auto failed =
      std::count_if(rows.begin(), rows.end(), [](const StudyRow& row) { return !row.isOk; });
  if (failed > 0) {
    text += tr(", %1 failed").arg(failed);
  }
  progress_->setValue(total_ == 0 ? 0 : static_cast<int>(kProgressSteps * finished / total_));
  say(text);
  Q_EMIT counted(static_cast<int>(finished));
}

void StudyPanel::finish(bool isComplete, const QString& problems) {
  results_->compare();
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
  connect(&helper_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      say(helper_.errorString(), true);
    }
  });
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
  panels.add({90, QObject::tr("Study"), Qt::BottomDockWidgetArea, true, kRoom, false},
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
