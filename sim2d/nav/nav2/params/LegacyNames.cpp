#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/RosValue.h"
#include "sim2d/nav/nav2/params/ServerParameterReader.h"

namespace sim2d::nav2 {
namespace {

struct LegacyName {
  const char* node;
  const char* from;
  const char* to;
};
/// Lists of plugin names.
constexpr std::array<LegacyName, 8> kLegacyLists = {
    {{"controller_server", "controller_plugin_ids", "controller_plugins"},
     {"controller_server", "goal_checker_plugin", "goal_checker_plugins"},
     {"planner_server", "planner_plugin_ids", "planner_plugins"},
     {"recoveries_server", "recovery_plugins", "behavior_plugins"},
     {"recoveries_server", "plugin_names", "behavior_plugins"},
     {"local_costmap", "plugin_names", "plugins"},
     {"global_costmap", "plugin_names", "plugins"},
     {"behavior_server", "recovery_plugins", "behavior_plugins"}}};
/// Lists of plugin classes, in the order of the list of names.
constexpr std::array<LegacyName, 5> kLegacyTypes = {
    {{"controller_server", "controller_plugin_types", "controller_plugin_ids"},
     {"planner_server", "planner_plugin_types", "planner_plugin_ids"},
     {"recoveries_server", "plugin_types", "plugin_names"},
     {"local_costmap", "plugin_types", "plugin_names"},
     {"global_costmap", "plugin_types", "plugin_names"}}};
/// Files of navigator trees, in files of branches before Humble.
constexpr std::array<const char*, 2> kLegacyTrees = {"default_bt_xml_filename", "bt_xml_filename"};
constexpr const char* kLegacyTree = "navigate_w_replanning_and_recovery.xml";
constexpr const char* kTreeSinceHumble = "navigate_to_pose_w_replanning_and_recovery.xml";
/// Suffixes of the keys of an observation source.
constexpr std::array<std::pair<const char*, const char*>, 2> kLegacyRanges = {
    {{".obstacle_range", ".obstacle_max_range"}, {".raytrace_range", ".raytrace_max_range"}}};

/// The value as a list: Foxy names its single goal checker by a string.
base::YamlNode asList(const base::YamlNode& value) {
  if (!value.isScalar()) {
    return value;
  }
  base::YamlNode list(base::YamlNode::Kind::List);
  list.line = value.line;
  list.column = value.column;
  list.items.push_back(value);
  return list;
}

/// Renames a parameter unless the new name is already given.
void rename(NodeReader& node, const std::string& from, const std::string& to, bool isList,
            std::vector<std::string>& renamed) {
  const GivenParameter* const given = node.parameters().find(from);
  if (given == nullptr || node.has(to)) {
    return;
  }
  base::YamlNode value = isList ? asList(*given->value) : *given->value;
  node.markUsed(from);
  node.supply(to, std::move(value), given->file);
  renamed.push_back(from);
}

void renameTypes(NodeReader& node, const LegacyName& old, std::vector<std::string>& renamed) {
  const GivenParameter* const types = node.parameters().find(old.from);
  const GivenParameter* const names = node.parameters().find(old.to);
  if (types == nullptr || names == nullptr || !types->value->isList() || !names->value->isList()) {
    return;
  }
  const base::YamlNode classes = *types->value, ids = *names->value;
  const std::string file = types->file;
  node.markUsed(old.from);
  renamed.emplace_back(old.from);
  for (std::size_t i = 0; i < std::min(classes.items.size(), ids.items.size()); ++i) {
    const std::string key = ids.items[i].text + ".plugin";
    if (!node.has(key)) {
      node.supply(key, classes.items[i], file);
    }
  }
}

/// Whether the class has its own key of the older name.
bool hasOwnRangeKey(const NodeReader& node, const std::string& name) {
  const GivenParameter* const type =
      node.parameters().find(name.substr(0, name.find('.')) + ".plugin");
  return type != nullptr && type->value->text.find("SpatioTemporal") != std::string::npos;
}

void renameRanges(NodeReader& node, std::vector<std::string>& renamed) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const GivenParameter& given : node.parameters().given) {
    for (const auto& [from, to] : kLegacyRanges) {
      if (base::endsWith(given.name, from) && !hasOwnRangeKey(node, given.name)) {
        const std::size_t kept = given.name.size() - std::string(from).size();
        found.emplace_back(given.name, given.name.substr(0, kept) + to);
      }
    }
  }
  for (const auto& [from, to] : found) {
    rename(node, from, to, false, renamed);
  }
}

/// Foxy's default tree has another name since Humble.
void renameTrees(NodeReader& node, std::vector<std::string>& renamed) {
  constexpr const char* kKey = "default_nav_to_pose_bt_xml";
  for (const char* const old : kLegacyTrees) {
    const GivenParameter* const given = node.parameters().find(old);
    if (given == nullptr || node.has(kKey)) {
      continue;
    }
    base::YamlNode value = *given->value;
    if (base::endsWith(value.text, kLegacyTree)) {
      value.text = kTreeSinceHumble;
    }
    std::string file = given->file;
    node.markUsed(old);
    node.supply(kKey, std::move(value), std::move(file));
    renamed.emplace_back(old);
  }
}

/// The placeholder in a list of plugins, or an empty string.
std::string placeholderIn(const std::string& name, const base::YamlNode& value) {
  if (isLaunchPlaceholder(name, value)) {
    return value.text;
  }
  const auto found =
      std::find_if(value.items.begin(), value.items.end(),
                   [](const base::YamlNode& item) { return isPlaceholderText(item.text); });
  return found == value.items.end() ? std::string() : found->text;
}

bool isEmptyList(const base::YamlNode& value) {
  return value.isList() &&
         std::all_of(value.items.begin(), value.items.end(),
                     [](const base::YamlNode& item) { return item.text.empty(); });
}

/// The list to which a plugin of this class belongs.
std::string listOf(const std::string& node, const std::string& type) {
  const auto has = [&type](const char* part) { return type.find(part) != std::string::npos; };
  if (node == "planner_server") {
    return "planner_plugins";
  }
  if (node == "smoother_server") {
    return "smoother_plugins";
  }
  if (node == "behavior_server" || node == "recoveries_server") {
    return "behavior_plugins";
  }
  if (node == "controller_server") {
    return has("GoalChecker")       ? "goal_checker_plugins"
           : has("ProgressChecker") ? "progress_checker_plugins"
           : has("PathHandler")     ? "path_handler_plugins"
                                    : "controller_plugins";
  }
  return has("Filter") ? "filters" : "plugins";
}

/// Names of the plugins whose blocks belong to a list, in the order of the file. Inflation layers
/// come last, because they must follow the layers that they inflate.
std::vector<std::string> blocksOf(const NodeReader& node, const std::string& list) {
  constexpr const char* kEnd = ".plugin";
  std::vector<std::string> names, inflations;
  for (const GivenParameter& given : node.parameters().given) {
    const std::string name = given.name.substr(0, given.name.find('.'));
    if (given.name != name + kEnd || listOf(node.node(), given.value->text) != list) {
      continue;
    }
    const bool isInflation = given.value->text.find("Inflation") != std::string::npos;
    (isInflation ? inflations : names).push_back(name);
  }
  names.insert(names.end(), inflations.begin(), inflations.end());
  return names;
}

/// Lists that a server needs to do anything.
bool isRequiredList(const std::string& name) {
  return base::endsWith(name, "_plugins");
}

/// A list that counts as absent; `placeholder` is empty for a list without names.
struct AbsentList {
  std::string name, placeholder;
};

std::vector<AbsentList> absentLists(const NodeReader& node) {
  std::vector<AbsentList> absent;
  for (const GivenParameter& given : node.parameters().given) {
    if (!isListOfPlugins(given.name)) {
      continue;
    }
    std::string placeholder = placeholderIn(given.name, *given.value);
    if (!placeholder.empty() || (isRequiredList(given.name) && isEmptyList(*given.value))) {
      absent.push_back({given.name, std::move(placeholder)});
    }
  }
  return absent;
}

/// Replaces an absent list by the plugins whose blocks are in the node, with a warning. A
/// placeholder without blocks is left to the reader of the key.
void fillList(NodeReader& node, const AbsentList& absent) {
  const std::vector<std::string> blocks = blocksOf(node, absent.name);
  if (!absent.placeholder.empty() && blocks.empty()) {
    return;
  }
  const std::string path = node.node() + "." + absent.name;
  const std::string instead = blocks.empty() ? "Nav2's default is used"
                                             : "its blocks are used: " + base::join(blocks, ", ");
  node.report(absent.name,
              absent.placeholder.empty()
                  ? base::warning("nav2.empty-list", {path, instead})
                  : base::warning("nav2.list-placeholder", {path, absent.placeholder, instead}));
  const GivenParameter given = *node.parameters().find(absent.name);
  const base::YamlNode place = *given.value;
  node.markUsed(absent.name);
  node.drop(absent.name);
  if (blocks.empty()) {
    return;
  }
  base::YamlNode list(base::YamlNode::Kind::List);
  list.line = place.line;
  list.column = place.column;
  for (const std::string& block : blocks) {
    list.items.push_back(base::stringNode(block));
  }
  node.supply(absent.name, std::move(list), given.file);
}

}  // namespace

void renameLegacyKeys(NodeReader& node, bool isPreHumble) {
  std::vector<std::string> renamed;
  for (const LegacyName& old : kLegacyTypes) {
    if (node.node() == old.node) {
      renameTypes(node, old, renamed);
    }
  }
  for (const LegacyName& old : kLegacyLists) {
    if (node.node() == old.node) {
      rename(node, old.from, old.to, true, renamed);
    }
  }
  if (isPreHumble && (node.node() == "local_costmap" || node.node() == "global_costmap")) {
    renameRanges(node, renamed);
  }
  if (isPreHumble && node.node() == "bt_navigator") {
    renameTrees(node, renamed);
  }
  if (!renamed.empty()) {
    node.report(renamed.front(),
                base::warning("nav2.older-branch", {node.node(), base::join(renamed, ", ")}));
  }
}

void fillMissingLists(NodeReader& node) {
  for (const AbsentList& absent : absentLists(node)) {
    fillList(node, absent);
  }
}

}  // namespace sim2d::nav2
