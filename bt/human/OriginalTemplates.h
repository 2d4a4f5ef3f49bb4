#pragma once

#include <string>

#include "sim2d/scenario/Scenario.h"

/// Trees as HuNavSim 2.0 writes them. `modelFile`: text of a file that holds a TreeNodesModel
/// element.
namespace bt {

/// The layout of the newest panel: model block, include, template with its placeholders replaced.
std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile);

/// The simulator of the scenario is one of HuNavSim's wrappers for Gazebo Classic, Gazebo Fortress
/// and Isaac Sim; its trees are written in their layout.
bool hasWrapperTrees(const sim2d::Scenario& scenario);

/// The layout of the trees that lie beside those scenarios: main tree DefaultTree, reactions with a
/// timer. From the end of the model block on equal to them byte for byte.
std::string wrapperTreeText(const sim2d::Human& human, const std::string& modelFile);

}  // namespace bt
