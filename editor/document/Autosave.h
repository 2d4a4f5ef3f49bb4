#pragma once

#include "editor/document/LatestTask.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/base/Files.h"

namespace editor {

/// A copy of a document by value, as stored for crash recovery. It may be made in the GUI thread
/// and written in another thread.
struct DocumentSnapshot {
  sim2d::Scenario scenario;
  std::map<EntityId, std::string> trees;  // Custom trees of people.
  MapState map;
  bool mapIsInFile = true;  // The cells are those of `map.path`; only the path is stored then.
  QString path;             // Path of the scenario file; empty: not saved yet.
  bool readOnly = false;
  QDateTime when;
  bool isFromCrash = true;  // Otherwise the session was ended in order, such as at logout.
};

/// The files of a snapshot in a folder: scenario.yaml, tree_<number>.xml, map.yaml, map.pgm and
/// recovery.json.
std::vector<base::FileContent> snapshotFiles(const DocumentSnapshot& snapshot,
                                             const QString& folder);
base::Result<DocumentSnapshot> readSnapshot(const QString& folder);

/// Stores a copy of unsaved work in a separate folder for recovery after a crash. The copy is
/// written outside the GUI thread at most `setDelay` after an edit, and removed when the work is
/// saved or the user quits the program.
class Autosave : public QObject {
  Q_OBJECT
 public:
  static constexpr int kAutosaveMs = 3000;

  /// `root` contains one folder per running program.
  Autosave(ScenarioDocument& document, QString root, QObject* parent = nullptr);
  ~Autosave() override;
  Q_DISABLE_COPY_MOVE(Autosave)

  /// The longest time between an edit and its copy [ms]; none: no copies are written by edits.
  void setDelay(std::optional<int> milliseconds);
  QString folder() const { return folder_; }  // Folder of the copy; empty: not needed yet.
  void writeNow();                            // Blocks until the copy is written.
  /// Writes unsaved work for the next session, which is offered as work of an orderly end. Nothing
  /// is removed from then on. Returns false if there is no unsaved work or it cannot be written.
  bool keepForNextSession();

  /// Folders of copies whose process no longer exists.
  static QStringList orphanedFolders(const QString& root);

 Q_SIGNALS:
  void failed(const base::Diagnostics& problems);

 private:
  /// The timer is not restarted by each edit, so continuous editing is saved as well.
  void scheduleWrite() {
    if (isEnabled_ && !timer_.isActive()) {
      timer_.start();
    }
  }
  void write();
  bool makeFolder();
  void removeCopy();

  bool isKept_ = false;  // The copy is left for the next session.
  ScenarioDocument& document_;
  QString root_, folder_;
  std::unique_ptr<QLockFile> lock_;  // Held while this process is running.
  QTimer timer_;
  bool isEnabled_ = true;
  std::unique_ptr<LatestTask<base::Diagnostics>> task_;
};

}  // namespace editor
