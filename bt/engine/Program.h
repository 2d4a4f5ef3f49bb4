#pragma once

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
#include "sim2d/base/Find.h"
#include "sim2d/base/Result.h"

/// A tree compiled once and shared by all agents that run it: flat, parents before children,
/// SubTrees inlined, ports bound to constants and slots. Immutable and safe to read from several
/// threads.
namespace bt {

constexpr int kMaxProgramNodes = 200000;                     // after SubTrees are inlined
constexpr int kMaxProgramDepth = 2000;                       // the same
constexpr std::size_t kMaxPathBytes = std::size_t{1} << 28;  // of all paths in total

// Special values of Node::detail, which otherwise is the index of a script, slot or function.
constexpr int kMissing = -1;
constexpr int kEmptyScript = -2;
constexpr int kUnusedEntry = -3;       // no node uses that entry
constexpr int kFirstIndirectKey = -4;  // this and below: an entry contains the key

class Ticker;
/// Runs one node: the code specific to its kind, without conditions and status updates.
using NodeRunner = base::NodeStatus (*)(Ticker& ticker, int node);
/// Clears the memory of a node and resets its children.
using NodeHalter = void (*)(Ticker& ticker, int node);

/// An entry written by the host, known before the tree is loaded.
struct HostEntry {
  std::string key;
  PortType type = PortType::Any;
};

struct CompileOptions {
  std::string mainTree;  // empty: as in the file
  std::vector<HostEntry> hostEntries = {{"id", PortType::Int}, {"dt", PortType::Double}};
  bool differencesFromBtCpp = false;  // also report differences from BehaviorTree.CPP 4.10
};

class Program {
 public:
  Program() = default;
  Program(const Program&) = delete;  // nodes hold pointers into it
  Program& operator=(const Program&) = delete;
  Program(Program&&) = delete;
  Program& operator=(Program&&) = delete;
  ~Program() = default;

  struct alignas(64) Node : NodeHead {    // one cache line
    bool isInstant = false;               // always done within the tick (Compiler::close)
    bool hasOnlyInstantChildren = false;  // all children are instant and keep no status
    bool hasOneChild = false;             // a decorator or SubTree
    bool isStateful = false;              // a library leaf that may return RUNNING
    std::int32_t end = 0;  // index after the last descendant; the first child is index + 1
    std::int32_t children = 0;
    std::int32_t memory = 0;         // offset of its memory in the agent's memory
    std::int32_t conditions = -1;    // index in conditions(); -1: none
    std::int32_t detail = kMissing;  // index of library functions, script or slot, or a value above
    LeafFunction tick = nullptr;     // of a synchronous leaf without conditions
    NodeRunner run = nullptr;
    NodeHalter halt = nullptr;  // null: only the children are halted
  };
  /// Scripts of the pre- and post-conditions, in the order of kConditionNames; -1: none.
  using Conditions = std::array<int, kConditionNames.size()>;
  enum Condition { FailureIf, SuccessIf, SkipIf, While, OnSuccess, OnFailure, Post, OnHalted };
  /// An entry of the blackboard, for listings.
  struct Entry {
    std::string key;  // "id"; in a SubTree prefixed by its path: "RegNav/RegularNavTree/x"
    int slot = -1;
  };
  /// The keys of one blackboard.
  struct Scope {
    int parent = -1;
    bool autoRemap = false;
    std::map<std::string, int, std::less<>> slots;           // used by nodes
    std::map<std::string, std::string, std::less<>> remaps;  // key in the parent
    std::vector<int> own;                                    // slots of this blackboard itself
  };
  /// The key is the value of the entry `slot`; it is resolved in `scope`.
  struct IndirectKey {
    int slot = -1;
    int scope = 0;
  };

  int nodeCount() const { return static_cast<int>(nodes_.size()); }
  const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  /// Paths from the root, one per node: "MainFallback/SetGoals/RunOnce[2]/SetGoal". Shared, so that
  /// a recorder can keep them without the program.
  const std::shared_ptr<const std::vector<std::string>>& paths() const { return paths_; }
  /// Per node: it is never executed (Reachability.h). Shared like the paths.
  const std::shared_ptr<const std::vector<bool>>& unreachable() const { return unreachable_; }
  const std::string& path(int node) const { return (*paths_)[static_cast<std::size_t>(node)]; }
  const std::string& label(int node) const { return origin(node).label; }  // name, else ID
  const NodeManifest& manifest(int node) const {
    return manifests_[static_cast<std::size_t>(origin(node).manifest)];
  }
  /// Tree and line of the node in the file, for an editor.
  const std::string& treeOf(int node) const { return origin(node).tree; }
  int lineOf(int node) const { return origin(node).line; }

  /// Slot of an entry of the root blackboard; -1: no node uses it.
  int findSlot(std::string_view key) const {
    const Entry* const found = base::findBy(entries_, &Entry::key, key);
    return found != nullptr ? found->slot : -1;
  }
  /// Slot of CompileOptions::hostEntries[index]; always exists.
  int hostSlot(int index) const { return hostSlots_[static_cast<std::size_t>(index)]; }
  const std::vector<Entry>& entries() const { return entries_; }  // all scopes, root first
  const std::string& keyOf(int slot) const { return entries_[static_cast<std::size_t>(slot)].key; }
  /// Keys of SubTrees that are mapped to entries of their callers, with the same naming as
  /// entries().
  const std::vector<Entry>& aliases() const { return aliases_; }

  // For the engine.
  const IndirectKey& indirectKey(int detail) const {
    return indirectKeys_[static_cast<std::size_t>(kFirstIndirectKey - detail)];
  }
  /// `isOwn`: only entries of this blackboard itself. Empty: no node uses the entry.
  std::optional<int> slotOf(int scope, std::string_view key, bool isOwn) const;
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Constants of the ports, stored as slots so that both are read the same way; the first is
  /// unset.
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
  std::vector<Scope> scopes_;  // only if indirect keys exist
  std::vector<IndirectKey> indirectKeys_;
  std::shared_ptr<const std::vector<std::string>> paths_;
  std::shared_ptr<const std::vector<bool>> unreachable_;
  int memoryBytes_ = 0;
};

/// Checks and compiles a tree. Warnings (unknown ports, references that are never written …) are
/// returned with the program; errors contain file and line.
base::Result<std::shared_ptr<const Program>> compile(const TreeTable& table,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options = {});
/// The same for a file under edit; its includes are resolved.
base::Result<std::shared_ptr<const Program>> compile(const TreeFile& file,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options = {});

/// Differences between this engine and BehaviorTree.CPP 4.10 that affect a table; see the README.
base::Diagnostics differencesFromBtCpp(const TreeTable& table, const NodeLibrary& library,
                                       CompileOptions options = {});

}  // namespace bt
