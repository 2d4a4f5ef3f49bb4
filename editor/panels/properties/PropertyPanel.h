#pragma once

#include <map>
#include <optional>

#include <QtWidgets>

#include "editor/look/Form.h"
#include "editor/panels/properties/PropertyPage.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Frame.h"

namespace editor {

class RunStateSection;

/// The right dock: properties of the selection, or of the scenario if nothing is selected.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);
  PropertyPage* page(EntityKind kind) const { return pages_.at(kind); }
  PropertyPage* currentPage() const { return current_; }
  /// Shows the state of a run; null ends it. Edits take effect at the next start; recorded runs are
  /// read-only.
  void showFrame(const FramePtr& frame, bool isRecorded = false);
  void setDriveAction(QAction* drive);
  /// A spawned person of the run, shown instead of the selection.
  void setSpawnedAgent(std::optional<sim2d::TraceHuman> spawnedAgent);

 Q_SIGNALS:
  void restartRequested();  // Requests restarting the current run with the edits.

 private:
  void follow();
  void refresh();
  void showHeading(const std::vector<EntityId>& ids);
  void showRunState();
  void showSpawnedPerson();
  std::optional<int> agentOf(EntityId id) const;
  QPixmap picture(const Entity& entity) const;

  ScenarioDocument& document_;
  Theme theme_;
  QLabel* picture_;
  ElidedLabel* name_;
  QLabel* about_;
  RunStateSection* runState_;
  QWidget* later_;
  bool isSame_ = true;  // No entities were added or removed in the current step.
  FramePtr frame_;
  bool isRecorded_ = false;
  QStackedWidget* stack_;
  QLabel* spawnedPersonPage_;
  std::optional<sim2d::TraceHuman> spawnedAgent_;
  std::map<EntityKind, PropertyPage*> pages_;
  PropertyPage* current_ = nullptr;
};

/// The state of a person or robot in the shown frame: position, heading, speed, goal and distance
/// to the robot. Hidden without a run.
class RunStateSection : public FormSection {
 public:
  explicit RunStateSection(QWidget* parent);
  /// The action that drives the shown robot; its button is visible while the action is enabled.
  void setDriveAction(QAction* drive);
  /// `agent` as in frames: people by id, robots negative; `robot`: the settings of that robot.
  void show(const sim2d::Frame* frame, std::optional<int> agent, const sim2d::Robot* robot);

 private:
  template <class Columns>
  std::optional<std::size_t> showBody(const Columns& bodies, int id);
  bool showPerson(const sim2d::Frame& frame, int id);
  bool showRobot(const sim2d::Frame& frame, int id, const sim2d::Robot& robot);

  QLabel* position_ = new QLabel(this);
  QLabel* heading_ = new QLabel(this);
  QLabel* speed_ = new QLabel(this);
  QLabel* goal_ = new QLabel(this);
  QLabel* robot_ = new QLabel(this);
  QToolButton* drive_ = new QToolButton(this);
};

}  // namespace editor
