#pragma once

#include "app/run/Experiment.h"
#include "app/run/PlannerFiles.h"
#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyProcess.h"
#include "app/window/study/StudyResults.h"
#include "editor/document/LatestTask.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// A form for an experiment: scenarios, planners, values and seeds. GUI thread.
class StudyForm : public QWidget {
  Q_OBJECT
 public:
  explicit StudyForm(editor::PanelContext& context);

  /// The experiment as YAML; scenarios below `folder` have relative paths.
  QString yamlFor(const QString& folder) const;
  void show(const Experiment& experiment);
  void addScenario(const QString& path);  // ignored if present
  /// Selects the open scenario and the planner of its robot, until the user or a file has selected
  /// other scenarios.
  void presetOpenScenario();
  /// Uses the second file instead of the first, for example after it was saved under a new name.
  void replaceScenario(const QString& path, const QString& by);
  void reset();                   // to the initial values
  QStringList scenarios() const;  // absolute paths, or names of shipped scenarios
  void setEditable(bool editable);

 Q_SIGNALS:
  void changed();
  void resultsDropped(const QString& path);  // of another study, see StudyPanel::openFile()

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeScenarios();
  QWidget* makePlanners();
  QLayout* makeNumbers();
  void styleValues();
  void addItem(const QString& path);
  void showScenarios();
  void askScenarios();
  QString plannerPath() const;
  void addPlanner(const QString& name, const QString& help);
  QStringList chosenPlanners() const;
  void showPlanners(const QStringList& chosen);

  editor::PanelContext& context_;
  QListWidget* scenarios_ = new QListWidget(this);
  QStackedWidget* scenarioRoom_ = new QStackedWidget(this);
  QLabel* emptyLabel_ = new QLabel(tr("No scenarios: add or drop files here"), this);
  QListWidget* planners_;
  QLineEdit* seeds_ = new QLineEdit(this);
  QLineEdit* duration_ = new QLineEdit(this);
  QComboBox* record_ = new editor::ChoiceField(this);
  QPlainTextEdit* values_ = new QPlainTextEdit(this);
  QAbstractButton* addThis_ = nullptr;
  QString plannerPath_;       // planner path in the opened file
  QStringList plannerOrder_;  // planners in file order
  QStringList others_;        // lines of the file without a field
  QStringList presetPlanners_;
  bool isPreset_ = true;  // the scenarios are those of presetOpenScenario()
  bool isLoading_ = false;
};

/// The panel for studies: edits, starts, stops and resumes an experiment, shows results as they
/// arrive, plays runs and opens the report. It also shows the results of `tune`, `gate`,
/// `sensitivity` and `search` and plays their runs. GUI thread.
class StudyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StudyPanel(editor::PanelContext& context);
  ~StudyPanel() override;
  Q_DISABLE_COPY_MOVE(StudyPanel)

  /// Opens an experiment with its existing results, the output folder of `batch`, or that of
  /// `tune`, `gate`, `sensitivity` or `search` (or its JSON file); shows problems. Also false while
  /// a study is running.
  bool openFile(const QString& path);
  /// Sets the experiment file. `results`: the folder for its results; empty: beside the file.
  void setFile(const QString& path, const QString& results = {});
  QString file() const { return file_; }
  QString resultsFolder() const;
  /// The name of the experiment or of the folder with results.
  QString shownName() const;
  /// The page with the results of another command; null: an experiment is shown.
  OutputPage* outputPage() const { return page_; }
  StudyForm& form() const { return *form_; }
  StudyProcess& process() { return process_; }
  /// Starts the study. If results of another experiment exist, this is shown first; if external
  /// code is not allowed, the user is asked first.
  void start(StudyProcess::Begin begin = StudyProcess::Begin::Resume);
  void allowCode(const std::vector<ExternalCode>& code);  // and continues
  void stop();
  bool isRunning() const { return process_.isRunning(); }
  void play(int run);
  void playOutput(const OutputRun& run);  // repeats the run and plays it
  void openReport();
  QString message() const { return messageLabel_->text(); }
  const StudyResults& results() const { return *results_; }

 protected:
  void showEvent(QShowEvent* event) override;

 Q_SIGNALS:
  /// Requests playback. A temporary folder is not among the recent files.
  void openRunRequested(const QString& folder, bool isTemporary);
  void saveRequested();  // requests saving the open scenario
  /// Asks the user to allow external code; call allowCode() on consent. Empty: the question is
  /// obsolete.
  void codePermissionNeeded(const std::vector<app::ExternalCode>& code);

 private:
  void connectSignals();
  void presetForm();
  QWidget* makeHead();
  QWidget* makeState();
  void askFile(bool toSave);
  void chooseFile();
  void checkSoon() { check_.start(); }
  void check();
  QStringList messagesFor(const base::Result<Experiment>& checked) const;
  base::Result<Experiment> experiment() const;
  void showRestored();
  void findChangedInput(const RestoredStudy& of);
  void showResultsOf(const Experiment& experiment);
  bool openOutput(const std::string& file);
  void showOutputPage();
  void closeOutput();
  void showSummary();
  bool canUseFolder(StudyProcess::Begin begin);
  bool isCodeAllowed(const std::vector<ExternalCode>& code, const std::function<void()>& then);
  bool save();
  void beginNew();
  void hideAnswers();
  bool hasUnsavedScenario() const;
  void askToSave(StudyProcess::Begin begin);
  void startSaved();    // after saving the open scenario
  void startAsSaved();  // without its unsaved changes
  void showProgress();
  void finish(bool isComplete, const QString& problems);
  /// `workingFolder` empty: that of this program.
  void runProgram(const QStringList& words, const QString& saying,
                  const std::function<void()>& then, const QString& workingFolder = {});
  void showMessage(const QString& text, bool isProblem = false);
  void updateControls();

  void updateMessageColor();
  bool hasResults() const;

  editor::PanelContext& context_;
  QString file_;
  QString resultsFolder_;  // empty: beside the file
  bool isEdited_ = false;  // the fields differ from the file
  QString written_;        // text of the fields equal to the file; null: none
  QString folderProblem_;  // problem with the results folder
  std::optional<Experiment> runningExperiment_,
      displayedExperiment_;                // experiment running; experiment displayed
  std::vector<ExternalCode> allowedCode_;  // by the user, for this file
  std::function<void()> whenAllowed_;      // continues after the user allows the code
  struct Output {
    QString folder;
    report::StudyOutput results;
  };
  std::optional<Output> output_;  // shown instead of an experiment
  OutputPage* page_ = nullptr;    // of output_
  StudyForm* form_;
  QScrollArea* formArea_ = nullptr;
  QStackedWidget* content_ = new QStackedWidget(this);
  StudyResults* results_ = new StudyResults(this);
  StudyProcess process_;
  QProcess helperProcess_;  // re-runs a run, writes a report
  std::unique_ptr<QTemporaryDir> played_;
  std::size_t total_ = 0, before_ = 0;  // number of runs; finished before the start
  QElapsedTimer since_;
  QTimer check_;
  editor::ElidedLabel* name_ = new editor::ElidedLabel(this);
  QString changedInput_;  // An input file that has changed since the displayed runs; empty: none.
  editor::LatestTask<QString> hashing_;  // Finds it.
  QLabel* messageLabel_ = new QLabel(this);
  bool isMessageProblem_ = false;
  QProgressBar* progress_ = new QProgressBar(this);
  QPushButton* start_ = new QPushButton(this);
  QPushButton* report_ = new QPushButton(tr("Report"), this);
  QAbstractButton* new_ = nullptr;
  QAbstractButton* open_ = nullptr;
  QAbstractButton* saveAs_ = nullptr;
  QAbstractButton* restartButton_ =
      editor::linkButton(tr("Restart"), tr("Delete the results in the folder"), this,
                         [this] { start(StudyProcess::Begin::Restart); });
  QAbstractButton* saveButton_ =
      editor::linkButton(tr("Save and start"), tr("Save the open scenario, then start"), this,
                         [this] { startSaved(); });
  QAbstractButton* asSavedButton_ =
      editor::linkButton(tr("Start without them"), tr("Run the file as it was last saved"), this,
                         [this] { startAsSaved(); });
  StudyProcess::Begin begin_ = StudyProcess::Begin::Resume;  // of the start that asked to save
  bool runsSavedFile_ = false;  // the user accepted that unsaved changes are not used
};

/// The panels of the editor and the study panel.
editor::PanelRegistry windowPanels();

}  // namespace app
