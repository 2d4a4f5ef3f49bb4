#include "sim2d/nav/nav2/params/PluginBlocks.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {

std::vector<std::string> pluginNames(NodeReader& node, const std::string& list,
                                     const std::vector<std::string>& names) {
  if (names.size() > kMostNames) {  // in one text; lists are looked at by who reads them
    node.tell(list, base::error("nav2.too-many-names", {list, names.size(), kMostNames}));
    return {};
  }
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (std::find(once.begin(), once.end(), name) != once.end()) {
      node.tell(list, base::warning("nav2.plugin-twice", {list, name}));
    } else if (!name.empty()) {
      once.push_back(name);
    }
  }
  return once;
}

std::string pluginClass(NodeReader& node, const std::string& name, const std::string& fallback) {
  const std::string key = name + ".plugin";
  if (const auto given = node.value<std::string>(key)) {
    return *given;
  }
  if (!node.has(key) && fallback.empty() && !node.isPlaceholder(key)) {
    node.tell(key, base::error("nav2.no-plugin", {node.node(), name}));
  }
  return fallback;
}

void tellUnknownPlugin(NodeReader& node, const std::string& name, const std::string& found,
                       const std::vector<std::string>& known) {
  node.tell(name + ".plugin", unknownPlugin(found, known));
}

void tellSubstitute(NodeReader& node, const std::string& name, const std::string& found,
                    const std::string& substitute, const std::string& why) {
  node.tell(name + ".plugin",
            base::warning("nav2.treated-as", {node.node() + "." + name, found, substitute, why}));
}

void tellLeftOut(NodeReader& node, const std::string& name, const std::string& found,
                 const std::string& why) {
  node.tell(name + ".plugin",
            base::warning("nav2.left-out", {node.node() + "." + name, found, why}));
}

void tellAt(NodeReader& node, const base::Diagnostics& problems) {
  for (const base::Diagnostic& problem : problems) {
    const std::string where = problem.value("where");
    std::string place = where.empty() ? std::string() : where + ".plugin";
    for (const auto& [hole, value] : problem.values) {
      for (const std::string& key : {value, base::join({where, value}, ".")}) {
        place = node.has(key) ? key : place;
      }
    }
    node.tell(place, base::within(node.node(), problem));
  }
}

}  // namespace sim2d::nav2
