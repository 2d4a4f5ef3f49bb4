#pragma once

#include <string>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/Compatibility.h"

/// The tree that a person has when nobody wrote one: goals in order, a reaction to the robot by
/// behaviour, regular navigation.
namespace bt {

enum class TreeStyle {
  Corrected,  // reacts while the robot is visible; parameters resolved; loads in HuNavSim too
  Hunav2      // as HuNavSim 2.0 has them, quirks included: the wrapper's layout for its simulator,
              // else that of the newest panel
};

/// In the corrected style. The numbers of the reaction are the resolved ones of the scenario's
/// seed, with six significant digits. Of the quirks count.
TreeFile makeTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                  const NodeCatalogue& catalogue, const sim2d::Compatibility& quirks = {});
/// The same with the trees of its include, ready to be compiled.
TreeTable makeTable(const sim2d::Scenario& scenario, const sim2d::Human& human,
                    const sim2d::Compatibility& quirks = {});
/// The text of the file in either style.
std::string makeTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                         TreeStyle style, const NodeCatalogue& catalogue);

/// "<base>__agent_<id>_bt.xml".
std::string treeFileName(const std::string& base, int agentId);
/// Name and text of the file that every generated tree includes; it lies beside them.
constexpr const char* kRegularNavFile = "BTRegularNav.xml";
/// What comes first, then to the goals, in order.
TreeSpec regularNavTree(std::vector<NodeSpec> first = {});
std::string regularNavText(const NodeCatalogue& catalogue);

}  // namespace bt
