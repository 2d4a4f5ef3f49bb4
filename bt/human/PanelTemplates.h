#pragma once

#include <string>

#include "sim2d/scenario/Scenario.h"

/// The layout that the panel of HuNavSim 2.0 writes: model block, include, template with its
/// placeholders replaced.
namespace bt {

/// `modelFile`: text of a file that holds a TreeNodesModel element.
std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile);

}  // namespace bt
