#pragma once

#include "app/run/PlannerFiles.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/MapView.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/runs/BranchDialog.h"
#include "editor/panels/runs/Playback.h"
#include "editor/panels/runs/RunInteraction.h"
#include "editor/panels/runs/ScrubActions.h"
#include "editor/run/SimulationRunner.h"
#include "editor/tools/ToolManager.h"

namespace app {

/// The document with its canvas, tools and run. The parts of the window have a reference to it; it
/// does not depend on the window.
class Workspace : public QObject {
  Q_OBJECT
 public:
  explicit Workspace(const editor::Theme& theme,
                     const editor::ToolRegistry& tools = editor::standardTools(),
                     QObject* parent = nullptr);
  ~Workspace() override;  // does not wait for map processing
  Q_DISABLE_COPY_MOVE(Workspace)

  editor::ScenarioDocument& document() { return document_; }
  editor::MapScene& scene() { return scene_; }
  editor::MapView& view() { return *view_; }
  editor::ToolManager& tools() { return tools_; }
  editor::SimulationRunner& runner() { return runner_; }
  editor::RunEvents& events() { return events_; }
  editor::MetricsFeed& feed() { return feed_; }
  editor::PlaybackActions& playback() { return playback_; }
  editor::ScrubActions& scrub() { return scrub_; }
  editor::ManualDriveController& drive() { return *drive_; }
  editor::PeopleInteraction& interaction() { return interaction_; }
  editor::BranchCommand& branching() { return branching_; }
  const editor::Theme& theme() const { return theme_; }
  void setTheme(const editor::Theme& theme);
  /// Shows a recorded run instead of the document; editing is disabled. `again`: as for the runner.
  void openRecorded(editor::RecordingPtr recording, const QString& name,
                    std::function<editor::RunRequest()> again = {});
  QString recordedName() const { return recordedName_; }
  /// Whether a recorded run or a branch of it is displayed.
  bool isRecordedRun() const { return !recordedName_.isEmpty(); }
  /// Settings for runs started afterwards.
  void setRunSettings(const editor::RunSettings& settings) { runSettings_ = settings; }
  /// External programs and libraries that a run would start and that are not allowed.
  std::vector<ExternalCode> unapprovedCode() const;
  /// Allows the code for this file until the workspace is destroyed.
  void allowCode(const std::vector<ExternalCode>& code);
  /// Allows all code of this file; empty: of any file.
  void allowAllCodeOf(const QString& file) { trustedFile_ = QFileInfo(file).canonicalFilePath(); }

 Q_SIGNALS:
  void themeChanged();
  void recordedRunClosed();                // by the user: restore the previous document
  void editReverted();                     // because a recorded run is displayed
  void codePermissionNeeded(bool paused);  // a run was not started: code not allowed

 private:
  void showState();
  void showFrame(const editor::FramePtr& frame);
  void interpolate();
  void showSpeech(int first, int last);
  void handleRunClosed();
  void revertEdits();
  void clearUnsavedPermissions();

  editor::Theme theme_;
  editor::RunSettings runSettings_;
  editor::ScenarioDocument document_;
  editor::MapScene scene_;
  editor::MapView* view_ = new editor::MapView(scene_);  // owned by its parent widget
  editor::ToolManager tools_;
  editor::SimulationRunner runner_;
  editor::RunEvents events_;
  editor::MetricsFeed feed_;
  editor::PlaybackActions playback_;
  editor::ScrubActions scrub_;
  editor::PeopleInteraction interaction_;
  editor::BranchCommand branching_;
  std::set<std::pair<QString, std::string>> allowedCode_;  // file (empty: unsaved), command
  std::optional<QString> trustedFile_;
  QString recordedName_;  // name of the displayed recorded run
  bool isReplaced_ = false;
  // Interpolation between two frames.
  QTimer interpolationTimer_;
  QElapsedTimer sinceFrame_;
  double period_ = 0.0;                                   // [s], wall clock time
  double shownTime_ = 0.0;                                // [s], time of the frame
  std::unique_ptr<editor::ManualDriveController> drive_;  // receives frames after the scene
};

}  // namespace app
