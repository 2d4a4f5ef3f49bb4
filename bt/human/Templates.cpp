#include "bt/human/Templates.h"

#include <utility>

#include "bt/human/OriginalTemplates.h"
#include "bt/human/TemplateNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/scenario/Defaults.h"

namespace bt {

using sim2d::BehaviorType;
using sim2d::Compatibility;
using sim2d::ResolvedHuman;

namespace {

constexpr const char* kRegularTree = "RegularNavTree";

struct Names {
  const char* tree;
  const char* fallback;
  const char* reaction;  // Sequence of the reaction; nullptr = none
};

Names namesOf(BehaviorType type) {
  switch (type) {
    case BehaviorType::Surprised:
      return {"SurprisedNavTree", "SurprisedFallback", "SurNav"};
    case BehaviorType::Scared:
      return {"ScaredNavTree", "ScaredFallback", "ScaNav"};
    case BehaviorType::Curious:
      return {"CuriousNavTree", "CuriousFallback", "CurNav"};
    case BehaviorType::Threatening:
      return {"ThreateningNavTree", "ThreateningFallback", "ThreadNav"};
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
  }
  return {kRegularTree, "RegularNavFallback", nullptr};
}

/// The lasting action of scared, curious and threatening people.
NodeSpec reactionLeaf(const ResolvedHuman& human) {
  NodeSpec leaf = leafNode("BlockRobot", {{"agent_id", "{id}"}, {"time_step", "{dt}"}});
  switch (human.behavior) {
    case BehaviorType::Scared:
      leaf.id = "AvoidRobot";
      setText(leaf.ports, "runaway_vel", shortNumber(human.reactionSpeed));
      setText(leaf.ports, "safe_distance", shortNumber(human.safeDistance));
      break;
    case BehaviorType::Curious:
      leaf.id = "ApproachRobot";
      setText(leaf.ports, "closest_dist", shortNumber(human.stopDistance));
      setText(leaf.ports, "max_vel", shortNumber(human.reactionSpeed));
      break;
    default:
      setText(leaf.ports, "front_dist", shortNumber(human.frontDistance));
  }
  setText(leaf.ports, "duration", shortNumber(human.reactionDuration));
  return leaf;
}

NodeSpec onceAndFail(NodeSpec reaction) {
  NodeSpec once = around("RunOnce", around("ForceFailure", std::move(reaction)));
  once.ports = {{"then_skip", "false"}};
  return once;
}

NodeSpec surpriseTimer(const ResolvedHuman& human) {
  NodeSpec timer =
      leafNode("TimeExpiredCondition", {{"seconds", shortNumber(human.reactionDuration)},
                                        {"ts", "{dt}"},
                                        {"only_once", human.reactionOnce ? "true" : "false"}});
  return around("Inverter", std::move(timer));
}

NodeSpec reactionBlock(const ResolvedHuman& human, const Compatibility& quirks) {
  NodeSpec visible = leafNode(
      "IsRobotVisible", {{"agent_id", "{id}"}, {"distance", shortNumber(human.noticeDistance)}});
  NodeSpec block = branchNode("Sequence", namesOf(human.behavior).reaction, {});
  if (human.behavior == BehaviorType::Surprised) {
    block.children = {std::move(visible), surpriseTimer(human),
                      leafNode("SurprisedNav", {{"agent_id", "{id}"}, {"time_step", "{dt}"}})};
    return block;
  }
  NodeSpec reaction = reactionLeaf(human);
  if (quirks.has(30)) {
    block.children = {around("RunOnce", std::move(visible)),
                      around("RunOnce", std::move(reaction))};
  } else if (human.reactionOnce) {
    block.children = {std::move(visible), onceAndFail(std::move(reaction))};
  } else {
    block.children = {std::move(visible), std::move(reaction)};
  }
  return block;
}

/// To the goals, in order: the last two branches of the regular tree.
std::vector<NodeSpec> navigationNodes() {
  NodeSpec walk =
      branchNode("Sequence", "RegularNavigation",
                 {around("Inverter", leafNode("IsGoalReached", {{"agent_id", "{id}"}})),
                  leafNode("RegularNav", {{"agent_id", "{id}"}, {"time_step", "{dt}"}})});
  return {std::move(walk), leafNode("UpdateGoal", {{"agent_id", "{id}"}})};
}

/// Sequence RegNav: the included tree with the ids handed over.
NodeSpec regularNavCall() {
  NodeSpec call = leafNode("SubTree", {{"id", "{agentid}"}, {"dt", "{timestep}"}});
  call.subTree = "RegularNavTree";
  return branchNode("Sequence", "RegNav",
                    {leafNode("SetBlackboard", {{"output_key", "agentid"}, {"value", "{id}"}}),
                     leafNode("SetBlackboard", {{"output_key", "timestep"}, {"value", "{dt}"}}),
                     std::move(call)});
}

TreeSpec regularTree(std::vector<NodeSpec> first) {
  TreeSpec tree;
  tree.id = kRegularTree;
  tree.root = branchNode("Fallback", "RegularNavFallback", std::move(first));
  for (NodeSpec& node : navigationNodes()) {
    tree.root.children.push_back(std::move(node));
  }
  return tree;
}

std::vector<NodeSpec> goalBlocks(const std::vector<int>& goals, const Compatibility& quirks) {
  if (!goals.empty()) {
    return {setGoalsBlock(goals)};
  }
  if (!quirks.has(32)) {
    return {};
  }
  NodeSpec block = setGoalsBlock({1});  // without the inverter
  NodeSpec only = std::move(block.children.front().children.front());
  block.children = {std::move(only)};
  return {std::move(block)};
}

TreeSpec treeOf(const ResolvedHuman& human, const std::vector<int>& goals,
                const Compatibility& quirks) {
  const Names names = namesOf(human.behavior);
  std::vector<NodeSpec> first = goalBlocks(goals, quirks);
  if (!names.reaction) {
    return regularTree(std::move(first));
  }
  TreeSpec tree;
  tree.id = names.tree;
  tree.root = branchNode("Fallback", names.fallback, std::move(first));
  tree.root.children.push_back(reactionBlock(human, quirks));
  tree.root.children.push_back(regularNavCall());
  return tree;
}

/// The nodes that HuNavSim has, or those of them that are named.
XmlBlock modelBlock(const NodeCatalogue& catalogue, const std::vector<std::string>& ids = {}) {
  NodeCatalogue known;
  for (const NodeManifest& manifest : catalogue.all()) {
    if (ids.empty() && manifest.origin == NodeOrigin::HuNavSim) {
      known.add(manifest);
    }
  }
  for (const std::string& id : ids) {
    if (const NodeManifest* manifest = catalogue.find(id)) {
      known.add(*manifest);
    }
  }
  return modelOf(known);
}

}  // namespace

TreeSpec regularNavTree() {
  return regularTree({});
}

namespace {

/// Without the list of nodes, which takes longer to write than all the rest.
TreeFile makeBareTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                      const Compatibility& quirks) {
  ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, scenario.desktop.seed.value_or(1));
  if (quirks.has(31)) {
    resolved.reactionSpeed = human.maxVel.value_or(2.0);
  }
  TreeFile file;
  file.mainTree = namesOf(resolved.behavior).tree;
  file.includes = {{kRegularNavFile, {}, 0}};
  file.trees = {treeOf(resolved, human.goals, quirks)};
  return file;
}

}  // namespace

TreeFile makeTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                  const NodeCatalogue& catalogue, const Compatibility& quirks) {
  TreeFile file = makeBareTree(scenario, human, quirks);
  file.model = modelBlock(catalogue);
  file.order = {FilePart::Model, FilePart::Include, FilePart::Tree};
  return file;
}

TreeTable makeTable(const sim2d::Scenario& scenario, const sim2d::Human& human,
                    const Compatibility& quirks) {
  TreeFile file = makeBareTree(scenario, human, quirks);
  TreeTable table;
  table.file = treeFileName(scenario.yamlBaseName.value_or("scenario"), human.id);
  table.mainTree = file.mainTree;
  if (!file.find(kRegularTree)) {
    table.entries[kRegularTree] = {regularTree({}), kRegularNavFile};
  }
  for (TreeSpec& tree : file.trees) {
    const std::string id = tree.id;
    table.entries[id] = {std::move(tree), table.file};
  }
  return table;
}

std::string makeTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                         TreeStyle style, const NodeCatalogue& catalogue) {
  if (style == TreeStyle::Corrected) {
    return writeTree(makeTree(scenario, human, catalogue), catalogue);
  }
  TreeFile model;
  model.model = modelBlock(catalogue);
  const std::string modelFile = writeTree(model, catalogue);
  return hasWrapperTrees(scenario) ? wrapperTreeText(human, modelFile)
                                   : panelTreeText(human, modelFile);
}

std::string treeFileName(const std::string& base, int agentId) {
  return base + "__agent_" + std::to_string(agentId) + "_bt.xml";
}

std::string regularNavText(const NodeCatalogue& catalogue) {
  TreeFile file;
  file.mainTree = kRegularTree;
  file.model = modelBlock(catalogue, {"RegularNav", "UpdateGoal", "IsGoalReached"});
  file.trees = {regularTree({})};
  file.order = {FilePart::Model, FilePart::Tree};
  return writeTree(file, catalogue);
}

}  // namespace bt
