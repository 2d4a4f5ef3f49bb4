#pragma once

#include <QAction>

#include "app/window/NoticeBar.h"
#include "app/window/Workspace.h"

namespace app {

/// Whether runs that begin from now on are told to others while they go on: in Foxglove's live
/// view, on topics of ROS 2. Each start of the program begins with neither.
class RunSharing : public QObject {
  Q_OBJECT
 public:
  static constexpr int kUsualPort = 8765;  // Foxglove's

  RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
             QObject* parent);

 private:
  void choose();
  void tellWatched(const QString& url);
  void tellWarning(const base::Diagnostics& said);
  void followRun();
  bool isLive() const;

  Workspace& workspace_;
  QAction& foxglove_;
  QAction& ros2_;
  NoticeBar& notices_;
  int branch_ = -1;  // of the run that goes on
};

}  // namespace app
