#include <algorithm>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

using KeyPath = std::vector<std::string>;

/// A value, the keys that lead to it and the path as the user wrote it.
struct Setting {
  KeyPath keys;
  std::string path;
  YamlNode value;
  bool isLoader = false;  // a key of hunav_loader
};

constexpr const char* kNav2Word = "nav2";  // the planner, and the key of its values

/// Expands a path: `*` to each listed agent, a leading `nav2` to that key of each listed robot with
/// this planner. Empty: there is none.
std::vector<KeyPath> expandedPaths(const Scenario& scenario, const std::string& text) {
  const KeyPath path = base::split(text, '.');
  std::vector<KeyPath> all;
  if (path.front() == kNav2Word) {
    forEachListed(scenario.robots, [&](const Robot& robot) {
      if (robot.planner == kNav2Word) {
        all.push_back(path);
        all.back().insert(all.back().begin(), robot.name);
      }
    });
    return all;
  }
  if (path.front() != "*") {
    return {path};
  }
  forEachListed(scenario.humans, [&](const Human& human) {
    all.push_back(path);
    all.back().front() = human.name;
  });
  return all;
}

bool isNamed(const GlobalGoal& /*goal*/, const std::string& /*name*/) {
  return false;
}
bool isNamed(const NamedEntity& entity, const std::string& name) {
  return entity.name == name;
}

bool isEntity(const Scenario& scenario, const std::string& name) {
  bool isFound = false;
  forEachList(scenario, [&](base::EntityKind /*kind*/, const auto& list) {
    isFound = isFound || std::any_of(list.begin(), list.end(),
                                     [&](const auto& each) { return isNamed(each, name); });
  });
  return isFound;
}

/// One setting per path, or per key of a map that is given for a whole entity.
std::vector<Setting> settingsOf(const Scenario& scenario, const std::string& path,
                                const YamlNode& value) {
  std::vector<Setting> settings;
  for (const KeyPath& keys : expandedPaths(scenario, path)) {
    const bool isLoader =
        loaderKeys().count(keys.front()) != 0 || scenario.human(keys.front()) != nullptr;
    if (keys.size() > 1 || !value.isMap() || !isEntity(scenario, keys.front())) {
      settings.push_back({keys, path, value, isLoader});
      continue;
    }
    for (const YamlNode& item : value.items) {
      Setting setting{keys, path + "." + item.key, item, isLoader};
      const KeyPath below = base::split(item.key, '.');
      setting.keys.insert(setting.keys.end(), below.begin(), below.end());
      settings.push_back(std::move(setting));
    }
  }
  return settings;
}

/// The diagnostics of `after` that `before` does not have.
base::Diagnostics newDiagnostics(const base::Diagnostics& before, const base::Diagnostics& after) {
  using Problem = std::pair<std::string_view, decltype(base::Diagnostic::values)>;
  std::map<Problem, int> old;
  for (const base::Diagnostic& diagnostic : before) {
    ++old[{diagnostic.code, diagnostic.values}];
  }
  base::Diagnostics result;
  for (const base::Diagnostic& diagnostic : after) {
    if (--old[{diagnostic.code, diagnostic.values}] < 0) {
      result.push_back(diagnostic);
      result.back().line = 0;
      result.back().column = 0;
    }
  }
  return result;
}

bool isSame(const GlobalGoal& a, const GlobalGoal& b) {
  return a.id == b.id;
}
bool isSame(const NamedEntity& a, const NamedEntity& b) {
  return a.name == b.name;
}

/// Restores the identity of entities after the scenario was read again.
void restoreEntityKeys(Scenario& to, const Scenario& from) {
  int next = from.nextKey();
  forEachKind([&](base::EntityKind /*kind*/, auto list) {
    for (auto& entity : to.*list) {
      const auto& old = from.*list;
      const auto found = std::find_if(old.begin(), old.end(),
                                      [&](const auto& other) { return isSame(entity, other); });
      entity.key.key = found == old.end() ? next++ : found->key.key;
    }
  });
}

base::Diagnostics unknownPath(const std::string& path, const TreeReading& reading) {
  std::vector<std::string> known(reading.loaderPaths.begin(), reading.loaderPaths.end());
  known.insert(known.end(), reading.desktopPaths.begin(), reading.desktopPaths.end());
  const std::vector<Human>& people = reading.file.scenario.humans;
  if (base::startsWith(path, "*.") && !people.empty()) {  // all agents have the same keys
    const std::string prefix = people.front().name + ".";
    for (const std::string& each : std::vector<std::string>(known)) {
      if (base::startsWith(each, prefix)) {
        known.push_back("*." + each.substr(prefix.size()));
      }
    }
  }
  return {base::error("set.unknown-path", {path, base::nearestName(path, known)})};
}

constexpr std::string_view kBehaviorEnd = ".behavior";
constexpr std::string_view kTypeEnd = ".type";

/// Whether the path leads to a key of an entity with this end.
bool endsWithKey(std::string_view path, std::string_view end) {
  return path.size() > end.size() && base::endsWith(path, end);
}

/// In dialect C a type is a name; a number would trigger the conversion of older formats.
bool isNumberedType(const YamlNode& type) {
  return !type.isScalar() || base::parseDouble(type.text);
}

/// The error of a behaviour whose type is a number: `value` is the type, the whole behaviour as in
/// the format of 2022, or a map with the type.
base::Diagnostics errorOfType(const std::string& path, const std::string& text,
                              const YamlNode& value) {
  const std::string_view behavior = std::string_view(path).substr(
      0, path.size() - (endsWithKey(path, kTypeEnd) ? kTypeEnd.size() : 0));
  if (!endsWithKey(behavior, kBehaviorEnd)) {
    return {};
  }
  const bool isMap = behavior == path && value.isMap();
  const YamlNode* const type = isMap ? value.find("type") : &value;
  if (type == nullptr || !isNumberedType(*type)) {
    return {};
  }
  return {
      base::withContext(isMap ? path + std::string(kTypeEnd) : path,
                        base::error("set.no-behavior", {type->isScalar() ? type->text : text}))};
}

TreeReading readWith(YamlNode tree, const std::vector<Setting>& settings,
                     const FieldTables& tables) {
  for (const Setting& setting : settings) {
    YamlNode& node = tree.child(setting.isLoader ? kLoaderNode : kDesktopNode).child(kParameters);
    if (!setting.isLoader && node.find("format") == nullptr) {
      setChild(node, "format", number(kDesktopFormat));
    }
    YamlNode* at = &node;
    for (std::size_t i = 0; i + 1 < setting.keys.size(); ++i) {
      at = &at->child(setting.keys[i]);
    }
    setChild(*at, setting.keys.back(), setting.value);
  }
  return readTree(tree, {}, tables);
}

bool isKnown(const Setting& setting, const TreeReading& reading) {
  const std::set<std::string>& known =
      setting.isLoader ? reading.loaderPaths : reading.desktopPaths;
  return known.count(base::join(setting.keys, ".")) != 0;
}

/// Reads the tree with the settings; those whose key hunav_loader does not have are of our block.
TreeReading readWithSettings(const YamlNode& tree, std::vector<Setting>& settings,
                             const FieldTables& tables) {
  TreeReading reading = readWith(tree, settings, tables);
  bool isMoved = false;
  for (Setting& setting : settings) {
    if (setting.isLoader && !isKnown(setting, reading)) {
      setting.isLoader = false;
      isMoved = true;
    }
  }
  return isMoved ? readWith(tree, settings, tables) : reading;
}

base::Diagnostics errorOfValue(const std::string& path, const std::string& value,
                               const YamlNode& node) {
  if (node.isNull()) {
    return {base::withContext(path, base::error("set.no-value", {value}))};
  }
  return errorOfType(path, value, node);
}

base::Diagnostics errorOfNothingSet(const Scenario& scenario, const std::string& path,
                                    const std::string& value) {
  if (!expandedPaths(scenario, path).empty()) {  // an empty map
    return {base::withContext(path, base::error("set.no-value", {value}))};
  }
  const bool isNav2 = base::split(path, '.').front() == kNav2Word;
  return {base::withContext(path, base::error(isNav2 ? "set.no-nav2" : "set.nobody"))};
}

}  // namespace

base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables) {
  base::Diagnostics problems;
  YamlNode node = parseYaml(value, {}, problems);
  if (base::hasErrors(problems)) {
    return {base::withContext(path, base::error("set.no-value", {value}))};
  }
  node.line = node.column = 0;
  problems = errorOfValue(path, value, node);
  std::vector<Setting> settings = settingsOf(scenario, path, node);
  if (problems.empty() && settings.empty()) {
    return errorOfNothingSet(scenario, path, value);
  }
  for (Setting& setting : settings) {
    if (setting.path != path) {
      setting.value.line = setting.value.column = 0;
      base::append(problems, errorOfValue(setting.path, setting.value.text, setting.value));
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  const YamlNode tree = fileTree(scenario, tables);
  const TreeReading before = readTree(tree, {}, tables);
  TreeReading after = readWithSettings(tree, settings, tables);
  for (const Setting& setting : settings) {
    if (!isKnown(setting, after)) {
      return unknownPath(setting.path, before);
    }
  }
  base::Diagnostics result = newDiagnostics(before.file.diagnostics, after.file.diagnostics);
  if (!base::hasErrors(result)) {
    restoreEntityKeys(after.file.scenario, scenario);
    scenario = std::move(after.file.scenario);
  }
  return result;
}

}  // namespace sim2d
