#pragma once

#include <memory>

#include <QtWidgets>

namespace app {

/// Which files the running windows of this user have open. Each window keeps a lock for its file in
/// a shared folder; a lock whose process has ended does not count. GUI thread.
class OpenFiles : public QObject {
  Q_OBJECT
 public:
  /// `folder` empty: nothing is shared, and no other window is found.
  OpenFiles(QString folder, QObject* parent);
  ~OpenFiles() override;
  Q_DISABLE_COPY_MOVE(OpenFiles)

  /// Makes this the file of this window; empty: none.
  void setFile(const QString& path);
  /// Whether another window has the file open.
  bool isOpenElsewhere() const;

 Q_SIGNALS:
  void changed();  // another window opened or closed a file

 private:
  QString folder_;
  QString key_;      // the same for all names of one file
  QString ownFile_;  // of the lock
  std::unique_ptr<QLockFile> lock_;
  QFileSystemWatcher watcher_;
};

}  // namespace app
