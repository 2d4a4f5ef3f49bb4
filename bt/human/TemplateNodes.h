#pragma once

#include <string>
#include <vector>

#include "bt/tree/TreeSpec.h"
#include "sim2d/scenario/Scenario.h"

/// Building trees in code, and as texts of HuNavSim.
namespace bt {

NodeSpec leafNode(std::string id, Attributes ports);
/// "IsRobotClose agent_id={id} threshold=2"; "A>B" = B within the decorator A.
NodeSpec nodeFrom(const std::string& text);
NodeSpec branchNode(std::string id, std::string name, std::vector<NodeSpec> children);
NodeSpec around(const std::string& decorator, NodeSpec child);
/// Runs through one time, and is out of the way after: RunOnce{ForceFailure{child}}.
NodeSpec onceAndFail(NodeSpec child);

/// Up to six significant digits, as "%g" prints them: 40 -> "40", 1.23456789 -> "1.23457".
std::string shortNumber(double value);

/// The person's tree as HuNavSim 2.0 writes it. Scenarios of its wrappers for Gazebo Classic,
/// Gazebo Fortress and Isaac Sim have the layout of the trees that lie beside them (main tree
/// DefaultTree, reactions with a timer; from the end of the model block on equal to them byte for
/// byte), others that of the newest panel. `modelFile`: text of a file that holds a TreeNodesModel
/// element.
std::string originalTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                             const std::string& modelFile);

/// Sequence SetGoals: appends the goals in the first tick and fails then, is skipped later.
NodeSpec setGoalsBlock(const std::vector<int>& goals);

}  // namespace bt
