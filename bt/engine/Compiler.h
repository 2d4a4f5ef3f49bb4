#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/engine/Ticker.h"

namespace bt {

/// The blackboards of a tree and its SubTrees during compilation: maps keys to slots.
class BlackboardScopes {
 public:
  /// Adds a blackboard for a SubTree called from `parent`. `path` is used in listings.
  int add(int parent, bool autoRemap, const std::string& path);
  /// Maps `key` of `scope` to `parentKey` of its parent.
  void remap(int scope, const std::string& key, const std::string& parentKey) {
    scopes_[static_cast<std::size_t>(scope)].remaps[key] = parentKey;
  }
  /// Initialises `key` of `scope` with this constant.
  void setConstant(int scope, const std::string& key, const std::string& text);

  /// Creates the slot if the key is new.
  int slotOf(int scope, const std::string& key);

  /// Whether the slot belongs to this blackboard and not to a parent.
  bool isOwn(int scope, int slot) const {
    const std::vector<int>& own = scopes_[static_cast<std::size_t>(scope)].own;
    return std::find(own.begin(), own.end(), slot) != own.end();
  }

  /// Usage of a slot, collected during compilation.
  struct Use {
    bool literal = false;   // a constant of a SubTree; takes the type of its first reader
    bool inScript = false;  // a script assigns it
    std::optional<base::Diagnostic> textSet;  // by SetBlackboard; reported if it matters
    std::optional<base::Diagnostic> removed;  // the same for UnsetBlackboard
    bool written = false;
    bool read = false;
    std::string typeDeclaredBy;  // port that declared the type, for messages
    std::string firstRead;       // "{key}" of the first reader
    std::string file;
    int line = 0;
  };
  Slot& slot(int index) { return slots_[static_cast<std::size_t>(index)]; }
  Use& use(int index) { return uses_[static_cast<std::size_t>(index)]; }
  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<Use>& uses() const { return uses_; }
  const std::vector<Program::Entry>& entries() const { return entries_; }
  /// The keys of SubTrees that are mapped to entries of another blackboard.
  std::vector<Program::Entry> aliases() const;
  std::vector<Program::Scope> take() { return std::move(scopes_); }

 private:
  int addSlot(int scope, const std::string& key);

  std::vector<Program::Scope> scopes_ = std::vector<Program::Scope>(1);  // the root's first
  std::vector<std::string> paths_ = std::vector<std::string>(1);         // used in listings
  std::vector<Slot> slots_;
  std::vector<Use> uses_;
  std::vector<Program::Entry> entries_;
};

/// Compiles a table whose trees have been checked to a Program. Private to the engine.
class Compiler {
 public:
  Compiler(const TreeTable& table, const NodeLibrary& library);

  base::Result<std::shared_ptr<const Program>> run(const CompileOptions& options);

 private:
  /// Tree, blackboard and depth of the current node.
  struct CompileContext {
    const TreeTable::Entry* tree = nullptr;
    int scope = 0;
    int depth = 0;
  };

  void addHostEntries(const std::vector<HostEntry>& entries);
  int addNode(const NodeSpec& spec, const std::string& path, const CompileContext& place);
  void close(int index, NodeRunner instant);
  void addChildren(const NodeSpec& spec, int node, const CompileContext& place);
  void addSubTree(const NodeSpec& spec, int node, const CompileContext& place);
  int scopeOfSubTree(const NodeSpec& spec, int node, const CompileContext& place);
  void applyModel(const NodeSpec& spec, Attributes& mapping, const CompileContext& place);
  void setCode(const NodeSpec& spec, const BuiltinNode& how, Program::Node& node);
  template <class T>
  static int numberOf(const std::string& id, const T& entry, std::vector<T>& list,
                      std::map<std::string, int>& known);

  void bindPorts(const NodeSpec& spec, const CompileContext& place);
  PortBinding bindPort(const NodeSpec& spec, const PortSpec& port, const CompileContext& place);
  PortBinding constantPort(const std::string& text, PortType type, bool isDefault);
  PortType elementOf(const NodeSpec& spec, const PortSpec& port) const;
  int bindEntry(const NodeSpec& spec, const PortSpec& port, const std::string& key,
                const CompileContext& place);
  bool adaptLiteral(int slot, PortType type);
  void declare(int slot, const NodeSpec& spec, const PortSpec& port, PortType element,
               const std::string& key, const CompileContext& place);
  int bindConditions(const NodeSpec& spec, const CompileContext& place);
  int addScript(const NodeSpec& spec, const std::string& source, const CompileContext& place);
  int scriptOfPort(const NodeSpec& spec, const char* port, const CompileContext& place);
  int slotOfKeyPort(const NodeSpec& spec, const char* port, const CompileContext& place);
  void checkQueue(const NodeSpec& spec, const CompileContext& place);

  void noteRead(int slot, const NodeSpec& spec, const std::string& key,
                const CompileContext& place);
  void warnUnwritten();
  void addNodeDifferences(const NodeSpec& spec, const CompileContext& place);
  void addConstantDifference(const NodeSpec& spec, const PortSpec& port, int slot,
                             const std::string& key, const CompileContext& place);
  void addEntryDifferences();
  void note(base::Diagnostic remark);
  base::Diagnostic differenceAt(const NodeSpec& spec, const CompileContext& place,
                                std::string_view code, base::ProblemValues values) const;
  void error(const NodeSpec& spec, const CompileContext& place, base::Diagnostic problem);
  void moveIntoProgram();

  const TreeTable& table_;
  const NodeLibrary& library_;
  std::shared_ptr<Program> program_ = std::make_shared<Program>();
  std::vector<std::string> paths_;
  std::vector<std::size_t> firstPorts_;  // first port binding of each node
  BlackboardScopes scopes_;
  std::map<std::string, int> manifests_;
  std::map<std::string, int> functions_;
  std::map<std::string, const XmlElement*> subTreeModels_;
  base::Diagnostics problems_;
  std::set<std::string> seenDifferences_;  // texts, each reported once
  bool reportsDifferences_ = false;
  std::size_t pathBytes_ = 0;
  bool full_ = false;  // size limit reached: no more nodes are added
};

}  // namespace bt
