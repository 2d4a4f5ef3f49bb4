#pragma once

#include "editor/canvas/MapView.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

/// All tools and an exclusive group of checkable actions in tool bar order. The first tool (select)
/// is active at the start.
class ToolManager : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    ToolInfo info;
    Tool* tool;
    QAction* action;  // data() = icon name; the window sets the icon.
  };

  ToolManager(ScenarioDocument& document, MapScene& scene,
              const ToolRegistry& registry = standardTools(), QObject* parent = nullptr);
  ~ToolManager() override;
  Q_DISABLE_COPY_MOVE(ToolManager)

  const std::vector<Entry>& entries() const { return entries_; }
  QActionGroup& actions() { return group_; }
  Tool* current() const { return current_; }
  bool isSelecting() const { return current_ == entries_.front().tool; }
  /// Editing tools are disabled during a simulation; the select tool still selects.
  void setEditingEnabled(bool enabled);

 Q_SIGNALS:
  void currentChanged(editor::Tool* tool);
  void statusTextChanged(const QString& text);

 protected:
  /// Escape activates the first tool if the current tool has no gesture in progress.
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

/// A bar over the upper left corner of the canvas with the options of the current tool; hidden if
/// the tool has none. Between its fields the canvas receives the mouse.
class ToolOptionsBar : public QWidget {
  Q_OBJECT
 public:
  ToolOptionsBar(ToolManager& tools, MapView& view);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override { passToMap(*event); }
  void mouseMoveEvent(QMouseEvent* event) override { passToMap(*event); }
  void mouseReleaseEvent(QMouseEvent* event) override { passToMap(*event); }
  void mouseDoubleClickEvent(QMouseEvent* event) override { passToMap(*event); }

 private:
  void passToMap(const QMouseEvent& event);
  void showFor(Tool* tool);
  void place();

  MapView& view_;
  std::map<Tool*, QWidget*> rows_;  // Created on first use; null: the tool has no options.
  QWidget* row_ = nullptr;
};

}  // namespace editor
