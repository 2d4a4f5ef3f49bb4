#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"

/// Trees for other programs that run HuNavSim's nodes.
namespace bt {

/// Old numbers -> new ones.
struct Renumbering {
  std::map<int, int> goals, people;
  bool isNothing() const;
};

/// The tree with the numbers of goals and people replaced that stand in it, in ports and in what
/// SetBlackboard and SubTree hand on to them; numbers of nothing become others of nothing where
/// need be, scripts stay. `changed` counts the ports. Byte for byte the same when nothing is to be
/// replaced, else without the layout of the file.
std::string renumbered(const TreeFile& file, const std::string& text, const Renumbering& numbers,
                       const NodeCatalogue& catalogue, int& changed);

/// IDs of the nodes in a file that only we have, each once, in order.
std::vector<std::string> ownNodes(const TreeFile& file, const NodeCatalogue& catalogue);

}  // namespace bt
