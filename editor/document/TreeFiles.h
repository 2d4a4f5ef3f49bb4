#pragma once

#include <string>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// All nodes that trees of people may have.
const bt::NodeCatalogue& treeCatalogue();

/// Folder for the trees of a scenario file: ../behavior_trees when its own is called scenarios.
std::string treeFolderOf(const std::string& scenarioPath);
/// "cafe__agent_3_bt.xml"
std::string treeFileName(const std::string& base, int humanId);

/// XML of the tree that the behaviour and goals of a person make.
std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human);
/// The text means the same as one that a generator (ours or the original's) made.
bool isGeneratedTree(const std::string& xml, const sim2d::Scenario& scenario,
                     const sim2d::Human& human);
/// The fixed trees that generated ones include.
base::Diagnostics writeIncludedTrees(const std::string& folder);

}  // namespace editor
