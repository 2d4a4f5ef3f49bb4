#pragma once

#include <string>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/Compatibility.h"

/// Generates the tree of a person who has no custom one: goals in order, the reaction to the robot
/// according to the behaviour, regular navigation.
namespace bt {

enum class TreeStyle {
  Corrected,  // reacts while the robot is visible; resolved parameters; also loads in HuNavSim
  Hunav2      // as in HuNavSim 2.0 with its quirks: layout of the wrapper of its simulator,
              // otherwise of the newest panel
};

/// Generates the corrected style. Reaction parameters are resolved with the scenario's seed and
/// have six significant digits. The quirks are applied.
TreeFile makeTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                  const NodeCatalogue& catalogue, const sim2d::Compatibility& quirks = {});
/// The same with its includes resolved, ready to compile.
TreeTable makeGeneratedTable(const sim2d::Scenario& scenario, const sim2d::Human& human,
                             const sim2d::Compatibility& quirks = {});
/// The file text in either style.
std::string makeTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                         TreeStyle style, const NodeCatalogue& catalogue);

/// "<base>__agent_<id>_bt.xml".
std::string treeFileName(const std::string& base, int agentId);
/// Name of the file that every generated tree includes from its own folder.
constexpr const char* kRegularNavFile = "BTRegularNav.xml";
/// Fallback of `first`, then walking to the goals in order.
TreeSpec regularNavTree(std::vector<NodeSpec> first = {});
std::string regularNavText(const NodeCatalogue& catalogue);

/// Functions that build trees in code and as HuNavSim's XML text.

NodeSpec leafNode(std::string id, Attributes ports);
/// "IsRobotClose agent_id={id} threshold=2"; "A>B": B inside the decorator A.
NodeSpec parseNodeText(const std::string& text);
NodeSpec branchNode(std::string id, std::string name, std::vector<NodeSpec> children);
NodeSpec around(const std::string& decorator, NodeSpec child);
/// RunOnce{ForceFailure{child}}: runs once and does not block later branches.
NodeSpec runOnceAndFail(NodeSpec child);

/// Up to six significant digits, like "%g": 40 -> "40", 1.23456789 -> "1.23457".
std::string shortNumber(double value);

/// The person's tree as HuNavSim 2.0 writes it. Scenarios for the wrappers of Gazebo Classic,
/// Gazebo Fortress and Isaac Sim use the layout of the trees shipped with them (main tree
/// DefaultTree, reactions with a timer; byte-identical from the end of the model block on); others
/// use the layout of the newest panel. `modelFile`: text of a file with a TreeNodesModel element.
std::string hunavTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          const std::string& modelFile);

/// Sequence SetGoals: appends the goals and fails in the first tick, is skipped afterwards.
NodeSpec setGoalsSequence(const std::vector<int>& goals);

}  // namespace bt
