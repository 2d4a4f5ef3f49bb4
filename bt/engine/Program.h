#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt/engine/NodeLibrary.h"
#include "bt/engine/Script.h"
#include "bt/engine/Value.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/base/Result.h"

/// A tree compiled once and shared by all agents that run it: flat, parents before children,
/// SubTrees put in place, ports bound to constants and slots. Immutable, so any number of threads
/// may read it.
namespace bt {

constexpr int kMaxProgramNodes = 200000;                     // after all SubTrees are put in place
constexpr int kMaxProgramDepth = 2000;                       // idem
constexpr std::size_t kMaxPathBytes = std::size_t{1} << 28;  // of all paths together

// What `detail` of a node says when it is not the number of a script, slot or function.
constexpr int kMissing = -1;
constexpr int kEmptyScript = -2;
constexpr int kNobodysEntry = -3;     // no node uses that entry
constexpr int kFirstKeyInEntry = -4;  // this and below: the name of the entry is in an entry

class Ticker;
/// Runs one node: what is special to its kind, without conditions and book-keeping.
using NodeRunner = base::NodeStatus (*)(Ticker& ticker, int node);
/// Forgets what a node and its children were at.
using NodeHalter = void (*)(Ticker& ticker, int node);

/// An entry that the host writes, known before the tree is loaded.
struct HostEntry {
  std::string key;
  PortType type = PortType::Any;
};

struct CompileOptions {
  std::string mainTree;  // empty = as the file says
  std::vector<HostEntry> hostEntries = {{"id", PortType::Int}, {"dt", PortType::Double}};
  bool notesOnOriginal = false;  // also where BehaviorTree.CPP 4.10 treats the file differently
};

class Program {
 public:
  Program() = default;
  Program(const Program&) = delete;  // nodes point into it
  Program& operator=(const Program&) = delete;
  Program(Program&&) = delete;
  Program& operator=(Program&&) = delete;
  ~Program() = default;

  struct alignas(64) Node : NodeHead {  // a cache line
    bool isInstant = false;             // always done within the tick, see Instants.cpp
    bool hasOnlyInstants = false;       // all children are: none keeps a status
    bool hasOneChild = false;           // a decorator or SubTree
    bool isStateful = false;            // a leaf of the library that may last
    std::int32_t end = 0;  // first node behind the children; the first child is self + 1
    std::int32_t children = 0;
    std::int32_t memory = 0;         // offset of its bytes in the agent's memory
    std::int32_t conditions = -1;    // in conditions(); -1 = none
    std::int32_t detail = kMissing;  // functions of the library, script or slot, or as above
    LeafFunction tick = nullptr;     // of a synchronous leaf without conditions
    NodeRunner run = nullptr;
    NodeHalter halt = nullptr;  // null: its children are all that is to be halted
  };
  /// Scripts of the pre- and post-conditions, in the order of kConditionNames; -1 = none.
  using Conditions = std::array<int, kConditionNames.size()>;
  enum Condition { FailureIf, SuccessIf, SkipIf, While, OnSuccess, OnFailure, Post, OnHalted };
  /// An entry of the blackboard, for lists.
  struct Entry {
    std::string key;  // "id"; in a SubTree with its path in front: "RegNav/RegularNavTree/x"
    int slot = -1;
  };
  /// What the keys of one blackboard mean.
  struct Scope {
    int parent = -1;
    bool autoRemap = false;
    std::map<std::string, int, std::less<>> slots;           // that nodes use
    std::map<std::string, std::string, std::less<>> remaps;  // keys of the parent
    std::vector<int> own;                                    // slots that are not the parent's
  };
  /// A key that stands in an entry, of a node in that scope.
  struct KeyInEntry {
    int slot = -1;
    int scope = 0;
  };

  int nodeCount() const { return static_cast<int>(nodes_.size()); }
  const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  /// Names from the root, "MainFallback/SetGoals/RunOnce[2]/SetGoal"; one per node. Shared, so a
  /// recorder can keep them without the program.
  const std::shared_ptr<const std::vector<std::string>>& paths() const { return paths_; }
  const std::string& path(int node) const { return (*paths_)[static_cast<std::size_t>(node)]; }
  const std::string& label(int node) const { return origin(node).label; }  // name, else ID
  const NodeManifest& manifest(int node) const {
    return manifests_[static_cast<std::size_t>(origin(node).manifest)];
  }
  /// Where the node stands in the file, for an editor: tree, line.
  const std::string& treeOf(int node) const { return origin(node).tree; }
  int lineOf(int node) const { return origin(node).line; }

  /// Slot of an entry of the root blackboard; -1 = no node uses it.
  int findSlot(std::string_view key) const {
    const auto place = std::find_if(entries_.begin(), entries_.end(),
                                    [key](const Entry& entry) { return entry.key == key; });
    return place == entries_.end() ? -1 : place->slot;
  }
  /// Slot of CompileOptions::hostEntries[index]; always there.
  int hostSlot(int index) const { return hostSlots_[static_cast<std::size_t>(index)]; }
  const std::vector<Entry>& entries() const { return entries_; }  // all scopes, root first
  const std::string& keyOf(int slot) const { return entries_[static_cast<std::size_t>(slot)].key; }
  /// Keys of SubTrees that are mapped to entries of their callers, named as those of entries().
  const std::vector<Entry>& aliases() const { return aliases_; }

  // For the engine.
  const KeyInEntry& keyInEntry(int detail) const {
    return keysInEntries_[static_cast<std::size_t>(kFirstKeyInEntry - detail)];
  }
  /// `isOwn`: of this blackboard itself. Nothing = no node uses it.
  std::optional<int> slotOf(int scope, std::string_view key, bool isOwn) const;
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Of the ports, as slots so that both are read in one way; the first is unset.
  const std::vector<Slot>& constants() const { return constants_; }
  const std::vector<Slot>& initialSlots() const { return initialSlots_; }
  const std::vector<Conditions>& conditions() const { return conditions_; }
  const std::vector<Script>& scripts() const { return scripts_; }
  const NodeFunctions& functions(int detail) const {
    return functions_[static_cast<std::size_t>(detail)];
  }
  int memoryBytes() const { return memoryBytes_; }

 private:
  friend class Compiler;
  struct Origin {
    std::string label;
    std::string tree;
    int line = 0;
    int manifest = 0;
  };
  const Origin& origin(int node) const { return origins_[static_cast<std::size_t>(node)]; }

  std::vector<Node> nodes_;
  std::vector<PortBinding> bindings_;
  std::vector<Slot> constants_ = std::vector<Slot>(1);
  std::vector<Slot> initialSlots_;
  std::vector<Conditions> conditions_;
  std::vector<Script> scripts_;
  std::vector<NodeFunctions> functions_;
  std::vector<NodeManifest> manifests_;
  std::vector<Origin> origins_;
  std::vector<Entry> entries_;
  std::vector<Entry> aliases_;
  std::vector<int> hostSlots_;
  std::vector<Scope> scopes_;  // only if keys stand in entries
  std::vector<KeyInEntry> keysInEntries_;
  std::shared_ptr<const std::vector<std::string>> paths_;
  int memoryBytes_ = 0;
};

/// Checks and compiles. Warnings (unknown ports, references that nothing writes …) come with the
/// program; errors name file and line.
base::Result<std::shared_ptr<const Program>> compile(const TreeTable& table,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options = {});
/// The same for a file as edited; its includes are read.
base::Result<std::shared_ptr<const Program>> compile(const TreeFile& file,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options = {});

/// Where BehaviorTree.CPP 4.10 treats a table that can be compiled differently; see the README.
base::Diagnostics notesOnOriginal(const TreeTable& table, const NodeLibrary& library,
                                  CompileOptions options = {});

}  // namespace bt
