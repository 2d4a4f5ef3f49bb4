#pragma once

#include <memory>

#include <QMenu>
#include <QObject>
#include <QSettings>

#include "app/RunOptions.h"
#include "app/window/Workspace.h"
#include "editor/panels/IssuesPanel.h"

namespace app {

/// Recent files and what else is remembered between sessions. Without a store (pictures, tests)
/// nothing is read or written.
class Memory {
 public:
  explicit Memory(bool remembers);
  QStringList recentFiles() const;
  void noteFile(const QString& path);
  void clearRecent();
  QVariant value(const char* key) const;
  void setValue(const char* key, const QVariant& value);

 private:
  std::unique_ptr<QSettings> store_;
};

/// Opening and saving, with the questions that belong to them. Problems go to the issues panel.
class FileCommands : public QObject {
  Q_OBJECT
 public:
  FileCommands(Workspace& workspace, editor::IssuesPanel& issues, Memory& memory, QWidget& window);

  void setOptions(const RunOptions& options) { options_ = options; }
  /// A scenario, or a map for a new one. False: it could not be read, the issues say why.
  bool openFile(const QString& path);
  bool openNewFromMap(const QString& mapYaml);
  void newRoom();
  bool saveTo(const QString& path);
  void fillRecentMenu(QMenu& menu);
  const base::Diagnostics& problems() const { return problems_; }  // of the last command

  // with dialogs
  void askOpen();
  void askNewFromMap();
  void askOtherMap();
  bool save();  // asks for a name when there is none; false when cancelled or failed
  bool saveAs();
  /// Unsaved changes: save, discard or stay. True when the document may be replaced.
  bool mayLeave();

 Q_SIGNALS:
  void opened();  // a document is there to be edited
  void recentChanged();
  void issuesRaised();

 private:
  bool tell(const base::Diagnostics& problems);
  base::Diagnostics applyRunOptions();
  QString folder() const;
  bool isMap(const QString& path) const;

  Workspace& workspace_;
  editor::IssuesPanel& issues_;
  Memory& memory_;
  QWidget& window_;
  RunOptions options_;
  base::Diagnostics problems_;
};

}  // namespace app
