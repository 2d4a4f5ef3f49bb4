#pragma once

#include "bt/engine/NodeLibrary.h"

namespace bt {

void addAllHumanNodes(NodeLibrary& to);  // written by CMake from the files in nodes/

/// The nodes of BehaviorTree.CPP and all of the folder nodes/: what a person's tree may use.
inline NodeLibrary humanNodes() {
  NodeLibrary library;
  addAllHumanNodes(library);
  return library;
}

}  // namespace bt
