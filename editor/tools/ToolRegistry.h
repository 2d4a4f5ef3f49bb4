#pragma once

#include <functional>
#include <vector>

#include <QKeySequence>

#include "editor/canvas/Tool.h"

namespace editor {

/// How a tool appears in tool bar and menu.
struct ToolInfo {
  int order = 0;          // ascending in bar and menu; the first tool is the one to begin with
  QString name;           // "Person"
  QString icon;           // "tool-person", of resources/icons
  QKeySequence shortcut;  // without modifiers: heard by the canvas
  QString button = {};    // tools of the same word share a button of the bar; empty: none
};

/// The tools that there are. Each file `tools/<Name>Tool.cpp` adds its own by a function
/// void add<Name>Tool(ToolRegistry&), which CMake finds.
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
