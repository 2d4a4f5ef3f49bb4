#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/human/Blocks.h"

/// The nodes of the blocks, with "$key" where the value of a parameter goes. Private to the folder.
namespace bt {

struct BlockPattern {
  BlockKind kind;
  std::map<std::string, std::vector<std::string>> nodes;  // by mode; "" when there is none

  /// The children of the Sequence. `people`: ids for the lines that stand once per person.
  std::vector<NodeSpec> children(const std::string& mode,
                                 const std::vector<std::string>& people) const;
};
const std::vector<BlockPattern>& blockPatterns();
const BlockPattern* blockPattern(const std::string& id);

}  // namespace bt
