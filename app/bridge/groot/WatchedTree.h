#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bt/tree/TreeSpec.h"

namespace groot {

/// A tree as Groot2 is told of it: each SubTree in its place as a tree of its own, every node with
/// a number `_uid`, 1 for the first and on in the order of `bt::Program`.
struct WatchedTree {
  struct Part {
    std::string fullPath;  // "" = the main tree; "walk", "walk/Greet::7": names of SubTrees
    std::string prefix;    // of its entries on the blackboard, "" or "Main/walk/"
    std::string treeId;
  };
  std::string xml;
  std::vector<Part> parts;  // the main tree first
  /// Keys of SubTrees that are entries of their callers, and those entries: {"Main/walk/x", "y"}.
  std::vector<std::pair<std::string, std::string>> aliases;
  int nodes = 0;
};

/// `table`: can be compiled (`bt::compile`).
WatchedTree watchedTree(const bt::TreeTable& table);

}  // namespace groot
