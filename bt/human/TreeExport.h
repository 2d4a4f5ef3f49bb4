#pragma once

#include <map>
#include <string>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"

/// Export of trees to other programs that run HuNavSim's nodes.
namespace bt {

/// Maps old numbers to new ones.
struct Renumbering {
  std::map<int, int> goals, people;
  bool isIdentity() const;
};

/// Replaces constant numbers of goals and people in ports, and in SetBlackboard and SubTree values
/// that reach such ports. A number without meaning is mapped to another unused number where it
/// would collide. Scripts are not changed. `changed` counts the ports. The text is returned
/// unchanged if nothing is replaced, otherwise without the layout of the file.
std::string renumbered(const TreeFile& file, const std::string& text, const Renumbering& numbers,
                       const NodeCatalogue& catalogue, int& changed);

/// IDs of the nodes in a file that only this program supports, unique, in order.
std::vector<std::string> desktopOnlyNodes(const TreeFile& file, const NodeCatalogue& catalogue);

}  // namespace bt
