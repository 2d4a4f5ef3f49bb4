#pragma once

#include <string>

#include "sim2d/scenario/Scenario.h"

/// The layout of the trees that lie beside the scenarios of HuNavSim's wrappers for Gazebo Classic,
/// Gazebo Fortress and Isaac Sim: main tree DefaultTree, reactions with a timer. From the end of
/// the model block on equal to them byte for byte.
namespace bt {

/// The simulator of the scenario is one of these; its trees are written in this layout.
bool hasWrapperTrees(const sim2d::Scenario& scenario);

/// `modelFile`: text of a file that holds a TreeNodesModel element.
std::string wrapperTreeText(const sim2d::Human& human, const std::string& modelFile);

}  // namespace bt
