#pragma once

#include <vector>

#include <QActionGroup>

#include "editor/tools/ToolRegistry.h"

namespace editor {

/// All tools and one exclusive group of checkable actions, in tool bar order. The first one
/// (select) is active at the start.
class ToolManager : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    ToolInfo info;
    Tool* tool;
    QAction* action;  // data() = name of the icon, set by the window
  };

  ToolManager(ScenarioDocument& document, MapScene& scene,
              const ToolRegistry& registry = standardTools(), QObject* parent = nullptr);
  ~ToolManager() override;
  Q_DISABLE_COPY_MOVE(ToolManager)

  const std::vector<Entry>& entries() const { return entries_; }
  QActionGroup& actions() { return group_; }
  Tool* current() const { return current_; }
  bool isSelecting() const { return current_ == entries_.front().tool; }
  /// Tools rest while a simulation runs; the select tool still selects.
  void setEditingEnabled(bool enabled);

 Q_SIGNALS:
  void currentChanged(editor::Tool* tool);
  void statusTextChanged(const QString& text);

 protected:
  /// Escape in a tool that is doing nothing goes back to the first one.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void add(const ToolRegistry::Entry& entry, ScenarioDocument& document);
  void setCurrent(const Entry& entry);

  MapScene& scene_;
  QActionGroup group_;
  std::vector<Entry> entries_;
  Tool* current_ = nullptr;
  bool editingEnabled_ = true;
};

}  // namespace editor
