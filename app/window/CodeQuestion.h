#pragma once

#include <QObject>

#include "app/window/Workspace.h"

namespace app {

class NoticeBar;
class StudyPanel;

/// Asks, in a notice, before a run starts programs or libraries that the scenario names; when they
/// are allowed, the run goes on as it was wanted. The workspace keeps the answer.
class CodeQuestion : public QObject {
  Q_OBJECT
 public:
  CodeQuestion(Workspace& workspace, NoticeBar& notices, QObject* parent = nullptr);
  static QString noticeId() { return QStringLiteral("code"); }
  /// The same for the runs of a study; the panel keeps the answer.
  static void askFor(StudyPanel& study, NoticeBar& notices);
  static QString studyNoticeId() { return QStringLiteral("study-code"); }

 private:
  void ask(bool paused);

  Workspace& workspace_;
  NoticeBar& notices_;
};

}  // namespace app
