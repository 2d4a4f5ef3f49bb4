#pragma once

#include <vector>

#include <QActionGroup>

#include "editor/canvas/Tool.h"

namespace editor {

/// All tools and one exclusive group of checkable actions, in tool bar order. The first one
/// (select) is active at the start.
class ToolManager : public QObject {
  Q_OBJECT
 public:
  /// Makes the standard tools.
  ToolManager(ScenarioDocument& document, MapScene& scene, QObject* parent = nullptr);
  ~ToolManager() override;
  Q_DISABLE_COPY_MOVE(ToolManager)

  void add(Tool* tool);  // takes it as a child; further tools may be added by others
  const std::vector<Tool*>& tools() const { return tools_; }
  QAction* action(const Tool* tool) const;
  QActionGroup& actions() { return group_; }  // data() = name of the icon, set by the window
  Tool* current() const { return current_; }
  void setCurrent(Tool* tool);
  /// Tools rest while a simulation runs; the select tool still selects.
  void setEditingEnabled(bool enabled);

 Q_SIGNALS:
  void currentChanged(editor::Tool* tool);
  void statusTextChanged(const QString& text);

 private:
  MapScene& scene_;
  QActionGroup group_;
  std::vector<Tool*> tools_;
  Tool* current_ = nullptr;
  bool editingEnabled_ = true;
};

}  // namespace editor
