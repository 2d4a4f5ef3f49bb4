#pragma once

#include <vector>

#include "bt/engine/Program.h"

namespace bt {

/// Whether the structure of a tree proves that a node is never executed, per node. From the results
/// that nodes can have (AlwaysSuccess, AlwaysFailure, Inverter, ForceSuccess, ForceFailure,
/// sequences and fallbacks of them) follows which children a sequence, a Fallback, an IfThenElse, a
/// WhileDoElse, a PipelineSequence or a RecoveryNode never starts. Other nodes, nodes with
/// conditions, and leaves can have any result; ports and scripts are not evaluated. So a node
/// without the mark may be impossible to reach too.
std::vector<bool> unreachableNodes(const Program& program);

}  // namespace bt
