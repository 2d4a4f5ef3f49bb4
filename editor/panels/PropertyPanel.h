#pragma once

#include <map>

#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>

#include "editor/panels/ElidedLabel.h"
#include "editor/panels/NowSection.h"
#include "editor/panels/PropertyPage.h"

namespace editor {

/// The right dock: properties of what is selected; of the scenario when nothing is.
class PropertyPanel : public QWidget {
  Q_OBJECT
 public:
  PropertyPanel(ScenarioDocument& document, const Theme& theme, QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  PropertyPage* page(EntityKind kind) const { return pages_.at(kind); }
  PropertyPage* currentPage() const;
  /// The moment of a run that is shown; none ends it. What is edited then counts from the next
  /// start.
  void showFrame(const FramePtr& frame);

 private:
  void addPage(EntityKind kind, PropertyPage* page);
  void follow();
  void refresh();
  void showHeading(const std::vector<EntityId>& ids);
  void showNow();
  std::optional<int> agentOf(EntityId id) const;
  QPixmap picture(const Entity& entity) const;

  ScenarioDocument& document_;
  Theme theme_;
  QLabel* picture_;
  ElidedLabel* name_;
  QLabel* about_;
  NowSection* now_;
  QLabel* later_;
  bool isSame_ = true;  // in the step that has not ended nothing came or went
  FramePtr frame_;
  QStackedWidget* stack_;
  std::map<EntityKind, PropertyPage*> pages_;
  std::map<EntityKind, QScrollArea*> areas_;
};

}  // namespace editor
