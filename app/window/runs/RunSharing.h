#pragma once

#include <QAction>

#include "app/window/NoticeBar.h"
#include "app/window/Workspace.h"

namespace app {

/// Publishes runs started afterwards to Foxglove's live view and on ROS 2 topics. Both are off when
/// the program starts.
class RunSharing : public QObject {
  Q_OBJECT
 public:
  static constexpr int kUsualPort = 8765;  // Foxglove's default

  RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
             QObject* parent);

 private:
  void choose();
  void reportUrl(const QString& url);
  void reportWarning(const base::Diagnostics& diagnostics);
  void updateNotices();
  bool isLive() const;

  Workspace& workspace_;
  QAction& foxglove_;
  QAction& ros2_;
  NoticeBar& notices_;
  int branch_ = -1;  // branch of the current run
};

}  // namespace app
