#include <algorithm>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

using KeyPath = std::vector<std::string>;

constexpr const char* kNav2Word = "nav2";  // the planner, and the key of its values

/// The paths meant: `*` stands for each listed person, `nav2` in front for that key of each listed
/// robot that it drives. Nothing = there is none.
std::vector<KeyPath> expanded(const Scenario& scenario, const std::string& text) {
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

bool isSame(const GlobalGoal& a, const GlobalGoal& b) {
  return a.id == b.id;
}
bool isSame(const Named& a, const Named& b) {
  return a.name == b.name;
}

/// Entities keep their identity when the scenario is read anew.
void takeKeys(Scenario& to, const Scenario& from) {
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
  known.insert(known.end(), reading.blockPaths.begin(), reading.blockPaths.end());
  const std::vector<Human>& people = reading.file.scenario.humans;
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
std::optional<TreeReading> readWith(YamlNode tree, bool isLoader, const std::vector<KeyPath>& paths,
                                    const YamlNode& value, const FieldTables& tables) {
  YamlNode& node = tree.child(isLoader ? kLoaderNode : kBlockNode).child(kParameters);
  if (!isLoader && node.find("format") == nullptr) {
    setChild(node, "format", number(kBlockFormat));
  }
  for (const KeyPath& path : paths) {
    YamlNode* at = &node;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      at = &at->child(path[i]);
    }
    setChild(*at, path.back(), value);
  }
  TreeReading reading = readTree(tree, {}, tables);
  const std::set<std::string>& known = isLoader ? reading.loaderPaths : reading.blockPaths;
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
    const bool isNav2 = base::split(path, '.').front() == kNav2Word;
    return {base::within(path, base::error(isNav2 ? "set.no-nav2" : "set.nobody"))};
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
  base::Diagnostics result = added(before.file.diagnostics, after->file.diagnostics);
  if (!base::hasErrors(result)) {
    takeKeys(after->file.scenario, scenario);
    scenario = std::move(after->file.scenario);
  }
  return result;
}

}  // namespace sim2d
