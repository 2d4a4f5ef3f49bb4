#include "app/window/StudyPanel.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QSaveFile>
#include <QSplitter>

#include "app/window/StudyEarlier.h"
#include "app/window/StudyWords.h"
#include "editor/look/FileDialog.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr int kFormWidth = 400;
constexpr int kRoom = 400;
constexpr QSize kLeastSize(240, 80);
constexpr int kLeastName = 150;
constexpr QSize kBarSize(100, 8);
constexpr int kCheckMs = 300;
constexpr int kProgressSteps = 1000;

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
    isEdited_ = written_.isNull() || form_->textFor(QFileInfo(file_).absolutePath()) != written_;
    checkSoon();
  });
  connect(&context_.document, &editor::ScenarioDocument::dirtyChanged, this,
          &StudyPanel::checkSoon);
  connect(&context_, &editor::PanelContext::themeChanged, this, &StudyPanel::paintWords);
  connect(results_, &StudyResults::playWanted, this, &StudyPanel::play);
  connect(&process_, &StudyProcess::began, this, [this](const StudyBegin& begin) {
    if (begun_) {
      showResultsOf(*begun_);
    }
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
  name_->setMinimumWidth(kLeastName);
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
  progress_->setFixedSize(kBarSize);
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
  report_->setEnabled(
      !isRunning() && !file_.isEmpty() &&
      QFileInfo::exists(QDir(resultsFolder()).filePath(QStringLiteral("results.csv"))));
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
  written_ = QString();
  anew_->hide();
  code_.forget();
  Q_EMIT codeWanted({});
  showEarlier();
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
  written_ = form_->textFor(QFileInfo(path).absolutePath());
  isEdited_ = false;
  follow();
  return true;
}

/// What lies in its folder, without a run.
void StudyPanel::showEarlier() {
  const StudyEarlier earlier = earlierIn(resultsFolder());
  const base::Result<Experiment> of =
      earlier.experiment ? parseExperiment(*earlier.experiment, file_.toStdString())
                         : readExperiment(file_.toStdString());
  shown_ = of && earlier.experiment ? std::optional(*of) : std::nullopt;
  total_ = earlier.runs;
  before_ = earlier.rows.size();
  trouble_ = earlier.trouble;
  results_->begin(earlier.paths, of ? comparedPath(*of) : QString());
  results_->add(earlier.rows);
}

/// Empty, until its rows come.
void StudyPanel::showResultsOf(const Experiment& experiment) {
  QStringList paths;
  for (const ExperimentValue& value : experiment.values) {
    paths.append(QString::fromStdString(value.path));
  }
  shown_ = experiment;
  trouble_.clear();
  results_->begin(paths, comparedPath(experiment));
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
  anew_->hide();  // with the words that it was an answer to
  const base::Result<Experiment> checked = experiment();
  const bool hasScenarios = !form_->scenarios().isEmpty();
  start_->setEnabled(bool(checked));
  if (!hasScenarios) {
    say(editor::capitalized(trouble_), !trouble_.isEmpty());
    return;
  }
  if (!checked) {
    say(QString::fromStdString(checked.diagnostics().front().message), true);
    return;
  }
  say(wordsOn(checked).join(QStringLiteral(": ")), !trouble_.isEmpty());
  follow();
}

/// Of an experiment that can be run: how large it is, and what else there is to know.
QStringList StudyPanel::wordsOn(const base::Result<Experiment>& checked) const {
  QStringList words = {sizeText(*checked)};
  if (!checked.diagnostics().empty()) {
    words.append(QString::fromStdString(checked.diagnostics().front().message));
  }
  if (context_.document.isDirty() && form_->scenarios().contains(context_.document.path())) {
    words.append(
        tr("changes of %1 that are not saved do not count").arg(context_.document.displayName()));
  }
  const std::size_t finished = results_->runs().rows().size();
  if (!trouble_.isEmpty()) {
    words.append(trouble_);
  } else if (finished > 0 && !isEdited_) {
    words.append(tr("%1 of %2 finished").arg(finished).arg(total_));
  }
  return words;
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
  written_ = form_->textFor(QFileInfo(file_).absolutePath());
  isEdited_ = false;
  return true;
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
