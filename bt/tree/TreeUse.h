#pragma once

#include "bt/tree/TreeSpec.h"

namespace bt {

/// Trees of people and navigator trees of robots have the same file format but different nodes.
enum class TreeUse { Unknown, Person, Navigator };

/// What most nodes of the file are for; its includes are not read. Unknown: neither, or both
/// equally.
TreeUse treeUse(const TreeFile& file);

/// The only problem to report about a file that is for something else than `wanted`; none if it is
/// not.
std::optional<base::Diagnostic> wrongTreeUse(const TreeFile& file, TreeUse wanted);

}  // namespace bt
