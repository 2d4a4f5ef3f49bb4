#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include "app/window/StudyCode.h"
#include "app/window/StudyForm.h"
#include "app/window/StudyProcess.h"
#include "app/window/StudyResults.h"
#include "editor/look/Form.h"

namespace app {

/// Many runs beside the window: an experiment is edited, started, watched while its results come,
/// stopped and gone on with; runs are played, the report is opened. GUI thread.
class StudyPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StudyPanel(editor::PanelContext& context);
  ~StudyPanel() override;
  Q_DISABLE_COPY_MOVE(StudyPanel)

  /// An experiment, with the results that it has already; problems are shown. False as well while a
  /// study runs.
  bool openFile(const QString& path);
  /// Where it is saved, and where its results go.
  void setFile(const QString& path);
  QString file() const { return file_; }
  QString resultsFolder() const;
  StudyForm& form() const { return *form_; }
  StudyProcess& process() { return process_; }
  /// Nothing is written or run while results of another experiment are in the way, or code of
  /// others is not allowed: that is said, or asked.
  void start(StudyProcess::Begin begin = StudyProcess::Begin::GoOn);
  void allowCode(const std::vector<ForeignCode>& code) { code_.allow(code); }  // and goes on
  void stop();
  bool isRunning() const { return process_.isRunning(); }
  void play(int run);
  void openReport();
  QString said() const { return says_->text(); }
  const StudyResults& results() const { return *results_; }

 Q_SIGNALS:
  void runWanted(const QString& folder);  // is to be played
  void counted(int finished);
  /// Runs would start it: somebody is to be asked, allowCode() is a yes. Empty: not any more.
  void codeWanted(const std::vector<app::ForeignCode>& code);

 private:
  void listen();
  QWidget* makeHead();
  QWidget* makeState();
  void askFile(bool toSave);
  void checkSoon() { check_.start(); }
  void check();
  QStringList wordsOn(const base::Result<Experiment>& checked) const;
  base::Result<Experiment> experiment() const;
  void showEarlier();
  void showResultsOf(const Experiment& experiment);
  bool mayWrite(StudyProcess::Begin begin);
  bool mayRun(const std::vector<ForeignCode>& code, const std::function<void()>& then);
  bool save();
  void showProgress();
  void finish(bool isComplete, const QString& problems);
  void runProgram(const QStringList& words, const QString& saying,
                  const std::function<void()>& then);
  void say(const QString& text, bool isProblem = false);
  void follow();

  void paintWords();

  editor::PanelContext& context_;
  QString file_;
  bool isEdited_ = false;  // the fields say something else than the file
  QString written_;        // what the fields say where they say the same; null: never
  QString trouble_;        // of the results in its folder
  std::optional<Experiment> begun_, shown_;  // by the process; whose rows are shown
  StudyCode code_;
  StudyForm* form_;
  StudyResults* results_;
  StudyProcess process_;
  QProcess helper_;  // a run to be played, a report
  std::unique_ptr<QTemporaryDir> played_;
  std::size_t total_ = 0, before_ = 0;  // runs; those that were there when it began
  QElapsedTimer since_;
  QTimer check_;
  editor::ElidedLabel* name_;
  QLabel* says_;
  bool saysProblem_ = false;
  QProgressBar* progress_;
  QPushButton* start_;
  QPushButton* report_;
  QAbstractButton* open_ = nullptr;
  QAbstractButton* saveAs_ = nullptr;
  QAbstractButton* anew_;
};

/// Those of the editor, and this one.
editor::PanelRegistry windowPanels();

}  // namespace app
