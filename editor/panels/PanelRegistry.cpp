#include "editor/panels/PanelRegistry.h"

#include <algorithm>

namespace editor {

void addAllPanels(PanelRegistry& to);  // written by CMake

void PanelRegistry::add(PanelInfo info, Make make) {
  const auto after = std::find_if(entries_.begin(), entries_.end(), [&info](const Entry& entry) {
    return entry.info.order > info.order;
  });
  entries_.insert(after, {std::move(info), std::move(make)});
}

PanelInfo closedBelow(int order, const QString& title) {
  constexpr int kRoom = 232;
  return {order, title, Qt::BottomDockWidgetArea, true, kRoom, false};
}

PanelRegistry standardPanels() {
  PanelRegistry registry;
  addAllPanels(registry);
  return registry;
}

}  // namespace editor
