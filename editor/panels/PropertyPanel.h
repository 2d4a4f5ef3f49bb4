#pragma once

#include <map>

#include <QLabel>
#include <QStackedWidget>

#include "editor/look/Form.h"
#include "editor/panels/PropertyPage.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

class NowSection;

/// The right dock: properties of what is selected; of the scenario when nothing is.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(ScenarioDocument& document, const Theme& theme);
  void setTheme(const Theme& theme);
  PropertyPage* page(EntityKind kind) const { return pages_.at(kind); }
  PropertyPage* currentPage() const { return current_; }
  /// The moment of a run that is shown; none ends it. What is edited then counts from the next
  /// start; of a recorded run nothing can be edited.
  void showFrame(const FramePtr& frame, bool isRecorded = false);
  void offerDrive(QAction* drive);
  /// Somebody whom a source brought into the run, to be looked at instead of the selection.
  void setGuest(std::optional<sim2d::TraceHuman> guest);

 Q_SIGNALS:
  void restartWanted();  // of the run that is on, with what has been edited

 private:
  void follow();
  void refresh();
  void showHeading(const std::vector<EntityId>& ids);
  void showNow();
  void showGuest();
  std::optional<int> agentOf(EntityId id) const;
  QPixmap picture(const Entity& entity) const;

  ScenarioDocument& document_;
  Theme theme_;
  QLabel* picture_;
  ElidedLabel* name_;
  QLabel* about_;
  NowSection* now_;
  QWidget* later_;
  bool isSame_ = true;  // in the step that has not ended nothing came or went
  FramePtr frame_;
  bool isRecorded_ = false;
  QStackedWidget* stack_;
  QLabel* guestPage_;
  std::optional<sim2d::TraceHuman> guest_;
  std::map<EntityKind, PropertyPage*> pages_;
  PropertyPage* current_ = nullptr;
};

}  // namespace editor
