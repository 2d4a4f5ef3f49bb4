#pragma once

#include <QObject>

#include "app/window/Workspace.h"

namespace app {

class NoticeBar;

/// Asks, in a notice, before a run starts programs or libraries that the scenario names; when they
/// are allowed, the run goes on as it was wanted. The workspace keeps the answer.
class CodeQuestion : public QObject {
  Q_OBJECT
 public:
  CodeQuestion(Workspace& workspace, NoticeBar& notices, QObject* parent = nullptr);
  static QString noticeId() { return QStringLiteral("code"); }

 private:
  void ask(bool paused);

  Workspace& workspace_;
  NoticeBar& notices_;
};

}  // namespace app
