#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "bt/engine/LeafContext.h"
#include "bt/tree/NodeCatalogue.h"

/// The nodes that a tree may be built of: those of BehaviorTree.CPP, which the engine runs itself,
/// and the leaves, decorators and controls that a host adds as plain functions.
///
///   constexpr const char* kNodes = R"(
///   Condition IsAlone|Perception|Nobody else is near.
///   agent_id int needed|Whose.
///   threshold length default 1.0|Near.
///   )";
///   to.addCondition(*nodesOf(kNodes, NodeOrigin::Ours).find("IsAlone"), [](LeafContext& leaf) {
///     const int agent = leaf.require<int>(0);
///     const double threshold = leaf.require<double>(1);
///     return leaf.host<Host>().distanceToNext(agent) > threshold ? base::NodeStatus::Success
///                                                                : base::NodeStatus::Failure;
///   });
///
///   struct WaitMemory { std::int64_t startStep; };
///   to.addStateful<WaitMemory>(m, {
///     [](LeafContext& leaf) {                          // onStart: status was IDLE
///       leaf.memory<WaitMemory>().startStep = leaf.step();
///       return base::NodeStatus::Running;
///     },
///     [](LeafContext& leaf) {                          // onRunning
///       return leaf.hasElapsed(leaf.memory<WaitMemory>().startStep, leaf.require<double>(1))
///                  ? base::NodeStatus::Success : base::NodeStatus::Running;
///     },
///     [](LeafContext& leaf) { leaf.host<Host>().resume(); }});  // onHalted; may be left out
///
/// Leaves must be pure functions of context and host: no static variables, no clocks.
namespace bt {

using LeafFunction = base::NodeStatus (*)(LeafContext&);
using HaltFunction = void (*)(LeafContext&);
using ParentFunction = base::NodeStatus (*)(ParentContext&);
using ParentHaltFunction = void (*)(ParentContext&);

struct StatefulFunctions {
  LeafFunction onStart = nullptr;
  LeafFunction onRunning = nullptr;
  HaltFunction onHalted = nullptr;  // halted while RUNNING
};

/// Of a decorator or control: `tick` runs children through the context. A decorator's child that is
/// done is reset afterwards by the engine. A control counts as RUNNING meanwhile; unless it returns
/// RUNNING all children are halted and reset. On a halt while RUNNING the children are halted
/// first, then `onHalted` is called.
struct ParentFunctions {
  ParentFunction tick = nullptr;
  ParentHaltFunction onHalted = nullptr;
};

/// How one added node is run.
struct NodeFunctions {
  enum class Kind : unsigned char { Synchronous, Stateful, Decorator, Control };
  Kind kind = Kind::Synchronous;
  LeafFunction tick = nullptr;  // Synchronous: must return SUCCESS or FAILURE
  StatefulFunctions stateful = {};
  ParentFunctions parent = {};
  bool isCalledWhenDone = false;  // Stateful: started anew although its last result still stands
  int memoryBytes = 0;            // per node and agent
};

class NodeLibrary {
  struct NoMemory {};

 public:
  NodeLibrary();  // the nodes of BehaviorTree.CPP are in it

  /// Kind, and the number of children of a decorator, are set here; everything else is taken from
  /// the manifest. A control has one child at least, as many as it likes where the manifest does
  /// not say. A node of the same id is replaced.
  /// `Memory`: what the node keeps per agent, see LeafContext::memory().
  template <class Memory = NoMemory>
  void addCondition(NodeManifest manifest, LeafFunction tick) {
    manifest.kind = NodeKind::Condition;
    add<Memory>(std::move(manifest), {NodeFunctions::Kind::Synchronous, tick});
  }
  template <class Memory = NoMemory>
  void addAction(NodeManifest manifest, LeafFunction tick) {
    manifest.kind = NodeKind::Action;
    add<Memory>(std::move(manifest), {NodeFunctions::Kind::Synchronous, tick});
  }
  /// A stateful action, or a stateful condition when manifest.kind says so.
  template <class Memory = NoMemory>
  void addStateful(NodeManifest manifest, StatefulFunctions functions) {
    const bool isCondition = manifest.kind == NodeKind::Condition;
    manifest.kind = isCondition ? NodeKind::Condition : NodeKind::Action;
    add<Memory>(std::move(manifest), {NodeFunctions::Kind::Stateful, nullptr, functions});
  }
  /// A leaf that never lasts and is called at every tick, like a synchronous one, but keeps its
  /// status: LeafContext::before() is IDLE when it was halted or reset since its last call.
  template <class Memory = NoMemory>
  void addRemembering(NodeManifest manifest, LeafFunction tick) {
    NodeFunctions functions{NodeFunctions::Kind::Stateful, nullptr, {tick, tick}};
    functions.isCalledWhenDone = true;
    add<Memory>(std::move(manifest), functions);
  }
  template <class Memory = NoMemory>
  void addDecorator(NodeManifest manifest, ParentFunctions functions) {
    manifest.kind = NodeKind::Decorator;
    manifest.minChildren = 1;
    manifest.maxChildren = 1;
    add<Memory>(std::move(manifest), {NodeFunctions::Kind::Decorator, nullptr, {}, functions});
  }
  template <class Memory = NoMemory>
  void addControl(NodeManifest manifest, ParentFunctions functions) {
    manifest.kind = NodeKind::Control;
    manifest.minChildren = std::max(manifest.minChildren, 1);
    manifest.maxChildren = manifest.maxChildren == 0 ? -1 : manifest.maxChildren;
    add<Memory>(std::move(manifest), {NodeFunctions::Kind::Control, nullptr, {}, functions});
  }

  const NodeCatalogue& catalogue() const { return catalogue_; }
  /// nullptr = unknown, or run by the engine itself.
  const NodeFunctions* functions(std::string_view id) const;

  /// The same nodes and ports, but every leaf that was added is run by `leaf` (which may return
  /// any status but IDLE and SKIPPED): for playing a tree against a script. Leaves that were
  /// synchronous are still called whenever they are ticked.
  NodeLibrary withLeaves(StatefulFunctions leaf) const;

 private:
  template <class Memory>
  void add(NodeManifest manifest, NodeFunctions functions) {
    static_assert(std::is_trivially_copyable_v<Memory> && alignof(Memory) <= 8);
    functions.memoryBytes = std::is_same_v<Memory, NoMemory> ? 0 : static_cast<int>(sizeof(Memory));
    addNode(std::move(manifest), functions);
  }
  void addNode(NodeManifest manifest, const NodeFunctions& functions);

  NodeCatalogue catalogue_;
  std::map<std::string, NodeFunctions, std::less<>> functions_;
};

}  // namespace bt
