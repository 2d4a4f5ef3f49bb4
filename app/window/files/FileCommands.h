#pragma once

#include "app/run/Export.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunSpec.h"
#include "app/window/NoticeBar.h"
#include "app/window/Workspace.h"
#include "app/window/files/FileDialogs.h"
#include "app/window/files/OpenFiles.h"
#include "editor/document/Autosave.h"
#include "editor/panels/IssuesPanel.h"

namespace app {

class WindowActions;

/// Opens and saves files with the necessary dialogs. Problems are shown in the issues panel.
class FileCommands : public QObject {
  Q_OBJECT
 public:
  FileCommands(Workspace& workspace, editor::IssuesPanel& issues, UserSettings& userSettings,
               QWidget& window);

  /// Connects the commands of files with their functions.
  void connectActions(const WindowActions& actions);
  void setOptions(const RunSpec& options, const sim2d::Compatibility& compatibility) {
    options_ = options;
    compatibility_ = compatibility;
  }
  /// While a study is running, no other study is opened.
  void setStudyCheck(std::function<bool()> isRunning) { isStudyRunning_ = std::move(isRunning); }
  /// Opens a scenario, a map (for a new scenario), the folder of a recorded run, third-party
  /// trajectories, an experiment, the results of `batch`, `tune`, `gate`, `sensitivity` or
  /// `search`, or a tree for the selected people. False: the file could not be read completely; see
  /// the issues.
  bool openFile(const QString& path);
  /// Opens a packed study from a temporary folder, which lives as long as the window.
  bool openCapsule(const QString& path);
  /// Opens the folder of a recorded run. A temporary folder is not kept among the recent files.
  bool openRun(const QString& path, bool isTemporary = false);
  static bool isTracks(const QString& path);
  /// Opens a file dropped onto the entity `under`; none: onto the window.
  bool dropFile(const QString& path, editor::EntityId under);
  /// Reloads the document from disk.
  bool reload() { return openScenario(workspace_.document().path()); }
  bool restore(const QString& folder);  // restores the copy of a crashed session
  bool openNewFromMap(const QString& mapYaml);
  bool replaceMap(const QString& mapYaml);  // replaces the map of the open scenario
  void newOpenPlane();                      // creates an open plane
  void close();                             // closes the document without questions
  void newOnMap(std::shared_ptr<const sim2d::OccupancyGrid> map);
  bool saveTo(const QString& path, const editor::TreeReplacements& trees = {});
  void fillRecentMenu(QMenu& menu);
  Bundle exportSource() const;
  QString exportFolder() const;                                    // default of `askExport`
  bool exportPlan(const ExportPlan& plan);                         // writes the files
  const base::Diagnostics& problems() const { return problems_; }  // problems of the last command
  /// The warning about the last opened recorded run, if it is truncated.
  const std::optional<base::Diagnostic>& truncationOfRun() const { return truncationOfRun_; }

  // The following functions show dialogs.
  void askOpen();
  void askOpenRun();
  void askImportTracks();
  void askNewFromMap();
  void askNewEmptyRoom();
  void askReplaceMap();
  void askExport();
  bool save();  // asks for a name if there is none; false: cancelled or failed
  bool saveAs();
  QString suggestedPath() const;         // default of `saveAs`
  bool saveAsPath(const QString& path);  // as `saveAs` with this path; never overwrites a map
  bool isFileMissing() const;            // the file was moved or removed
  /// Asks about unsaved changes or a removed file: save, discard or cancel. True: the document may
  /// be replaced.
  bool maybeSave();
  /// The initial folder of dialogs, which exists: that of the user's own files, else the folder for
  /// documents, else the home folder.
  QString folder() const;

 Q_SIGNALS:
  void runOpened(const QString& folder);  // a recorded run is displayed
  void opened();                          // a document or recorded run was opened
  /// An experiment with its results beside it, or results of another study (StudyPanel::openFile).
  void studyOpened(const QString& path);
  void closed();          // no document is open
  void optionsApplied();  // options of the command line changed the document
  void recentChanged();
  void message(const QString& text);  // for the status bar
  void issuesRaised();
  void exported(const QString& folder, int files);
  void notExported(const base::Diagnostics& problems);
  void notSaved(const QString& name, const base::Diagnostics& problems);  // nothing was written

 private:
  enum class Kind {
    Scenario,
    Map,
    Image,
    Tree,
    Run,
    Tracks,
    Capsule,
    Batch,
    StudyResults,
    Experiment,
    Nav2
  };
  using GridPtr = std::shared_ptr<const sim2d::OccupancyGrid>;
  bool showProblems(const base::Diagnostics& problems);
  base::Diagnostics applyRunOptions();
  void openIfWanted(const QString& path);  // empty: cancelled
  /// Asks about unsaved changes if the file would replace the document.
  bool mayOpen(const QString& path);
  QString ask(QFileDialog::FileMode mode, const QString& title, const QString& filter = {});
  QString askMapFile(const QString& title);
  bool openNewFromImage(const QString& path);
  GridPtr askScaleOf(const QString& path);  // null: cancelled, or not an image
  Kind kindOf(const QString& path) const;
  bool openScenario(const QString& path, bool isTemporary = false);
  bool openTracks(const QString& path);
  bool openStudyResults(const QString& path);
  bool openExperiment(const QString& file, const QString& shown);
  bool refuseStudy(const QString& path);  // false
  void showRun(const RecordedRun& run, const QString& path, const QString& name,
               std::function<editor::RunRequest()> again);
  void remember(const QString& run);  // among the recent files
  std::function<editor::RunRequest()> replayRequestOf(const QString& folder) const;
  void closeRun();
  bool assignTree(const QString& path, editor::EntityId under);
  bool confirmOverwrite();
  bool isMap(const QString& path) const;
  bool saveAsking(const QString& path);

  Workspace& workspace_;
  editor::IssuesPanel& issues_;
  UserSettings& userSettings_;
  QWidget& window_;
  RunSpec options_;
  sim2d::Compatibility compatibility_;
  std::function<bool()> isStudyRunning_ = [] { return false; };
  base::Diagnostics problems_;
  std::optional<base::Diagnostic> truncationOfRun_;
  QString previousDocument_, scenarioOfRun_;  // files; while a recorded run is displayed
  std::vector<std::unique_ptr<QTemporaryDir>> unpacked_;  // folders of packed studies
  bool isMapRejected_ = false;  // their issues are cleared by the next map
};

/// Protects unsaved work and reports file problems as notices: copies for crash recovery, changes
/// of files by other programs, files that could be read only partly or not be written, missing
/// maps.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  /// `recoveryFolder` empty: no copies are kept. `openFilesFolder`: shared by all windows; empty:
  /// other windows are not found.
  DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                const QString& recoveryFolder, const QString& openFilesFolder,
                QObject* parent = nullptr);
  editor::Autosave* autosave() const { return autosave_.get(); }
  void checkFiles();  // checks the files on disk
  /// Keeps unsaved work for the next session when the session is ended from outside.
  void endSession();
  void reportUnreadable(
      const base::Diagnostics& problems);  // reports a file that could not be opened

 Q_SIGNALS:
  void scenarioFileChanged();  // the scenario file was removed or restored

 private:
  void watchFiles();
  void offerRecovery();
  void offerCopy(const QString& folder);
  void restore(const QString& folder);
  void reportChanged(const QStringList& changed);
  void reportRemoved();
  void reportReadOnly();
  void reportOpenElsewhere();
  void reportMapProblem();
  void reportExported(const QString& folder, int files);
  void reportNotSaved(const QString& name, const base::Diagnostics& problems);

  Workspace& workspace_;
  editor::ScenarioDocument& document_;
  FileCommands& files_;
  NoticeBar& notices_;
  QString recoveryFolder_;
  OpenFiles openFiles_;
  QFileSystemWatcher watcher_;
  QTimer pause_;         // waits for a program that writes several files
  bool isThere_ = true;  // whether the scenario file exists
  std::unique_ptr<editor::Autosave> autosave_;
  bool isStart_ = true;  // no document has been opened, or it was closed
  QStringList offered_;  // folders of copies with a notice
};

}  // namespace app
