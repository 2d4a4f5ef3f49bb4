#pragma once

#include <string>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// Building trees in code.
namespace bt {

NodeSpec leafNode(std::string id, Attributes ports);
NodeSpec branchNode(std::string id, std::string name, std::vector<NodeSpec> children);
NodeSpec around(std::string decorator, NodeSpec child);  // a decorator without ports

/// Up to six significant digits, as "%g" prints them: 40 -> "40", 1.23456789 -> "1.23457".
std::string shortNumber(double value);

/// Sequence SetGoals: appends the goals in the first tick and fails then, is skipped later.
NodeSpec setGoalsBlock(const std::vector<int>& goals);

}  // namespace bt
