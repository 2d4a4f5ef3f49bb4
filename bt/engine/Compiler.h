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

#include "bt/engine/NodeCodes.h"
#include "bt/engine/Program.h"

namespace bt {

/// The blackboards of a tree and its SubTrees while it is compiled: which slot a key means.
class Scopes {
 public:
  /// A blackboard for a SubTree called from `parent`; `path` is shown in lists.
  int add(int parent, bool autoRemap, const std::string& path);
  /// `key` of `scope` is `parentKey` of its parent.
  void remap(int scope, const std::string& key, const std::string& parentKey) {
    scopes_[static_cast<std::size_t>(scope)].remaps[key] = parentKey;
  }
  /// `key` of `scope` starts with this constant.
  void setConstant(int scope, const std::string& key, const std::string& text);

  /// Makes the slot when the key is new.
  int slotOf(int scope, const std::string& key);

  /// It is of this blackboard itself.
  bool isOwn(int scope, int slot) const {
    const std::vector<int>& own = scopes_[static_cast<std::size_t>(scope)].own;
    return std::find(own.begin(), own.end(), slot) != own.end();
  }

  /// What is known about a slot beside its first value.
  struct Use {
    bool literal = false;   // a constant of a SubTree: takes the type of its first reader
    bool inScript = false;  // a script assigns it
    std::optional<base::Diagnostic> textSet;  // by SetBlackboard; not yet known whether it matters
    std::optional<base::Diagnostic> removed;  // likewise, by UnsetBlackboard
    bool written = false;
    bool read = false;
    std::string firstTyped;  // who fixed the type, for messages
    std::string firstRead;   // "{key}" of the first reader
    std::string file;
    int line = 0;
  };
  Slot& slot(int index) { return slots_[static_cast<std::size_t>(index)]; }
  Use& use(int index) { return uses_[static_cast<std::size_t>(index)]; }
  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<Use>& uses() const { return uses_; }
  const std::vector<Program::Entry>& entries() const { return entries_; }
  /// The keys of SubTrees that are entries of another blackboard.
  std::vector<Program::Entry> aliases() const;
  std::vector<Program::Scope> take() { return std::move(scopes_); }

 private:
  int addSlot(int scope, const std::string& key);

  std::vector<Program::Scope> scopes_ = std::vector<Program::Scope>(1);  // first the root's
  std::vector<std::string> paths_ = std::vector<std::string>(1);         // shown in lists
  std::vector<Slot> slots_;
  std::vector<Use> uses_;
  std::vector<Program::Entry> entries_;
};

/// Makes a Program of a table whose trees have been checked. Private to the engine.
class Compiler {
 public:
  Compiler(const TreeTable& table, const NodeLibrary& library);

  base::Result<std::shared_ptr<const Program>> run(const CompileOptions& options);

 private:
  /// Where the compiler is: tree, file and blackboard of the node at hand.
  struct Place {
    const TreeTable::Entry* tree = nullptr;
    int scope = 0;
    int depth = 0;
  };

  void addHostEntries(const std::vector<HostEntry>& entries);
  int addNode(const NodeSpec& spec, const std::string& path, const Place& place);
  void close(int index, NodeRunner instant);
  void addChildren(const NodeSpec& spec, int node, const Place& place);
  void addSubTree(const NodeSpec& spec, int node, const Place& place);
  int scopeOfSubTree(const NodeSpec& spec, int node, const Place& place);
  void applyModel(const NodeSpec& spec, Attributes& mapping, const Place& place);
  void setCode(const NodeSpec& spec, const BuiltinNode& how, Program::Node& node);
  template <class T>
  static int numberOf(const std::string& id, const T& entry, std::vector<T>& list,
                      std::map<std::string, int>& known);

  void bindPorts(const NodeSpec& spec, const Place& place);
  PortBinding bindPort(const NodeSpec& spec, const PortSpec& port, const Place& place);
  PortBinding constantPort(const std::string& text, PortType type, bool isDefault);
  PortType elementOf(const NodeSpec& spec, const PortSpec& port) const;
  int bindEntry(const NodeSpec& spec, const PortSpec& port, const std::string& key,
                const Place& place);
  bool adaptLiteral(int slot, PortType type);
  void declare(int slot, const NodeSpec& spec, const PortSpec& port, PortType element,
               const std::string& key, const Place& place);
  int bindConditions(const NodeSpec& spec, const Place& place);
  int addScript(const NodeSpec& spec, const std::string& source, const Place& place);
  int scriptOfPort(const NodeSpec& spec, const char* port, const Place& place);
  int slotOfKeyPort(const NodeSpec& spec, const char* port, const Place& place);
  void checkQueue(const NodeSpec& spec, const Place& place);

  void noteRead(int slot, const NodeSpec& spec, const std::string& key, const Place& place);
  void warnUnwritten();
  void noteNode(const NodeSpec& spec, const Place& place);
  void noteConstant(const NodeSpec& spec, const PortSpec& port, int slot, const std::string& key,
                    const Place& place);
  void noteEntries();
  void note(base::Diagnostic remark);
  base::Diagnostic remarkAt(const NodeSpec& spec, const Place& place, std::string_view code,
                            base::ProblemValues values) const;
  void error(const NodeSpec& spec, const Place& place, base::Diagnostic problem);
  void takeOver();

  const TreeTable& table_;
  const NodeLibrary& library_;
  std::shared_ptr<Program> program_ = std::make_shared<Program>();
  std::vector<std::string> paths_;
  std::vector<std::size_t> firstPorts_;  // of each node, in the bindings
  Scopes scopes_;
  std::map<std::string, int> manifests_;
  std::map<std::string, int> functions_;
  std::map<std::string, const XmlBlock*> subTreeModels_;
  base::Diagnostics problems_;
  std::set<std::string> notes_;  // texts, each noted once
  bool notesOnOriginal_ = false;
  std::size_t pathBytes_ = 0;
  bool full_ = false;  // too large: nothing more is added
};

}  // namespace bt
