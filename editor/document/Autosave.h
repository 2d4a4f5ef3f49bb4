#pragma once

#include <map>
#include <memory>
#include <string>

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include "editor/document/LatestTask.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"

namespace editor {

/// A document as a value: what an emergency copy holds. May be made in the GUI thread and written
/// in another one.
struct DocumentSnapshot {
  sim2d::Scenario scenario;
  std::map<EntityId, std::string> trees;  // own ones of people
  MapState map;
  bool mapIsInFile = true;  // the cells are those of `map.path`, which is all that is kept then
  QString path;             // of the scenario file; empty: none yet
  bool readOnly = false;
  QDateTime when;
};

/// The files of a snapshot in a folder: scenario.yaml, tree_<number>.xml, map.yaml, map.pgm and
/// recovery.json.
std::vector<base::FileContent> snapshotFiles(const DocumentSnapshot& snapshot,
                                             const QString& folder);
base::Result<DocumentSnapshot> readSnapshot(const QString& folder);

/// Keeps a copy of unsaved work in a folder of its own, for the next start after a crash: written
/// beside the GUI thread at most `kAutosaveMs` after an edit, removed when the work is saved or the
/// program ends in order.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int kAutosaveMs = 3000;

  /// `root` holds one folder per running program.
  Autosave(ScenarioDocument& document, QString root, QObject* parent = nullptr);
  ~Autosave() override;
  Q_DISABLE_COPY_MOVE(Autosave)

  QString folder() const { return folder_; }  // of the copy; empty: none was needed yet
  void writeNow();                            // and waits for it

  /// Folders of copies whose program has died.
  static QStringList leftBehind(const QString& root);

 Q_SIGNALS:
  void failed(const base::Diagnostics& problems);

 private:
  void noteEdit();
  void write();
  bool makeFolder();
  void removeCopy();

  ScenarioDocument& document_;
  QString root_, folder_;
  std::unique_ptr<QLockFile> lock_;  // as long as it is held, this program lives
  QTimer timer_;
  std::unique_ptr<LatestTask<base::Diagnostics>> task_;
};

}  // namespace editor
