#include "bt/human/Templates.h"

#include <map>
#include <utility>

#include "bt/human/TemplateNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/scenario/Defaults.h"

namespace bt {

using sim2d::BehaviorType;
using sim2d::Compatibility;
using sim2d::ResolvedHuman;

namespace {

constexpr const char* kRegularTree = "RegularNavTree";

/// Names of the Sequences with the reactions; the others have none.
const std::map<BehaviorType, const char*> kReactions = {{BehaviorType::Surprised, "SurNav"},
                                                        {BehaviorType::Scared, "ScaNav"},
                                                        {BehaviorType::Curious, "CurNav"},
                                                        {BehaviorType::Threatening, "ThreadNav"}};

std::string treeName(BehaviorType type) {
  return kReactions.count(type) > 0 ? std::string(sim2d::behaviorName(type)) + "NavTree"
                                    : kRegularTree;
}

/// The lasting action of scared, curious and threatening people.
NodeSpec reactionLeaf(const ResolvedHuman& human) {
  const std::string duration = " duration=" + shortNumber(human.reactionDuration);
  const std::string who = " agent_id={id} time_step={dt}";
  if (human.behavior == BehaviorType::Scared) {
    return nodeFrom("AvoidRobot" + who + " runaway_vel=" + shortNumber(human.reactionSpeed) +
                    " safe_distance=" + shortNumber(human.safeDistance) + duration);
  }
  if (human.behavior == BehaviorType::Curious) {
    return nodeFrom("ApproachRobot" + who + " closest_dist=" + shortNumber(human.stopDistance) +
                    " max_vel=" + shortNumber(human.reactionSpeed) + duration);
  }
  return nodeFrom("BlockRobot" + who + " front_dist=" + shortNumber(human.frontDistance) +
                  duration);
}

NodeSpec reactionBlock(const ResolvedHuman& human, const Compatibility& quirks) {
  NodeSpec visible =
      nodeFrom("IsRobotVisible agent_id={id} distance=" + shortNumber(human.noticeDistance));
  NodeSpec block = branchNode("Sequence", kReactions.at(human.behavior), {});
  if (human.behavior == BehaviorType::Surprised) {
    const std::string timer =
        "Inverter>TimeExpiredCondition seconds=" + shortNumber(human.reactionDuration) +
        " ts={dt} only_once=";
    block.children = {std::move(visible), nodeFrom(timer + (human.reactionOnce ? "true" : "false")),
                      nodeFrom("SurprisedNav agent_id={id} time_step={dt}")};
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

/// Sequence RegNav: the included tree with the ids handed over.
NodeSpec regularNavCall() {
  NodeSpec call = nodeFrom("SubTree id={agentid} dt={timestep}");
  call.subTree = kRegularTree;
  return branchNode("Sequence", "RegNav",
                    {nodeFrom("SetBlackboard output_key=agentid value={id}"),
                     nodeFrom("SetBlackboard output_key=timestep value={dt}"), std::move(call)});
}

std::vector<NodeSpec> goalBlocks(const std::vector<int>& goals, const Compatibility& quirks) {
  if (!goals.empty()) {
    return {setGoalsBlock(goals)};
  }
  if (!quirks.has(32)) {
    return {};
  }
  return {
      branchNode("Sequence", "SetGoals", {nodeFrom("RunOnce>SetGoal agent_id={id} goal_id=1")})};
}

TreeSpec treeOf(const ResolvedHuman& human, const std::vector<int>& goals,
                const Compatibility& quirks) {
  std::vector<NodeSpec> first = goalBlocks(goals, quirks);
  if (kReactions.count(human.behavior) == 0) {
    return regularNavTree(std::move(first));
  }
  TreeSpec tree;
  tree.id = treeName(human.behavior);
  tree.root = branchNode("Fallback", std::string(sim2d::behaviorName(human.behavior)) + "Fallback",
                         std::move(first));
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

/// Without the list of nodes, which takes longer to write than all the rest.
TreeFile makeBareTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                      const Compatibility& quirks) {
  ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, scenario.desktop.seed.value_or(1));
  if (quirks.has(31)) {
    resolved.reactionSpeed = human.maxVel.value_or(2.0);
  }
  TreeFile file;
  file.mainTree = treeName(resolved.behavior);
  file.includes = {{kRegularNavFile, {}, 0}};
  file.trees = {treeOf(resolved, human.goals, quirks)};
  return file;
}

}  // namespace

TreeSpec regularNavTree(std::vector<NodeSpec> first) {
  TreeSpec tree;
  tree.id = kRegularTree;
  tree.root = branchNode("Fallback", "RegularNavFallback", std::move(first));
  tree.root.children.push_back(branchNode("Sequence", "RegularNavigation",
                                          {nodeFrom("Inverter>IsGoalReached agent_id={id}"),
                                           nodeFrom("RegularNav agent_id={id} time_step={dt}")}));
  tree.root.children.push_back(nodeFrom("UpdateGoal agent_id={id}"));
  return tree;
}

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
    table.entries[kRegularTree] = {regularNavTree(), kRegularNavFile};
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
  return originalTreeText(scenario, human, writeTree(model, catalogue));
}

std::string treeFileName(const std::string& base, int agentId) {
  return base + "__agent_" + std::to_string(agentId) + "_bt.xml";
}

std::string regularNavText(const NodeCatalogue& catalogue) {
  TreeFile file;
  file.mainTree = kRegularTree;
  file.model = modelBlock(catalogue, {"RegularNav", "UpdateGoal", "IsGoalReached"});
  file.trees = {regularNavTree()};
  file.order = {FilePart::Model, FilePart::Tree};
  return writeTree(file, catalogue);
}

}  // namespace bt
