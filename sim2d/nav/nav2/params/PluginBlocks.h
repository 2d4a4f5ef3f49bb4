#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/params/NodeReader.h"

/// Reading of the plugins that a server lists. Private to this folder.
namespace sim2d::nav2 {

/// Names of a list of plugins, each once; a warning for the others.
std::vector<std::string> pluginNames(NodeReader& node, const std::string& list,
                                     const std::vector<std::string>& names);

/// The class below a plugin's name; `fallback` when there is none, an error when that is empty.
std::string pluginClass(NodeReader& node, const std::string& name, const std::string& fallback);

/// An unknown class, at its place, with what comes nearest.
void tellUnknownPlugin(NodeReader& node, const std::string& name, const std::string& found,
                       const std::vector<std::string>& known);

/// Problems of a server told at the places of the keys that they name, else at the plugin's class.
void tellAt(NodeReader& node, const base::Diagnostics& problems);

/// A class that is not re-implemented, with its substitute and the reason.
void tellSubstitute(NodeReader& node, const std::string& name, const std::string& found,
                    const std::string& substitute, const std::string& why);
/// A class that can be left out, and why it is not re-implemented.
void tellLeftOut(NodeReader& node, const std::string& name, const std::string& found,
                 const std::string& why);

/// By the class `type`: `find(type)` gives something like PluginAnswer; its keys are read into it.
/// A class of Nav2 that is not re-implemented is replaced by the nearest one, with a warning.
template <class Find, class Variant>
void readAnswered(NodeReader& node, const std::string& name, const std::string& type,
                  const Find& find, const std::vector<std::string>& known,
                  std::vector<std::pair<std::string, Variant>>& to) {
  auto answer = find(type);
  const std::string prefix = name + ".";
  const bool isReplaced = !answer.parameters && !answer.why.empty() && !answer.name.empty();
  if (isReplaced) {
    tellSubstitute(node, name, type, answer.name, answer.why);
    answer = find(answer.name);
  }
  if (!answer.parameters) {
    tellUnknownPlugin(node, name, type, known);
    node.know(prefix, "its class is not here");
    return;
  }
  Variant parameters = *std::move(answer.parameters);
  std::visit([&](auto& held) { held = node.read(prefix, keysOf(held), idleKeysOf(held), held); },
             parameters);
  if (isReplaced) {
    node.know(prefix, "a key of " + type);
  }
  for (const std::string& complaint : complaintsAbout(parameters)) {
    const std::string key = complaint.substr(0, complaint.find(' '));
    node.tell(prefix + key, base::error("nav2.bad-value", {prefix + complaint}));
  }
  to.emplace_back(name, std::move(parameters));
}

}  // namespace sim2d::nav2
