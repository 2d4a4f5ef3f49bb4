#pragma once

#include "editor/look/Form.h"
#include "editor/panels/properties/KindSwitch.h"
#include "editor/panels/properties/PropertyPage.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Frame.h"

namespace editor {

class RunStateSection;

/// The right dock: properties of the selection, or of the scenario if nothing is selected. If
/// several kinds are selected, a switch chooses the kind that is shown and changed.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);
  PropertyPage* page(EntityKind kind) const { return pages_.at(kind); }
  PropertyPage* currentPage() const { return current_; }
  /// Shows the state of a run; null ends it. Edits take effect at the next start; recorded runs are
  /// read-only.
  /// `header`: that of the run; null: the sizes of bodies are unknown.
  void showFrame(const FramePtr& frame, bool isRecorded = false,
                 std::shared_ptr<const sim2d::TraceHeader> header = nullptr);
  void setDriveAction(QAction* drive);
  /// A spawned person of the run, shown instead of the selection.
  void setSpawnedAgent(std::optional<sim2d::TraceHuman> spawnedAgent);

 Q_SIGNALS:
  void restartRequested();                   // Requests restarting the current run with the edits.
  void panelRequested(const QString& name);  // As `PanelContext::panelRequested`.

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
  QLabel* picture_ = new QLabel(this);
  ElidedLabel* name_ = new ElidedLabel(this);
  QLabel* about_ = secondaryLabel({}, this);
  KindSwitch* kinds_ = new KindSwitch(this);
  RunStateSection* runState_;
  QWidget* later_ = new QWidget(this);
  bool isSame_ = true;  // No entities were added or removed in the current step.
  std::shared_ptr<const sim2d::TraceHeader> header_;  // Null: unknown.
  FramePtr frame_;
  bool isRecorded_ = false;
  QStackedWidget* stack_ = new QStackedWidget(this);
  QLabel* spawnedPersonPage_ =
      emptyState(tr("Spawned by a source in this run. To change such people, select the person "
                    "that the source copies."),
                 stack_);
  std::optional<sim2d::TraceHuman> spawnedAgent_;
  std::map<EntityKind, PropertyPage*> pages_;
  PropertyPage* current_ = nullptr;
};

}  // namespace editor
