#pragma once

#include <string_view>

#include "bt/engine/NodeLibrary.h"
#include "bt/robot/NavigatorHost.h"

namespace bt {

void addAllRobotNodes(NodeLibrary& to);  // written by CMake from the files in nodes/

/// The nodes of BehaviorTree.CPP and those of Nav2: what a navigator tree may use. Its host is a
/// NavigatorHost.
inline NodeLibrary robotNodes() {
  NodeLibrary library;
  addAllRobotNodes(library);
  return library;
}

/// In which of Nav2's branches a node exists, as `sim2d::nav2::isIn` takes it; those of
/// BehaviorTree.CPP in all.
unsigned distrosOfNode(std::string_view id);

inline NavigatorHost& robotOf(const LeafContext& leaf) {
  return leaf.host<NavigatorHost>();
}

/// The path that an input names; 0 when it is missing.
inline PathId pathOf(const LeafContext& leaf, int port) {
  return leaf.get<int>(port).value_or(0);
}

}  // namespace bt
