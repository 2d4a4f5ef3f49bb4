#pragma once

#include <map>

#include <QLabel>
#include <QScrollArea>
#include <QStackedWidget>

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
  /// Values can be looked at, but not changed, while a simulation runs.
  void setEditingEnabled(bool enabled);

 private:
  void addPage(EntityKind kind, PropertyPage* page);
  void follow();
  void refresh();
  void showHeading(const std::vector<EntityId>& ids);
  QPixmap picture(const Entity& entity) const;

  ScenarioDocument& document_;
  Theme theme_;
  QLabel* picture_;
  QLabel* name_;
  QLabel* about_;
  QStackedWidget* stack_;
  std::map<EntityKind, PropertyPage*> pages_;
  std::map<EntityKind, QScrollArea*> areas_;
};

}  // namespace editor
