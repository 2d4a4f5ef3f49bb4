#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/params/NodeReader.h"

/// Reading of the plugins that a server lists. Private to this folder.
namespace sim2d::nav2 {

/// Names of a list of plugins, each once; twice is an error.
std::vector<std::string> pluginNames(NodeReader& node, const std::string& list,
                                     const std::vector<std::string>& names);

/// The class below a plugin's name; `fallback` when there is none, an error when that is empty.
std::string pluginClass(NodeReader& node, const std::string& name, const std::string& fallback);

/// An unknown class, at its place, with what comes nearest.
void tellUnknownPlugin(NodeReader& node, const std::string& name, const std::string& found,
                       const std::vector<std::string>& known);

/// Problems of a server told at the places of the keys that they name, else at the plugin's class.
void tellAt(NodeReader& node, const base::Diagnostics& problems);

/// By a class, `find(class)` gives something like PluginAnswer; its keys are read into it.
template <class Answer, class Variant>
void readAnswered(NodeReader& node, const std::string& name, Answer answer,
                  const std::vector<std::string>& known,
                  std::vector<std::pair<std::string, Variant>>& to) {
  if (!answer.parameters) {
    const GivenParameter* const given = node.parameters().find(name + ".plugin");
    const std::string found = given != nullptr ? given->value->text : answer.name;
    if (answer.why.empty()) {
      tellUnknownPlugin(node, name, found, known);
    } else {
      node.tell(name + ".plugin", base::error("nav2.unsupported-plugin", {found, answer.why}));
    }
    node.know(name + ".", "its class is not here");
    return;
  }
  Variant parameters = *std::move(answer.parameters);
  std::visit(
      [&](auto& held) { held = node.read(name + ".", keysOf(held), idleKeysOf(held), held); },
      parameters);
  const std::string prefix = name + ".";
  for (const std::string& complaint : complaintsAbout(parameters)) {
    const std::string key = complaint.substr(0, complaint.find(' '));
    node.tell(prefix + key, base::error("nav2.bad-value", {prefix + complaint}));
  }
  to.emplace_back(name, std::move(parameters));
}

}  // namespace sim2d::nav2
