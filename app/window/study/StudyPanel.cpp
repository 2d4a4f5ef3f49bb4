#include "app/window/study/StudyPanel.h"

#include "app/window/study/StudyResults.h"
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
constexpr int kMessageLines = 2;

/// Keeps the place of the widget while it is hidden, so that nothing moves when it appears.
void reserveSpace(QWidget& widget) {
  QSizePolicy policy = widget.sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  widget.setSizePolicy(policy);
}

/// Makes the button as wide as the widest of its texts.
void reserveWidth(QPushButton& button, const QStringList& texts) {
  int width = 0;
  for (const QString& text : texts) {
    button.setText(text);
    width = std::max(width, button.sizeHint().width());
  }
  button.setMinimumWidth(width);
}

/// A file for a new study in the folder that neither exists nor has results.
QString unusedFile(const QDir& folder, const QString& name) {
  for (int number = 1;; ++number) {
    const QString base = number == 1 ? name : QStringLiteral("%1_%2").arg(name).arg(number);
    if (!folder.exists(base + QStringLiteral(".yaml")) &&
        !folder.exists(base + QStringLiteral("_results"))) {
      return folder.filePath(base + QStringLiteral(".yaml"));
    }
  }
}

/// A warning about the experiment, with the names that the window has for keys.
QString diagnosticText(const base::Diagnostic& diagnostic) {
  return diagnostic.code == "experiment.seeds-alike"
             ? StudyPanel::tr(
                   "All seeds have the same people: to vary them, set \"Variation "
                   "between seeds\" in the properties of the scenario")
             : editor::capitalized(QString::fromStdString(diagnostic.message));
}

}  // namespace

StudyPanel::StudyPanel(editor::PanelContext& context)
    : context_(context),
      form_(new StudyForm(context)),
      process_(this),
      hashing_([this](const QString& changed) {
        changedInput_ = changed;
        const bool isAsking = !restartButton_->isHidden() || !saveButton_->isHidden();
        if (!changed.isEmpty() && !isAsking) {  // the check hides the answers
          checkSoon();
        }
      }) {
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {}, 0,
                                        {makeHead(), editor::dividerLine(this)});
  auto* halves = new QSplitter(Qt::Horizontal, this);
  halves->setChildrenCollapsible(false);
  formArea_ = editor::scrollArea(form_, halves);
  halves->addWidget(formArea_);
  auto* right = new QWidget(halves);
  editor::configuredLayout(new QVBoxLayout(right), {}, 0, {makeState()})->addWidget(content_, 1);
  content_->addWidget(results_);
  halves->addWidget(right);
  halves->setStretchFactor(0, 0);
  halves->setStretchFactor(1, 1);
  halves->setSizes({kFormWidth, 3 * kFormWidth});
  rows->addWidget(halves, 1);
  setMinimumSize(kLeastSize);  // does not enlarge its dock area while hidden
  connectSignals();
  hideAnswers();
  updateControls();
  check();
}

void StudyPanel::connectSignals() {
  check_.setSingleShot(true);
  check_.setInterval(kCheckMs);
  connect(&check_, &QTimer::timeout, this, &StudyPanel::check);
  connect(form_, &StudyForm::changed, this, [this] {
    isEdited_ = written_.isNull() || form_->yamlFor(QFileInfo(file_).absolutePath()) != written_;
    checkSoon();
  });
  connect(&context_.document, &editor::ScenarioDocument::dirtyChanged, this,
          &StudyPanel::checkSoon);
  connect(&context_.document, &editor::ScenarioDocument::pathChanged, this,
          &StudyPanel::presetForm);
  connect(&context_, &editor::PanelContext::themeChanged, this, [this] {
    updateMessageColor();
    showOutputPage();
  });
  connect(form_, &StudyForm::resultsDropped, this, &StudyPanel::openFile);
  connect(results_, &StudyResults::playRequested, this, &StudyPanel::play);
  connect(&process_, &StudyProcess::began, this, [this](const StudyHeader& begin) {
    if (runningExperiment_) {
      showResultsOf(*runningExperiment_);
    }
    total_ = begin.runs;
    before_ = begin.finished;
    since_.start();
  });
  connect(&process_, &StudyProcess::rowsReceived, this, [this](const std::vector<StudyRow>& came) {
    results_->add(came);
    showProgress();
    updateControls();
  });
  connect(&process_, &StudyProcess::ended, this, &StudyPanel::finish);
}

/// A new study is about the open scenario.
void StudyPanel::presetForm() {
  if (isVisible() && file_.isEmpty() && !output_) {
    form_->presetOpenScenario();
  }
}

void StudyPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  presetForm();
}

StudyPanel::~StudyPanel() {
  hashing_.abandon();
  helperProcess_.disconnect(this);
}

QWidget* StudyPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* row = editor::configuredLayout(new QHBoxLayout(head), {12, 6, 12, 6}, 12);
  name_->setMinimumWidth(kLeastName);
  row->addWidget(name_, 1);
  reserveSpace(*progress_);
  progress_->setRange(0, kProgressSteps);
  progress_->setTextVisible(false);
  progress_->setFixedSize(kBarSize);
  row->addWidget(progress_);
  new_ = editor::linkButton(tr("New"), tr("Begin a new study of the open scenario"), head,
                            [this] { beginNew(); });
  open_ = editor::linkButton(
      tr("Open…"), tr("Open an experiment, or the results of tune, gate, sensitivity or search"),
      head, [this] { askFile(false); });
  saveAs_ = editor::linkButton(tr("Save as…"),
                               tr("Save the experiment as a file; its results are stored beside "
                                  "it"),
                               head, [this] { askFile(true); });
  reserveWidth(*start_, {tr("Start"), tr("Stop"), tr("Resume")});
  for (QWidget* button : std::initializer_list<QWidget*>{new_, open_, saveAs_, start_, report_}) {
    row->addWidget(button);
  }
  report_->setToolTip(tr("Write a page with tables, confidence intervals, tests and figures"));
  connect(start_, &QPushButton::clicked, this, [this] { isRunning() ? stop() : start(); });
  connect(report_, &QPushButton::clicked, this, &StudyPanel::openReport);
  return head;
}

QWidget* StudyPanel::makeState() {
  auto* state = new QWidget(this);
  messageLabel_->setTextFormat(Qt::PlainText);  // names of files are no markup
  messageLabel_->setWordWrap(true);
  messageLabel_->setAlignment(Qt::AlignLeft | Qt::AlignTop);  // long messages begin readable
  messageLabel_->setFixedHeight(kMessageLines * messageLabel_->fontMetrics().lineSpacing() + 2);
  auto* row = editor::configuredLayout(new QHBoxLayout(state), {12, 8, 12, 4}, 12);
  row->addWidget(messageLabel_, 1);
  for (QAbstractButton* answer : {restartButton_, saveButton_, asSavedButton_}) {
    row->addWidget(answer, 0, Qt::AlignTop);
  }
  return state;
}

/// Hides the answers to a refused start, together with its message.
void StudyPanel::hideAnswers() {
  for (QAbstractButton* answer : {restartButton_, saveButton_, asSavedButton_}) {
    answer->hide();
  }
}

/// A new study of the open scenario; the results of the current one stay in their folder.
void StudyPanel::beginNew() {
  form_->reset();
  setFile({});
  isEdited_ = false;
  form_->presetOpenScenario();
  updateControls();
}

void StudyPanel::updateControls() {
  const std::size_t finished = results_->runs().rows().size();
  const bool goesOn = finished > 0 && finished < total_ && !isEdited_;
  start_->setText(isRunning() ? tr("Stop") : goesOn ? tr("Resume") : tr("Start"));
  start_->setDefault(!isRunning());
  report_->setEnabled(!isRunning() && (output_ || hasResults()));
  new_->setEnabled(!isRunning());
  open_->setEnabled(!isRunning());
  saveAs_->setEnabled(!isRunning() && !output_);
  const QString obstacle = output_ ? tr("Results are shown: New begins a study") : QString();
  start_->setToolTip(obstacle);
  if (output_) {
    start_->setEnabled(false);
  }
  progress_->setVisible(isRunning());
  form_->setEditable(!isRunning());
  name_->setFullText(shownName().isEmpty() ? tr("New study") : shownName());
  name_->setToolTip(output_ ? output_->folder : file_);
}

QString StudyPanel::shownName() const {
  return output_ ? QFileInfo(output_->folder).fileName() : QFileInfo(file_).fileName();
}

bool StudyPanel::hasResults() const {
  return !file_.isEmpty() &&
         QFileInfo::exists(QDir(resultsFolder()).filePath(QStringLiteral("results.csv")));
}

void StudyPanel::showMessage(const QString& text, bool isProblem) {
  isMessageProblem_ = isProblem;
  messageLabel_->setText(text);
  messageLabel_->setToolTip(text);  // a very long message does not fit
  updateMessageColor();
}

void StudyPanel::updateMessageColor() {
  QPalette colors = palette();
  colors.setColor(
      QPalette::WindowText,
      context_.theme().color(isMessageProblem_ ? editor::Role::Error : editor::Role::Text));
  messageLabel_->setPalette(colors);
}

QString StudyPanel::resultsFolder() const {
  if (!resultsFolder_.isEmpty()) {
    return resultsFolder_;
  }
  const QFileInfo file(file_);
  return file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral("_results"));
}

void StudyPanel::setFile(const QString& path, const QString& results) {
  closeOutput();
  file_ = path;
  resultsFolder_ = results;
  isEdited_ = true;  // until saved
  written_ = QString();
  hideAnswers();
  allowedCode_.clear();
  whenAllowed_ = {};
  Q_EMIT codePermissionNeeded({});
  showRestored();
  updateControls();
  checkSoon();
}

void StudyPanel::askFile(bool toSave) {
  QFileDialog dialog(this, toSave ? tr("Save the study") : tr("Open a study"),
                     file_.isEmpty() ? context_.folder() : QFileInfo(file_).absolutePath(),
                     toSave ? tr("Experiments (*.yaml *.yml)")
                            : tr("Studies (*.yaml *.yml tune.json gate.json sensitivity.json "
                                 "archive.json)"));
  dialog.setAcceptMode(toSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog.setFileMode(toSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog.setDefaultSuffix(QStringLiteral("yaml"));
  if (toSave) {
    dialog.selectFile(file_.isEmpty() ? QStringLiteral("study.yaml") : QFileInfo(file_).fileName());
  }
  const QString path = editor::chosenFiles(dialog, toSave).value(0);
  if (path.isEmpty()) {
    return;
  }
  if (toSave) {
    setFile(path);
    save();
  } else {
    openFile(path);
  }
}

/// Chooses a new file beside the scenario; asks the user if that folder cannot be written.
void StudyPanel::chooseFile() {
  const QFileInfo folder(context_.folder());
  if (!folder.isDir() || !folder.isWritable()) {
    askFile(true);
    return;
  }
  const QString scenario = QFileInfo(form_->scenarios().value(0)).completeBaseName();
  setFile(unusedFile(QDir(folder.absoluteFilePath()), scenario.isEmpty()
                                                          ? QStringLiteral("study")
                                                          : scenario + QStringLiteral("_study")));
}

bool StudyPanel::openFile(const QString& path) {
  if (isRunning()) {
    return false;
  }
  if (const std::optional<std::string> results = report::studyOutputFile(path.toStdString())) {
    return openOutput(*results);
  }
  const bool isFolder = QFileInfo(path).isDir();
  const QString file = isFolder ? experimentOfBatch(path) : path;
  if (file.isEmpty()) {
    return false;
  }
  const base::Result<Experiment> read = readExperiment(file.toStdString());
  if (!read) {
    showMessage(QString::fromStdString(read.diagnostics().front().text()), true);
    return false;
  }
  setFile(file, isFolder ? QFileInfo(path).absoluteFilePath() : QString());
  form_->show(*read);
  written_ = form_->yamlFor(QFileInfo(file).absolutePath());
  isEdited_ = false;
  updateControls();
  return true;
}

/// Shows the existing results in the folder.
void StudyPanel::showRestored() {
  if (file_.isEmpty()) {  // a new study
    displayedExperiment_.reset();
    folderProblem_.clear();
    findChangedInput({});
    total_ = 0;
    before_ = 0;
    results_->begin({}, {});
    Q_EMIT context_.counted(this, 0);
    return;
  }
  const RestoredStudy earlier = restoredStudyIn(resultsFolder());
  const base::Result<Experiment> of =
      earlier.experiment ? parseExperiment(*earlier.experiment, file_.toStdString())
                         : readExperiment(file_.toStdString());
  displayedExperiment_ = of && earlier.experiment ? std::optional(*of) : std::nullopt;
  total_ = earlier.runs;
  before_ = earlier.rows.size();
  folderProblem_ = earlier.trouble;
  findChangedInput(earlier);
  results_->begin(earlier.paths, of ? comparedPath(*of) : QString());
  results_->add(earlier.rows);
}

/// Large files would block the window.
void StudyPanel::findChangedInput(const RestoredStudy& of) {
  changedInput_.clear();
  hashing_.forget();  // that of other results
  if (!of.inputs.empty()) {
    hashing_.start([named = of.experimentPath, inputs = of.inputs, file = file_] {
      return changedInputOf(named, inputs, file);
    });
  }
}

/// Clears the results for a new study.
void StudyPanel::showResultsOf(const Experiment& experiment) {
  QStringList paths;
  for (const ExperimentValue& value : experiment.values) {
    paths.append(QString::fromStdString(value.path));
  }
  displayedExperiment_ = experiment;
  folderProblem_.clear();
  findChangedInput({});
  results_->begin(paths, comparedPath(experiment));
}

base::Result<Experiment> StudyPanel::experiment() const {
  const QString folder = file_.isEmpty() ? context_.folder() : QFileInfo(file_).absolutePath();
  const QString path =
      file_.isEmpty() ? QDir(folder).filePath(QStringLiteral("study.yaml")) : file_;
  return parseExperiment(form_->yamlFor(folder).toStdString(), path.toStdString());
}

/// Shows the size of the study or its problems, while nothing is running.
void StudyPanel::check() {
  if (isRunning() || output_) {
    return;
  }
  hideAnswers();
  runsSavedFile_ = false;
  const base::Result<Experiment> checked = experiment();
  const bool hasScenarios = !form_->scenarios().isEmpty();
  start_->setEnabled(bool(checked));
  if (!hasScenarios) {
    showMessage(editor::capitalized(folderProblem_), !folderProblem_.isEmpty());
    return;
  }
  if (!checked) {
    showMessage(QString::fromStdString(checked.diagnostics().front().message), true);
    return;
  }
  showMessage(messagesFor(checked).join(QStringLiteral(". ")), !folderProblem_.isEmpty());
  updateControls();
}

/// Whether the study would run the file of the open scenario without its unsaved changes.
bool StudyPanel::hasUnsavedScenario() const {
  return context_.document.isDirty() && form_->scenarios().contains(context_.document.path());
}

/// The text for a valid experiment: its size and further information.
QStringList StudyPanel::messagesFor(const base::Result<Experiment>& checked) const {
  QStringList words = {sizeText(*checked)};
  if (hasUnsavedScenario()) {
    words.append(tr("Save %1 before the start: it has unsaved changes")
                     .arg(context_.document.displayName()));
  }
  if (!checked.diagnostics().empty()) {
    words.append(diagnosticText(checked.diagnostics().front()));
  }
  const std::size_t finished = results_->runs().rows().size();
  if (!folderProblem_.isEmpty()) {
    words.append(folderProblem_);  // begins with the name of a file
  } else if (finished > 0 && !isEdited_) {
    words.append(tr("%1 of %2 finished").arg(finished).arg(total_));
    if (!changedInput_.isEmpty()) {
      words.append(tr("%1 has changed since the study ran").arg(changedInput_));
    }
  }
  return words;
}

/// Saves the file. An unchanged file is not rewritten, which keeps its comments.
bool StudyPanel::save() {
  if (!isEdited_) {
    return true;
  }
  const QByteArray text = form_->yamlFor(QFileInfo(file_).absolutePath()).toUtf8();
  QSaveFile file(file_);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
    showMessage(tr("%1 cannot be written: %2").arg(file_, file.errorString()), true);
    return false;
  }
  written_ = form_->yamlFor(QFileInfo(file_).absolutePath());
  isEdited_ = false;
  return true;
}

editor::PanelRegistry windowPanels() {
  editor::PanelRegistry panels = editor::standardPanels();
  panels.add({90, QObject::tr("Study"), Qt::BottomDockWidgetArea, true, kRoom, false},
             [](editor::PanelContext& context) { return new StudyPanel(context); });
  return panels;
}

}  // namespace app
