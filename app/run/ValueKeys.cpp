#include "app/run/ValueKeys.h"

#include <algorithm>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

using KeyPath = ValueKeys::KeyPath;

KeyPath below(KeyPath path, const std::string& key) {
  const KeyPath keys = base::split(key, '.');
  path.insert(path.end(), keys.begin(), keys.end());
  return path;
}

void addLeaves(const KeyPath& path, const base::YamlNode& node, std::set<KeyPath>& leaves) {
  if (!node.isMap() || node.items.empty()) {
    leaves.insert(path);
    return;
  }
  for (const base::YamlNode& item : node.items) {
    addLeaves(below(path, item.key), item, leaves);
  }
}

/// Whether a value of `later` is set for all that a value of `earlier` is set for. A value of one
/// person leaves those of the others.
bool coversEntity(const std::string& later, const std::string& earlier,
                  const std::vector<const sim2d::Scenario*>& scenarios) {
  if (later == earlier || later != "*") {
    return later == earlier;
  }
  return std::any_of(scenarios.begin(), scenarios.end(), [&](const sim2d::Scenario* scenario) {
    const sim2d::Human* const human = scenario->human(earlier);
    return human != nullptr && human->listed;
  });
}

}  // namespace

ValueKeys keysOf(const ExperimentValue& value) {
  const KeyPath path = base::split(value.path, '.');
  std::set<KeyPath> replaced, leaves;
  const auto add = [&](const KeyPath& at, const base::YamlNode& node) {
    replaced.insert(at);
    addLeaves(at, node, leaves);
  };
  for (const std::string& text : value.texts) {
    if (text.empty() || text.front() != '{') {
      continue;
    }
    base::Diagnostics ignored;
    const base::YamlNode map = base::parseYaml(text, {}, ignored);
    if (path.size() > 1) {
      add(path, map);
      continue;
    }
    for (const base::YamlNode& item : map.items) {
      add(below(path, item.key), item);
    }
  }
  if (replaced.empty()) {
    add(path, base::YamlNode());
  }
  return {{replaced.begin(), replaced.end()}, {leaves.begin(), leaves.end()}};
}

std::string replacedKey(const ValueKeys& earlier, const ValueKeys& later,
                        const std::vector<const sim2d::Scenario*>& scenarios) {
  for (const KeyPath& leaf : earlier.leaves) {
    for (const KeyPath& top : later.replaced) {
      if (top.size() <= leaf.size() && std::equal(top.begin() + 1, top.end(), leaf.begin() + 1) &&
          coversEntity(top.front(), leaf.front(), scenarios)) {
        return base::join(leaf, ".");
      }
    }
  }
  return {};
}

}  // namespace app
