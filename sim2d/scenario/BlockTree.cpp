#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

/// The list of names and the maps beside it, those switched off last.
template <class T>
void setEntities(YamlNode& tree, const std::string& key, const std::vector<T>& entities,
                 const FieldTables& tables) {
  YamlNode names;
  names.kind = YamlNode::Kind::List;
  for (const T& entity : entities) {
    if (entity.listed) {
      names.items.push_back(stringNode(entity.name));
    }
  }
  if (!names.items.empty()) {
    setChild(tree, key, std::move(names));
  }
  for (const bool listed : {true, false}) {
    for (const T& entity : entities) {
      if (entity.listed == listed) {
        setChild(tree, entity.name, fieldTree(entity, tables));
      }
    }
  }
}

}  // namespace

YamlNode blockTree(const Scenario& given, const FieldTables& tables) {
  const Scenario scenario = withoutDefaults(given, tables);
  YamlNode tree;
  setChild(tree, "format", number(kBlockFormat));
  writeFields(tree, scenario.desktop, tables);
  for (const bool listed : {true, false}) {
    for (const Human& human : scenario.humans) {
      YamlNode person = fieldTree(human.ours, tables);
      if (human.listed == listed && !person.isNull()) {
        setChild(tree, human.name, std::move(person));
      }
    }
  }
  setEntities(tree, "robots", scenario.robots, tables);
  setEntities(tree, "obstacles", scenario.obstacles, tables);
  setEntities(tree, "doors", scenario.doors, tables);
  setEntities(tree, "areas", scenario.areas, tables);
  YamlNode metrics = fieldTree(scenario.desktop.metrics, tables);
  if (!metrics.isNull()) {
    setChild(tree, "metrics", std::move(metrics));
  }
  setUnknown(tree, scenario.desktop.unknown);
  return tree.items.size() > 1 ? tree : YamlNode();
}

}  // namespace sim2d
