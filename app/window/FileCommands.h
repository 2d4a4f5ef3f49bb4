#pragma once

#include <memory>
#include <optional>

#include <QFileDialog>
#include <QMenu>
#include <QObject>

#include "app/run/Export.h"
#include "app/run/RunOptions.h"
#include "app/window/FileDialogs.h"
#include "app/window/Workspace.h"
#include "editor/panels/IssuesPanel.h"

namespace app {

/// Opening and saving, with the questions that belong to them. Problems go to the issues panel.
class FileCommands : public QObject {
  Q_OBJECT
 public:
  FileCommands(Workspace& workspace, editor::IssuesPanel& issues, Memory& memory, QWidget& window);

  void setOptions(const RunOptions& options, const sim2d::Compatibility& compatibility) {
    options_ = options;
    compatibility_ = compatibility;
  }
  /// A scenario, a map for a new one, the folder of a recorded run, or a tree for the people that
  /// are selected. False: it could not be read, or only in part; the issues say why.
  bool openFile(const QString& path);
  static bool isImage(const QString& path);  // by its name; opening it asks for its scale
  /// The same for a file that was dropped onto `under` (nothing = beside everything).
  bool dropFile(const QString& path, editor::EntityId under);
  /// The file of the document, as it is on the disk now.
  bool reload() { return openScenario(workspace_.document().path()); }
  bool restore(const QString& folder);  // a copy of an earlier session that has crashed
  bool openNewFromMap(const QString& mapYaml);
  bool putOtherMap(const QString& mapYaml);  // under the scenario that is open
  void newRoom();                            // an open plane
  void newOnMap(std::shared_ptr<const sim2d::OccupancyGrid> map);
  bool saveTo(const QString& path, const editor::TreesToReplace& trees = {});
  void fillRecentMenu(QMenu& menu);
  Bundle exportSource() const;
  QString exportFolder() const;                                    // what `askExport` proposes
  bool exportPlan(const ExportPlan& plan);                         // writes it
  const base::Diagnostics& problems() const { return problems_; }  // of the last command
  /// What is said of the recorded run that was opened last, if it is cut.
  const std::optional<base::Diagnostic>& cutOfRun() const { return cutOfRun_; }

  // with dialogs
  void askOpen();
  void askOpenRun();
  void askNewFromMap();
  void askNewRoom();
  void askMapOfImage(const QString& path);
  void askOtherMap();
  void askExport();
  bool save();  // asks for a name when there is none; false when cancelled or failed
  bool saveAs();
  QString nameForSaving() const;        // what `saveAs` proposes
  bool saveUnder(const QString& path);  // what it does with the answer; never over a map
  bool isLost() const;  // another program has moved or removed the file of the document
  /// Unsaved changes or a lost file: save, discard or stay. True when the document may be replaced.
  bool mayLeave();
  /// Where dialogs begin: with the user's own files.
  QString folder() const;

 Q_SIGNALS:
  void runOpened(const QString& folder);  // a recorded run is shown
  void opened();  // a document is there to be edited, or a recorded run to be seen
  void closed();  // nothing is there any more
  void recentChanged();
  void issuesRaised();
  void exported(const QString& folder, int files);
  void notExported(const base::Diagnostics& problems);
  void notSaved(const QString& name, const base::Diagnostics& problems);  // nothing was written

 private:
  enum class Kind { Scenario, Map, Image, Tree, Run };
  bool tell(const base::Diagnostics& problems);
  base::Diagnostics applyRunOptions();
  void openIfWanted(const QString& path);  // empty: nothing was chosen
  QString ask(QFileDialog::FileMode mode, const QString& title, const QString& filter = {});
  Kind kindOf(const QString& path) const;
  bool openScenario(const QString& path);
  bool openRun(const QString& path);
  std::function<editor::RunRequest()> againOf(const QString& folder) const;
  void leaveRun();
  bool giveTree(const QString& path, editor::EntityId under);
  bool mayWriteOver();
  bool isMap(const QString& path) const;
  bool saveAsking(const QString& path);

  Workspace& workspace_;
  editor::IssuesPanel& issues_;
  Memory& memory_;
  QWidget& window_;
  RunOptions options_;
  sim2d::Compatibility compatibility_;
  base::Diagnostics problems_;
  std::optional<base::Diagnostic> cutOfRun_;
  QString beforeRun_, scenarioOfRun_;  // files; a recorded run is shown
  bool mapRefused_ = false;            // what they say ends with the next map
};

}  // namespace app
