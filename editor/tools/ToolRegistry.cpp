#include "editor/tools/ToolRegistry.h"

#include <algorithm>

namespace editor {

void addAllTools(ToolRegistry& to);  // written by CMake

void ToolRegistry::add(ToolInfo info, Make make) {
  const auto after = std::find_if(entries_.begin(), entries_.end(), [&info](const Entry& entry) {
    return entry.info.order > info.order;
  });
  entries_.insert(after, {std::move(info), std::move(make)});
}

ToolRegistry standardTools() {
  ToolRegistry registry;
  addAllTools(registry);
  return registry;
}

}  // namespace editor
