#include "bt/engine/NodeLibrary.h"

#include <cassert>

namespace bt {

NodeLibrary::NodeLibrary() : catalogue_(builtinNodes()) {}

void NodeLibrary::addNode(NodeManifest manifest, const NodeFunctions& functions) {
  assert(!manifest.id.empty());
  functions_[manifest.id] = functions;
  catalogue_.add(std::move(manifest));
}

const NodeFunctions* NodeLibrary::functions(std::string_view id) const {
  const auto place = functions_.find(id);
  return place == functions_.end() ? nullptr : &place->second;
}

NodeLibrary NodeLibrary::withLeaves(StatefulFunctions leaf) const {
  NodeLibrary scripted = *this;
  for (auto& [id, functions] : scripted.functions_) {
    const bool isLeaf = functions.kind == NodeFunctions::Kind::Synchronous ||
                        functions.kind == NodeFunctions::Kind::Stateful;
    if (isLeaf) {
      functions.isCalledWhenDone = functions.kind == NodeFunctions::Kind::Synchronous;
      functions.kind = NodeFunctions::Kind::Stateful;
      functions.stateful = leaf;
    }
  }
  return scripted;
}

}  // namespace bt
