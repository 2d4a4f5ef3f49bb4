#pragma once

#include "bt/engine/NodeLibrary.h"

namespace bt {

/// The nodes of BehaviorTree.CPP and all of the folder nodes/: what a person's tree may use.
NodeLibrary humanNodes();

}  // namespace bt
