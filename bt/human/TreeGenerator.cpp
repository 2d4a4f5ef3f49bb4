#include "bt/human/TreeGenerator.h"

#include <array>
#include <cassert>
#include <charconv>
#include <map>
#include <utility>
#include <vector>

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

/// RunOnce{SetGoal} for each goal; without goals HuNavSim sets goal 1 and omits the inverter.
std::vector<NodeSpec> hunavGoalNodes(const std::vector<int>& goals) {
  return goals.empty()
             ? std::vector<NodeSpec>{parseNodeText("RunOnce>SetGoal agent_id={id} goal_id=1")}
             : setGoalsSequence(goals).children;
}

std::vector<NodeSpec> goalBlocks(const std::vector<int>& goals, const Compatibility& quirks) {
  if (goals.empty() && !quirks.has(32)) {
    return {};
  }
  return {branchNode("Sequence", "SetGoals", hunavGoalNodes(goals))};
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

namespace {

/// The XML of a node as HuNavSim writes it. `close`: end of an element without children.
std::string hunavXml(const NodeSpec& node, const std::string& margin, const std::string& step,
                     const char* close) {
  std::string text = margin + "<" + node.id;
  Attributes attributes = node.ports;
  if (!node.name.empty() || node.isSubTree()) {
    attributes.insert(attributes.begin(), {node.isSubTree() ? "ID" : "name", node.label()});
  }
  for (const Attribute& attribute : attributes) {
    text += " " + attribute.name + "=\"" + attribute.text + "\"";
  }
  if (node.children.empty()) {
    return text + close + "\n";
  }
  text += ">\n";
  for (const NodeSpec& child : node.children) {
    text += hunavXml(child, margin + step, step, close);
  }
  return text + margin + "</" + node.id + ">\n";
}

/// Reacts while the robot is visible and the time has not elapsed.
NodeSpec timedReaction(const std::string& name, const std::string& node) {
  return branchNode(
      "Sequence", name,
      {parseNodeText("IsRobotVisible agent_id={id} distance={dist}"),
       parseNodeText("Inverter>TimeExpiredCondition seconds={duration} ts={dt} only_once={once}"),
       parseNodeText(node)});
}

/// Except for surprise both nodes run once, whether or not the robot is visible, as in HuNavSim's
/// panel.
NodeSpec panelReaction(BehaviorType type) {
  static const std::map<BehaviorType, std::string> kNodes = {
      {BehaviorType::Scared,
       "AvoidRobot agent_id={id} time_step={dt} runaway_vel={maxvel} "
       "safe_distance={safe_distance} duration={duration}"},
      {BehaviorType::Curious,
       "ApproachRobot agent_id={id} time_step={dt} closest_dist={stopdist} max_vel={maxvel} "
       "duration={duration}"},
      {BehaviorType::Threatening,
       "BlockRobot agent_id={id} time_step={dt} front_dist={frontdist} duration={duration}"}};
  const char* const name = kReactions.at(type);
  if (type == BehaviorType::Surprised) {
    return timedReaction(name, "SurprisedNav agent_id={id} time_step={dt}");
  }
  return branchNode("Sequence", name,
                    {parseNodeText("RunOnce>IsRobotVisible agent_id={id} distance={dist}"),
                     parseNodeText("RunOnce>" + kNodes.at(type))});
}

NodeSpec wrapperReaction(BehaviorType type) {
  if (type == BehaviorType::Threatening) {
    NodeSpec reaction = timedReaction(
        "ThreatNav", "ThreateningNav agent_id={id} time_step={dt} goal_dist={frontdist}");
    NodeSpec visible = std::move(reaction.children.front());
    reaction.children.erase(reaction.children.begin());
    reaction.name = "ThreatTimerNav";
    return branchNode("Sequence", "ThreatNav", {std::move(visible), std::move(reaction)});
  }
  static const std::map<BehaviorType, std::string> kNodes = {
      {BehaviorType::Surprised, "SurprisedNav agent_id={id} time_step={dt}"},
      {BehaviorType::Scared,
       "ScaredNav agent_id={id} time_step={dt} runaway_vel={maxvel} "
       "scary_force_factor={forcefactor}"},
      {BehaviorType::Curious,
       "CuriousNav agent_id={id} time_step={dt} stop_distance={stopdist} agent_vel={maxvel}"}};
  return timedReaction(kReactions.at(type), kNodes.at(type));
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

/// Replaces {dist}, {duration} … with the panel's values for this person.
std::string fillPlaceholders(std::string text, const sim2d::Human& human) {
  const sim2d::Behavior& behavior = human.behavior;
  const auto number = [](const std::optional<double>& value, double otherwise) {
    return shortNumber(value.value_or(otherwise));
  };
  replaceAll(text, "{dist}", number(behavior.dist, 5.0));
  replaceAll(text, "{duration}", number(behavior.duration, 40.0));
  replaceAll(text, "{once}", behavior.once.value_or(false) ? "true" : "false");
  replaceAll(text, "{maxvel}", number(human.maxVel, 2.0));
  replaceAll(text, "{forcefactor}", number(behavior.otherForceFactor, 20.0));
  replaceAll(text, "{stopdist}", number(behavior.stopDist, 1.5));
  replaceAll(text, "{frontdist}", number(behavior.frontDist, 1.5));
  replaceAll(text, "{safe_distance}", number(behavior.safeDistance, 5.0));
  return text;
}

/// The element "<TreeNodesModel>…</TreeNodesModel>" of a file.
std::string modelElement(const std::string& file) {
  constexpr const char* kClosing = "</TreeNodesModel>";
  const std::size_t begin = file.find("<TreeNodesModel");
  const std::size_t end = file.find(kClosing);
  if (begin == std::string::npos || end == std::string::npos) {
    return "<TreeNodesModel/>";
  }
  return file.substr(begin, end + std::string(kClosing).size() - begin);
}

std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const bool reacts = kReactions.count(type) > 0;
  const std::string name = reacts ? sim2d::behaviorName(type) : "Regular";
  const std::string margin(12, ' ');
  std::string body = "    <BehaviorTree ID=\"" + name + "NavTree\">\n        <Fallback name=\"" +
                     name + (reacts ? "" : "Nav") + "Fallback\">\n" +
                     hunavXml(branchNode("Sequence", "SetGoals", hunavGoalNodes(human.goals)),
                              margin, "    ", "/>");
  for (const NodeSpec& node : reacts ? std::vector<NodeSpec>{panelReaction(type), regularNavCall()}
                                     : regularNavTree().root.children) {
    body += hunavXml(node, margin, "    ", " />");
  }
  body += "        </Fallback>\n    </BehaviorTree>\n</root>\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root main_tree_to_execute=\"" + name +
         "NavTree\" BTCPP_format=\"4\">\n\n  " + modelElement(modelFile) +
         "\n  <include path=\"BTRegularNav.xml\" />\n\n" + fillPlaceholders(std::move(body), human);
}

std::string wrapperTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const std::string name = sim2d::behaviorName(type);
  const bool reacts = kReactions.count(type) > 0;
  const auto xml = [](const NodeSpec& node, std::size_t margin) {
    return hunavXml(node, std::string(margin, ' '), "  ", "/>");
  };
  std::string body = "\n<include path=\"BTRegularNav.xml\" />\n\n\n";
  if (reacts) {
    body += "<!--<BehaviorTree ID=\"" + name + "NavTree\">-->\n";
  }
  body += "<BehaviorTree ID=\"DefaultTree\">\n  <Fallback name=\"" +
          (reacts ? name + "Fallback" : "MainFallback") + "\">\n" +
          "    <!-- Goal setting Sequence -->\n    <Sequence name=\"SetGoals\">\n";
  for (const NodeSpec& node : hunavGoalNodes(human.goals)) {
    body += xml(node, 8);
  }
  body += "\n    </Sequence>\n";
  const std::vector<NodeSpec> regular = regularNavTree().root.children;
  body += reacts ? xml(wrapperReaction(type), 4) + xml(regularNavCall(), 4)
                 : "    <!-- Navigation loop -->\n" + xml(regular[0], 4) +
                       "    <!-- Update Goal -->\n" + xml(regular[1], 4);
  body += "  </Fallback>\n</BehaviorTree>\n\n\n\n</root>\n\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<root main_tree_to_execute=\"DefaultTree\" BTCPP_format=\"4\">\n  " +
         modelElement(modelFile) + "\n" + fillPlaceholders(std::move(body), human);
}

}  // namespace

std::string hunavTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          const std::string& modelFile) {
  const std::string simulator = scenario.simulator.value_or("");
  const bool isOfWrapper =
      simulator == "Gazebo Classic" || simulator == "Gazebo Fortress" || simulator == "Isaac Sim";
  return isOfWrapper ? wrapperTreeText(human, modelFile) : panelTreeText(human, modelFile);
}

}  // namespace bt
