#include <algorithm>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

using KeyPath = std::vector<std::string>;

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

/// In dialect C a type is a name; a number would trigger the conversion of older formats.
bool isNumberedType(const std::string& path, const YamlNode& value) {
  constexpr std::string_view kEnd = ".behavior.type";
  return path.size() > kEnd.size() && base::endsWith(path, kEnd) &&
         (!value.isScalar() || base::parseDouble(value.text));
}

/// Reads the tree with the value set in one of the nodes; none if the node has no such key.
std::optional<TreeReading> readWith(YamlNode tree, bool isLoader, const std::vector<KeyPath>& paths,
                                    const YamlNode& value, const FieldTables& tables) {
  YamlNode& node = tree.child(isLoader ? kLoaderNode : kDesktopNode).child(kParameters);
  if (!isLoader && node.find("format") == nullptr) {
    setChild(node, "format", number(kDesktopFormat));
  }
  for (const KeyPath& path : paths) {
    YamlNode* at = &node;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      at = &at->child(path[i]);
    }
    setChild(*at, path.back(), value);
  }
  TreeReading reading = readTree(tree, {}, tables);
  const std::set<std::string>& known = isLoader ? reading.loaderPaths : reading.desktopPaths;
  const bool isKnown = std::all_of(paths.begin(), paths.end(), [&](const KeyPath& path) {
    return known.count(base::join(path, ".")) != 0;
  });
  return isKnown ? std::make_optional(std::move(reading)) : std::nullopt;
}

}  // namespace

base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables) {
  base::Diagnostics problems;
  YamlNode node = parseYaml(value, {}, problems);
  if (base::hasErrors(problems) || node.isNull()) {
    return {base::withContext(path, base::error("set.no-value", {value}))};
  }
  node.line = node.column = 0;
  if (isNumberedType(path, node)) {
    return {base::withContext(path, base::error("set.no-behavior", {value}))};
  }
  const YamlNode tree = fileTree(scenario, tables);
  const TreeReading before = readTree(tree, {}, tables);
  const std::vector<KeyPath> paths = expandedPaths(scenario, path);
  if (paths.empty()) {
    const bool isNav2 = base::split(path, '.').front() == kNav2Word;
    return {base::withContext(path, base::error(isNav2 ? "set.no-nav2" : "set.nobody"))};
  }
  const std::string& first = paths.front().front();
  std::optional<TreeReading> after;
  if (loaderKeys().count(first) != 0 || scenario.human(first) != nullptr) {
    after = readWith(tree, true, paths, node, tables);
  }
  if (!after) {
    after = readWith(tree, false, paths, node, tables);
  }
  if (!after) {
    return unknownPath(path, before);
  }
  base::Diagnostics result = newDiagnostics(before.file.diagnostics, after->file.diagnostics);
  if (!base::hasErrors(result)) {
    restoreEntityKeys(after->file.scenario, scenario);
    scenario = std::move(after->file.scenario);
  }
  return result;
}

}  // namespace sim2d
