#pragma once

#include <string>

#include "bt/tree/TreeSpec.h"

/// Nodes of BehaviorTree.CPP 3 as their counterparts of version 4.
namespace bt {

/// Whether the name means another node (or none) since version 4.
bool isVersion3Name(const std::string& id);

/// Converts the node itself, not its children. Says what was changed.
void convertFromVersion3(NodeSpec& node, const std::string& fileName, base::Diagnostics& notes);

}  // namespace bt
