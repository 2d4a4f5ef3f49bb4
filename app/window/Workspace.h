#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QFileInfo>
#include <QObject>
#include <QTimer>

#include "app/run/PlannerFiles.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/MapView.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/panels/HandDrive.h"
#include "editor/panels/MetricsFeed.h"
#include "editor/panels/PeopleHands.h"
#include "editor/panels/Playback.h"
#include "editor/panels/RunEvents.h"
#include "editor/panels/Scrubbing.h"
#include "editor/run/SimulationRunner.h"
#include "editor/tools/ToolManager.h"

namespace app {

/// What the window is about: one document, its canvas and tools, and the run of it. The parts of
/// the window get a reference; nothing here knows the window.
class Workspace : public QObject {
  Q_OBJECT
 public:
  explicit Workspace(const editor::Theme& theme,
                     const editor::ToolRegistry& tools = editor::standardTools(),
                     QObject* parent = nullptr);
  ~Workspace() override;  // does not wait for work on the map
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
  editor::HandDrive& drive() { return *drive_; }
  editor::PeopleHands& hands() { return hands_; }
  const editor::Theme& theme() const { return theme_; }
  void setTheme(const editor::Theme& theme);
  /// Shows a run that was recorded before instead of the document; nothing is edited meanwhile.
  /// `again`: as of the runner.
  void openRecorded(editor::RecordingPtr recording, const QString& name,
                    std::function<editor::RunRequest()> again = {});
  QString recordedName() const { return recordedName_; }
  /// That run is shown, or a branch of it.
  bool isOfRecord() const { return !recordedName_.isEmpty(); }
  /// Of the runs that begin from now on.
  void setRunSettings(const editor::RunSettings& settings) { runSettings_ = settings; }
  /// Programs and libraries of others that a run would start, and nobody has allowed.
  std::vector<ForeignCode> codeToAllow() const;
  /// In this file, for as long as the workspace lives.
  void allowCode(const std::vector<ForeignCode>& code);
  /// Whatever this file starts; empty: whatever any file does.
  void allowCodeOf(const QString& file) { freeFile_ = QFileInfo(file).canonicalFilePath(); }

 Q_SIGNALS:
  void themeChanged();
  void recordedRunLeft();        // by the user: the document before is wanted
  void editRefused();            // a recorded run is shown
  void codeWanted(bool paused);  // a run was not started: some of its code is not allowed

 private:
  void showState();
  void showFrame(const editor::FramePtr& frame);
  void showBetween();
  void hearEvents(int first, int last);
  void followRecorded();
  void refuseEdits();
  void forgetUnsavedCode();

  editor::Theme theme_;
  editor::RunSettings runSettings_;
  editor::ScenarioDocument document_;
  editor::MapScene scene_;
  editor::MapView* view_;  // owned by the widget that it is put into
  editor::ToolManager tools_;
  editor::SimulationRunner runner_;
  editor::RunEvents events_;
  editor::MetricsFeed feed_;
  editor::PlaybackActions playback_;
  editor::ScrubActions scrub_;
  editor::PeopleHands hands_;
  std::set<std::pair<QString, std::string>> allowedCode_;  // file (empty: not saved yet), its words
  std::optional<QString> freeFile_;
  QString recordedName_;  // of the recorded run that is shown
  bool isReplaced_ = false;
  // between two frames
  QTimer smooth_;
  QElapsedTimer sinceFrame_;
  double period_ = 0.0;                       // [s] on the wall
  double shownTime_ = 0.0;                    // [s] of the frame
  std::unique_ptr<editor::HandDrive> drive_;  // hears of frames after the scene
};

}  // namespace app
