#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QObject>

#include "app/run/Experiment.h"
#include "app/run/PlannerFiles.h"
#include "app/window/Workspace.h"

namespace app {

class NoticeBar;
class StudyPanel;

/// Asks for confirmation in a notice before a run starts programs or libraries named in the
/// scenario. If allowed, the run starts as requested. The workspace stores the answer.
class ExternalCodePrompt : public QObject {
  Q_OBJECT
 public:
  ExternalCodePrompt(Workspace& workspace, NoticeBar& notices, QObject* parent = nullptr);
  static QString noticeId() { return QStringLiteral("code"); }
  /// The same for the runs of a study; the panel stores the answer.
  static void attachTo(StudyPanel& study, NoticeBar& notices);
  static QString studyNoticeId() { return QStringLiteral("study-code"); }

 private:
  void showPrompt(bool paused);

  Workspace& workspace_;
  NoticeBar& notices_;
};

/// The external code that runs of the experiment would start: that of the first values, and of each
/// other value varied alone, as reported by `batch`. Nothing is started.
std::vector<ExternalCode> externalCodeOfStudy(const Experiment& experiment);

/// The external code that the user has allowed for one experiment file.
class StudyCodePermissions {
 public:
  /// Whether all of the code is allowed.
  bool allows(const std::vector<ExternalCode>& code) const;
  /// Sets the continuation after the user allows the code; replaces an earlier one.
  void onAllowed(std::function<void()> then) { then_ = std::move(then); }
  void allow(const std::vector<ExternalCode>& code);
  void reset();  // call for another file

 private:
  std::vector<ExternalCode> allowed_;
  std::function<void()> then_;
};

}  // namespace app
