#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bt/engine/NodeCodes.h"
#include "bt/engine/Program.h"
#include "bt/engine/Scopes.h"

namespace bt {

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
  void close(int index);
  void addChildren(const NodeSpec& spec, int node, const Place& place);
  void addSubTree(const NodeSpec& spec, int node, const Place& place);
  int scopeOfSubTree(const NodeSpec& spec, int node, const Place& place);
  void applyModel(const NodeSpec& spec, Attributes& mapping, const Place& place);
  void setCode(const NodeSpec& spec, Program::Node& node, const Place& place);
  void setDetail(const NodeSpec& spec, Program::Node& node, const Place& place);
  int manifestOf(const NodeSpec& spec);
  int functionsOf(const std::string& id);

  void bindPorts(const NodeSpec& spec, const Place& place);
  PortBinding bindPort(const NodeSpec& spec, const PortSpec& port, const Place& place);
  PortBinding constantPort(const std::string& text, PortType type, bool isDefault);
  int bindEntry(const NodeSpec& spec, const PortSpec& port, const std::string& key,
                const Place& place);
  bool adaptLiteral(int slot, PortType type);
  int bindConditions(const NodeSpec& spec, const Place& place);
  int addScript(const NodeSpec& spec, const std::string& source, const Place& place);
  int scriptOfPort(const NodeSpec& spec, const char* port, const Place& place);
  int slotOfKeyPort(const NodeSpec& spec, const char* port, const Place& place, bool written);
  void checkQueue(const NodeSpec& spec, const Place& place);

  void noteRead(int slot, const NodeSpec& spec, const std::string& key, const Place& place);
  void warnUnwritten();
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
  std::size_t pathBytes_ = 0;
  bool full_ = false;  // too large: nothing more is added
};

}  // namespace bt
