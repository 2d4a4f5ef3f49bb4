#pragma once

#include <memory>
#include <optional>

#include <QtWidgets>

#include "app/window/study/ExternalCodePrompt.h"
#include "app/window/study/StudyForm.h"
#include "app/window/study/StudyProcess.h"
#include "app/window/study/StudyResults.h"
#include "editor/look/Form.h"

namespace app {

/// The panel for studies: edits, starts, stops and resumes an experiment, shows results as they
/// arrive, plays runs and opens the report. GUI thread.
class StudyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StudyPanel(editor::PanelContext& context);
  ~StudyPanel() override;
  Q_DISABLE_COPY_MOVE(StudyPanel)

  /// Opens an experiment with its existing results; shows problems. Also false while a study is
  /// running.
  bool openFile(const QString& path);
  /// Sets the experiment file, which determines the results folder.
  void setFile(const QString& path);
  QString file() const { return file_; }
  QString resultsFolder() const;
  StudyForm& form() const { return *form_; }
  StudyProcess& process() { return process_; }
  /// Starts the study. If results of another experiment exist or external code is not allowed, it
  /// shows or asks this first.
  void start(StudyProcess::Begin begin = StudyProcess::Begin::Resume);
  void allowCode(const std::vector<ExternalCode>& code) { code_.allow(code); }  // and continues
  void stop();
  bool isRunning() const { return process_.isRunning(); }
  void play(int run);
  void openReport();
  QString message() const { return messageLabel_->text(); }
  const StudyResults& results() const { return *results_; }

 Q_SIGNALS:
  void openRunRequested(const QString& folder);  // requests playback
  void counted(int finished);
  /// Asks the user to allow external code; call allowCode() on consent. Empty: the question is
  /// obsolete.
  void codePermissionNeeded(const std::vector<app::ExternalCode>& code);

 private:
  void connectSignals();
  QWidget* makeHead();
  QWidget* makeState();
  void askFile(bool toSave);
  void checkSoon() { check_.start(); }
  void check();
  QStringList messagesFor(const base::Result<Experiment>& checked) const;
  base::Result<Experiment> experiment() const;
  void showRestored();
  void showResultsOf(const Experiment& experiment);
  bool canUseFolder(StudyProcess::Begin begin);
  bool isCodeAllowed(const std::vector<ExternalCode>& code, const std::function<void()>& then);
  bool save();
  void showProgress();
  void finish(bool isComplete, const QString& problems);
  void runProgram(const QStringList& words, const QString& saying,
                  const std::function<void()>& then);
  void showMessage(const QString& text, bool isProblem = false);
  void updateControls();

  void updateMessageColor();

  editor::PanelContext& context_;
  QString file_;
  bool isEdited_ = false;  // the fields differ from the file
  QString written_;        // text of the fields equal to the file; null: none
  QString folderProblem_;  // problem with the results folder
  std::optional<Experiment> runningExperiment_,
      displayedExperiment_;  // experiment running; experiment displayed
  StudyCodePermissions code_;
  StudyForm* form_;
  StudyResults* results_;
  StudyProcess process_;
  QProcess helperProcess_;  // re-runs a run, writes a report
  std::unique_ptr<QTemporaryDir> played_;
  std::size_t total_ = 0, before_ = 0;  // number of runs; finished before the start
  QElapsedTimer since_;
  QTimer check_;
  editor::ElidedLabel* name_;
  QLabel* messageLabel_;
  bool isMessageProblem_ = false;
  QProgressBar* progress_;
  QPushButton* start_;
  QPushButton* report_;
  QAbstractButton* open_ = nullptr;
  QAbstractButton* saveAs_ = nullptr;
  QAbstractButton* restartButton_;
};

/// The panels of the editor and the study panel.
editor::PanelRegistry windowPanels();

}  // namespace app
