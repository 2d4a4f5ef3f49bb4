#include "bt/engine/NodeLibrary.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "bt/engine/Ticker.h"

namespace bt {

LeafContext::LeafContext(Ticker& ticker, const TickInput& input, int node)
    : ticker_(&ticker),
      input_(&input),
      ports_(ticker.program().node(node).ports),
      host_(input.host),
      columns_{ticker.program().constants().data(), ticker.program().constants().data(),
               ticker.slots()},
      slots_(ticker.slots()),
      head_(&ticker.program().node(node)) {}

PortState LeafContext::state(int port) const {
  const Value* const value = valueOf(port);
  const PortBinding& binding = ports_[port];
  if (!value) {
    return PortState::Missing;
  }
  if (!convertTo(*value, binding.type)) {
    return PortState::WrongType;
  }
  return binding.isDefault ? PortState::Default : PortState::Given;
}

std::optional<std::string> LeafContext::text(int port) const {
  const Value* const value = valueOf(port);
  return value ? std::optional<std::string>(value->toText()) : std::nullopt;
}

base::NodeStatus LeafContext::before() const {
  return ticker_->storedOf(head_->index);
}

const std::string& LeafContext::path() const {
  return ticker_->program().path(head_->index);
}

const std::string& LeafContext::label() const {
  return ticker_->program().label(head_->index);
}

base::NodeStatus LeafContext::fault(std::string message) {
  return ticker_->fault(head_->index, std::move(message));
}

void* LeafContext::memoryBytes() {
  return ticker_->memoryOf(head_->index);
}

void LeafContext::reportInputFault(int port) {
  const std::string& name =
      ticker_->program().manifest(head_->index).ports[static_cast<std::size_t>(port)].key;
  const Value* const value = valueOf(port);
  ticker_->fault(head_->index, value ? "input '" + name + "' is '" + value->toText() +
                                           "', which does not fit its type"
                                     : "input '" + name + "' is missing");
}

void LeafContext::reportOutputFault(int port, const Value& value) {
  const std::string& name =
      ticker_->program().manifest(head_->index).ports[static_cast<std::size_t>(port)].key;
  ticker_->fault(head_->index, "output '" + name + "' is '" + value.toText() +
                                   "', which does not fit the type of its entry");
}

int ParentContext::childCount() const {
  return ticker().program().node(node()).children;
}

int ParentContext::nodeOf(int child) const {
  assert(child >= 0 && child < childCount());
  int index = node() + 1;
  for (int before = 0; before < child; ++before) {
    index = ticker().program().node(index).end;
  }
  return index;
}

base::NodeStatus ParentContext::tickChild(int child) {
  return ticker().tickNode(nodeOf(child));
}

void ParentContext::resetChild(int child) {
  ticker().resetChild(nodeOf(child));
}

NodeLibrary::NodeLibrary() : catalogue_(builtinNodes()) {}

void NodeLibrary::add(NodeManifest manifest, const NodeFunctions& functions) {
  assert(!manifest.id.empty());
  if (functions.kind == NodeFunctions::Kind::Decorator) {
    manifest.kind = NodeKind::Decorator;
    manifest.minChildren = manifest.maxChildren = 1;
  } else if (functions.kind == NodeFunctions::Kind::Control) {
    manifest.kind = NodeKind::Control;
    manifest.minChildren = std::max(manifest.minChildren, 1);
    manifest.maxChildren = manifest.maxChildren == 0 ? -1 : manifest.maxChildren;
  }
  functions_[manifest.id] = functions;
  catalogue_.add(std::move(manifest));
}

void NodeLibrary::add(const NodeCatalogue& nodes,
                      const std::map<std::string, NodeFunctions>& functions) {
  assert(nodes.all().size() == functions.size());
  for (const NodeManifest& node : nodes.all()) {
    add(node, functions.at(node.id));
  }
}

const NodeFunctions* NodeLibrary::functions(std::string_view id) const {
  const auto place = functions_.find(id);
  return place == functions_.end() ? nullptr : &place->second;
}

NodeLibrary NodeLibrary::withLeafFunctions(StatefulFunctions leaf) const {
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
