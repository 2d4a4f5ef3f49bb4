#include "bt/human/TreeGenerator.h"

#include <array>
#include <cassert>
#include <charconv>
#include <map>
#include <utility>

#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace bt {

using sim2d::BehaviorType;
using sim2d::Compatibility;
using sim2d::ResolvedHuman;

namespace {

constexpr const char* kRegularTree = "RegularNavTree";

/// Names of the Sequences of the reactions; other behaviours have none.
const std::map<BehaviorType, const char*> kReactions = {{BehaviorType::Surprised, "SurNav"},
                                                        {BehaviorType::Scared, "ScaNav"},
                                                        {BehaviorType::Curious, "CurNav"},
                                                        {BehaviorType::Threatening, "ThreadNav"}};

std::string treeName(BehaviorType type) {
  return kReactions.count(type) > 0 ? std::string(sim2d::behaviorName(type)) + "NavTree"
                                    : kRegularTree;
}

/// The stateful action of scared, curious and threatening people.
NodeSpec reactionLeaf(const ResolvedHuman& human) {
  const std::string duration = " duration=" + shortNumber(human.reactionDuration);
  const std::string who = " agent_id={id} time_step={dt}";
  if (human.behavior == BehaviorType::Scared) {
    return parseNodeText("AvoidRobot" + who + " runaway_vel=" + shortNumber(human.reactionSpeed) +
                         " safe_distance=" + shortNumber(human.safeDistance) + duration);
  }
  if (human.behavior == BehaviorType::Curious) {
    return parseNodeText("ApproachRobot" + who +
                         " closest_dist=" + shortNumber(human.stopDistance) +
                         " max_vel=" + shortNumber(human.reactionSpeed) + duration);
  }
  return parseNodeText("BlockRobot" + who + " front_dist=" + shortNumber(human.frontDistance) +
                       duration);
}

NodeSpec reactionBlock(const ResolvedHuman& human, const Compatibility& quirks) {
  NodeSpec visible =
      parseNodeText("IsRobotVisible agent_id={id} distance=" + shortNumber(human.noticeDistance));
  NodeSpec block = branchNode("Sequence", kReactions.at(human.behavior), {});
  if (human.behavior == BehaviorType::Surprised) {
    const std::string timer =
        "Inverter>TimeExpiredCondition seconds=" + shortNumber(human.reactionDuration) +
        " ts={dt} only_once=";
    block.children = {std::move(visible),
                      parseNodeText(timer + (human.reactionOnce ? "true" : "false")),
                      parseNodeText("SurprisedNav agent_id={id} time_step={dt}")};
    return block;
  }
  NodeSpec reaction = reactionLeaf(human);
  if (quirks.has(30)) {
    block.children = {around("RunOnce", std::move(visible)),
                      around("RunOnce", std::move(reaction))};
  } else if (human.reactionOnce) {
    block.children = {std::move(visible), runOnceAndFail(std::move(reaction))};
  } else {
    block.children = {std::move(visible), std::move(reaction)};
  }
  return block;
}

/// Sequence RegNav: calls the included tree with the ids as arguments.
NodeSpec regularNavCall() {
  NodeSpec call = parseNodeText("SubTree id={agentid} dt={timestep}");
  call.subTree = kRegularTree;
  return branchNode(
      "Sequence", "RegNav",
      {parseNodeText("SetBlackboard output_key=agentid value={id}"),
       parseNodeText("SetBlackboard output_key=timestep value={dt}"), std::move(call)});
}

std::vector<NodeSpec> goalBlocks(const std::vector<int>& goals, const Compatibility& quirks) {
  if (!goals.empty()) {
    return {setGoalsSequence(goals)};
  }
  if (!quirks.has(32)) {
    return {};
  }
  return {branchNode("Sequence", "SetGoals",
                     {parseNodeText("RunOnce>SetGoal agent_id={id} goal_id=1")})};
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

/// The model block of HuNavSim's nodes, or of the given ids.
XmlElement hunavNodesModel(const NodeCatalogue& catalogue,
                           const std::vector<std::string>& ids = {}) {
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

/// The tree without the model block, which takes longer to write than the rest.
TreeFile makeTreeWithoutModel(const sim2d::Scenario& scenario, const sim2d::Human& human,
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
  tree.root.children.push_back(
      branchNode("Sequence", "RegularNavigation",
                 {parseNodeText("Inverter>IsGoalReached agent_id={id}"),
                  parseNodeText("RegularNav agent_id={id} time_step={dt}")}));
  tree.root.children.push_back(parseNodeText("UpdateGoal agent_id={id}"));
  return tree;
}

TreeFile makeTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                  const NodeCatalogue& catalogue, const Compatibility& quirks) {
  TreeFile file = makeTreeWithoutModel(scenario, human, quirks);
  file.model = hunavNodesModel(catalogue);
  file.order = {FilePart::Model, FilePart::Include, FilePart::Tree};
  return file;
}

TreeTable makeGeneratedTable(const sim2d::Scenario& scenario, const sim2d::Human& human,
                             const Compatibility& quirks) {
  TreeFile file = makeTreeWithoutModel(scenario, human, quirks);
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
  model.model = hunavNodesModel(catalogue);
  return hunavTreeText(scenario, human, writeTree(model, catalogue));
}

std::string treeFileName(const std::string& base, int agentId) {
  return base + "__agent_" + std::to_string(agentId) + "_bt.xml";
}

std::string regularNavText(const NodeCatalogue& catalogue) {
  TreeFile file;
  file.mainTree = kRegularTree;
  file.model = hunavNodesModel(catalogue, {"RegularNav", "UpdateGoal", "IsGoalReached"});
  file.trees = {regularNavTree()};
  file.order = {FilePart::Model, FilePart::Tree};
  return writeTree(file, catalogue);
}

NodeSpec leafNode(std::string id, Attributes ports) {
  NodeSpec node;
  node.id = std::move(id);
  node.ports = std::move(ports);
  return node;
}

NodeSpec branchNode(std::string id, std::string name, std::vector<NodeSpec> children) {
  NodeSpec node;
  node.id = std::move(id);
  node.name = std::move(name);
  node.children = std::move(children);
  return node;
}

NodeSpec parseNodeText(const std::string& text) {
  const std::size_t link = text.find('>');
  if (link != std::string::npos) {
    return around(text.substr(0, link), parseNodeText(text.substr(link + 1)));
  }
  const std::vector<std::string> words = base::split(text, ' ');
  NodeSpec node = leafNode(words.front(), {});
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t sign = words[i].find('=');
    assert(sign != std::string::npos);
    node.ports.push_back({words[i].substr(0, sign), words[i].substr(sign + 1)});
  }
  return node;
}

NodeSpec around(const std::string& decorator, NodeSpec child) {
  NodeSpec node = parseNodeText(decorator);
  node.children.push_back(std::move(child));
  return node;
}

NodeSpec runOnceAndFail(NodeSpec child) {
  return around("RunOnce then_skip=false", around("ForceFailure", std::move(child)));
}

std::string shortNumber(double value) {
  std::array<char, 32> text{};
  const std::to_chars_result end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

NodeSpec setGoalsSequence(const std::vector<int>& goals) {
  NodeSpec block = branchNode("Sequence", "SetGoals", {});
  for (const int goal : goals) {
    block.children.push_back(
        parseNodeText("RunOnce>SetGoal agent_id={id} goal_id=" + std::to_string(goal)));
  }
  if (!block.children.empty()) {  // fails in the first tick, so that the person walks immediately
    block.children.back() = around("Inverter", std::move(block.children.back()));
  }
  return block;
}

}  // namespace bt
