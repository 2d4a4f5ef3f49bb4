#include <algorithm>
#include <map>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

using KeyPath = std::vector<std::string>;

/// The paths meant: `*` stands for each listed person. Nothing = there is none.
std::vector<KeyPath> expanded(const Scenario& scenario, const std::string& text) {
  const KeyPath path = base::split(text, '.');
  if (path.front() != "*") {
    return {path};
  }
  std::vector<KeyPath> all;
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      all.push_back(path);
      all.back().front() = human.name;
    }
  }
  return all;
}

bool belongsToLoader(const Scenario& scenario, const std::string& first) {
  return loaderKeys().count(first) != 0 || scenario.human(first) != nullptr;
}

void put(YamlNode& root, const char* node, const KeyPath& path, const YamlNode& value) {
  YamlNode* at = &root.child(node).child(kParameters);
  if (std::string_view(node) == kBlockNode && at->find("format") == nullptr) {
    setChild(*at, "format", number(kBlockFormat));
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    at = &at->child(path[i]);
  }
  setChild(*at, path.back(), value);
}

bool knowsAll(const std::set<std::string>& known, const std::vector<KeyPath>& paths) {
  return std::all_of(paths.begin(), paths.end(),
                     [&](const KeyPath& path) { return known.count(base::join(path, ".")) != 0; });
}

/// What the new reading says beyond the old one.
base::Diagnostics added(const base::Diagnostics& before, const base::Diagnostics& after) {
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

/// Entities keep their identity when the scenario is read anew.
template <class T, class Same>
void takeKeys(std::vector<T>& to, const std::vector<T>& from, Same same, int& next) {
  for (T& entity : to) {
    const auto found =
        std::find_if(from.begin(), from.end(), [&](const T& other) { return same(entity, other); });
    entity.key.key = found == from.end() ? next++ : found->key.key;
  }
}

void takeAllKeys(Scenario& to, const Scenario& from) {
  int next = from.nextKey();
  const auto sameName = [](const auto& a, const auto& b) { return a.name == b.name; };
  takeKeys(
      to.goals, from.goals, [](const GlobalGoal& a, const GlobalGoal& b) { return a.id == b.id; },
      next);
  takeKeys(to.humans, from.humans, sameName, next);
  takeKeys(to.robots, from.robots, sameName, next);
  takeKeys(to.obstacles, from.obstacles, sameName, next);
  takeKeys(to.doors, from.doors, sameName, next);
  takeKeys(to.areas, from.areas, sameName, next);
}

base::Diagnostics unknownPath(const std::string& path, const TreeReading& reading) {
  std::vector<std::string> known(reading.loaderPaths.begin(), reading.loaderPaths.end());
  known.insert(known.end(), reading.blockPaths.begin(), reading.blockPaths.end());
  const std::vector<Human>& people = reading.scenario.humans;
  if (path.compare(0, 2, "*.") == 0 && !people.empty()) {  // all people have the same keys
    const std::string prefix = people.front().name + ".";
    for (const std::string& each : std::vector<std::string>(known)) {
      if (each.compare(0, prefix.size(), prefix) == 0) {
        known.push_back("*." + each.substr(prefix.size()));
      }
    }
  }
  return {base::error("set.unknown-path", {path, base::nearestName(path, known)})};
}

/// In dialect C a type is a word; a number would bring in what older formats meant by it.
bool isNumberedType(const std::string& path, const YamlNode& value) {
  static const std::string kEnd = ".behavior.type";
  return path.size() > kEnd.size() &&
         path.compare(path.size() - kEnd.size(), kEnd.size(), kEnd) == 0 &&
         (!value.isScalar() || base::parseDouble(value.text));
}

/// Reads the tree with the value put into one of the nodes; nothing if the node has no such key.
std::optional<TreeReading> readWith(const YamlNode& tree, const char* node,
                                    const std::vector<KeyPath>& paths, const YamlNode& value,
                                    const FieldTables& tables) {
  YamlNode changed = tree;
  for (const KeyPath& path : paths) {
    put(changed, node, path, value);
  }
  TreeReading reading = readTree(changed, {}, tables);
  const bool loader = std::string_view(node) == kLoaderNode;
  if (!knowsAll(loader ? reading.loaderPaths : reading.blockPaths, paths)) {
    return std::nullopt;
  }
  return reading;
}

}  // namespace

base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables) {
  base::Diagnostics problems;
  YamlNode node = parseYaml(value, {}, problems);
  if (base::hasErrors(problems) || node.isNull()) {
    return {base::within(path, base::error("set.no-value", {value}))};
  }
  node.line = node.column = 0;
  if (isNumberedType(path, node)) {
    return {base::within(path, base::error("set.no-behavior", {value}))};
  }
  const YamlNode tree = fileTree(scenario, tables);
  const TreeReading before = readTree(tree, {}, tables);
  const std::vector<KeyPath> paths = expanded(scenario, path);
  if (paths.empty()) {
    return {base::within(path, base::error("set.nobody"))};
  }
  std::optional<TreeReading> after;
  if (belongsToLoader(scenario, paths.front().front())) {
    after = readWith(tree, kLoaderNode, paths, node, tables);
  }
  if (!after) {
    after = readWith(tree, kBlockNode, paths, node, tables);
  }
  if (!after) {
    return unknownPath(path, before);
  }
  base::Diagnostics result = added(before.report.diagnostics, after->report.diagnostics);
  if (!base::hasErrors(result)) {
    takeAllKeys(after->scenario, scenario);
    scenario = std::move(after->scenario);
  }
  return result;
}

}  // namespace sim2d
