#pragma once

#include <QFileSystemWatcher>
#include <QTimer>

#include "editor/document/ScenarioDocument.h"

namespace app {

/// Notices when another program changes a file of the document; the program's own saving is none.
class FileWatch : public QObject {
  Q_OBJECT
 public:
  explicit FileWatch(editor::ScenarioDocument& document, QObject* parent = nullptr);
  void lookNow();

 Q_SIGNALS:
  void changedOnDisk(const QStringList& files);
  void scenarioThere(bool isThere);  // its file has gone, or is back

 private:
  void watch();

  editor::ScenarioDocument& document_;
  QFileSystemWatcher watcher_;
  bool isThere_ = true;
  QTimer pause_;  // until a program that writes several files is through
};

}  // namespace app
