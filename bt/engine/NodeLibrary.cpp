#include "bt/engine/NodeLibrary.h"

#include <algorithm>
#include <cassert>

namespace bt {

NodeLibrary::NodeLibrary() : catalogue_(builtinNodes()) {}

void NodeLibrary::add(NodeManifest manifest, NodeFunctions functions) {
  assert(!manifest.id.empty());
  functions_[manifest.id] = functions;
  catalogue_.add(std::move(manifest));
}

void NodeLibrary::addCondition(NodeManifest manifest, LeafFunction tick, int memoryBytes) {
  manifest.kind = NodeKind::Condition;
  NodeFunctions functions;
  functions.tick = tick;
  functions.memoryBytes = memoryBytes;
  add(std::move(manifest), functions);
}

void NodeLibrary::addAction(NodeManifest manifest, LeafFunction tick, int memoryBytes) {
  manifest.kind = NodeKind::Action;
  NodeFunctions functions;
  functions.tick = tick;
  functions.memoryBytes = memoryBytes;
  add(std::move(manifest), functions);
}

void NodeLibrary::addStateful(NodeManifest manifest, StatefulFunctions stateful, int memoryBytes) {
  if (manifest.kind != NodeKind::Condition) {
    manifest.kind = NodeKind::Action;
  }
  NodeFunctions functions;
  functions.kind = NodeFunctions::Kind::Stateful;
  functions.stateful = stateful;
  functions.memoryBytes = memoryBytes;
  add(std::move(manifest), functions);
}

void NodeLibrary::addDecorator(NodeManifest manifest, DecoratorFunctions decorator,
                               int memoryBytes) {
  manifest.kind = NodeKind::Decorator;
  manifest.minChildren = 1;
  manifest.maxChildren = 1;
  NodeFunctions functions;
  functions.kind = NodeFunctions::Kind::Decorator;
  functions.decorator = decorator;
  functions.memoryBytes = memoryBytes;
  add(std::move(manifest), functions);
}

void NodeLibrary::addControl(NodeManifest manifest, ControlFunctions control, int memoryBytes) {
  manifest.kind = NodeKind::Control;
  manifest.minChildren = std::max(manifest.minChildren, 1);
  if (manifest.maxChildren == 0) {
    manifest.maxChildren = -1;
  }
  NodeFunctions functions;
  functions.kind = NodeFunctions::Kind::Control;
  functions.control = control;
  functions.memoryBytes = memoryBytes;
  add(std::move(manifest), functions);
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
