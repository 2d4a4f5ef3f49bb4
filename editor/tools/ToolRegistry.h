#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Presentation of a tool in tool bar and menu.
struct ToolInfo {
  int order = 0;          // Ascending in bar and menu; the first tool is the default.
  QString name;           // "Person"
  QString icon;           // "tool-person", from resources/icons.
  QKeySequence shortcut;  // Without modifiers; handled by the canvas.
  QString button = {};    // Tools with the same text share a button of the bar; empty: own button.
};

/// The available tools. Each file `tools/<Name>Tool.cpp` registers its tools in a function void
/// add<Name>Tool(ToolRegistry&), which CMake finds.
class ToolRegistry {
 public:
  using Make = std::function<Tool*(ScenarioDocument&, MapScene&, QObject* parent)>;
  struct Entry {
    ToolInfo info;
    Make make;
  };

  template <class T>
  void add(ToolInfo info) {
    const auto make = [](ScenarioDocument& document, MapScene& scene, QObject* parent) {
      return new T(document, scene, parent);
    };
    entries_.push_back({std::move(info), make});
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// All tools of this folder.
ToolRegistry standardTools();

}  // namespace editor
