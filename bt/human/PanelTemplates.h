#pragma once

#include <string>

#include "sim2d/scenario/Scenario.h"

/// The layout that the newest panel of HuNavSim 2.0 writes: model block, include, template with its
/// placeholders replaced.
namespace bt {

/// `modelFile`: text of a file that holds a TreeNodesModel element.
std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile);

/// What the panel puts for {dist}, {duration} … of this person; "{GOAL_SEQUENCE}" too.
std::string fillPlaceholders(std::string text, const sim2d::Human& human);
/// "<TreeNodesModel>…</TreeNodesModel>" of a file.
std::string modelElement(const std::string& file);

}  // namespace bt
