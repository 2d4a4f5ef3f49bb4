#include "app/run/LeafScript.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

using base::NodeStatus;
using base::YamlNode;

constexpr const char* kScriptStatuses = "SUCCESS, FAILURE or RUNNING";

std::optional<NodeStatus> scriptStatusOf(const std::string& word) {
  for (const NodeStatus status : {NodeStatus::Success, NodeStatus::Failure, NodeStatus::Running}) {
    if (word == base::nodeStatusName(status)) {
      return status;
    }
  }
  return std::nullopt;
}

/// Every problem of a script with file, line and column.
class ScriptReader {
 public:
  explicit ScriptReader(const std::string& path) { script_.path = path; }

  base::Result<LeafScript> read() {
    const base::Result<std::string> text = base::readTextFile(script_.path);
    if (!text) {
      return text.diagnostics();
    }
    const YamlNode root = base::parseYaml(*text, script_.path, problems_);
    if (!base::hasErrors(problems_)) {
      readRoot(root);
    }
    if (base::hasErrors(problems_)) {
      return problems_;
    }
    return {std::move(script_), std::move(problems_)};
  }

 private:
  void readRoot(const YamlNode& root) {
    if (root.isNull()) {
      return;  // nothing is said: every leaf succeeds
    }
    if (!root.isMap()) {
      error(root, "script.no-map");
      return;
    }
    for (const YamlNode& item : root.items) {
      readEntry(item);
    }
  }

  void readEntry(const YamlNode& item) {
    LeafScript::Entry entry;
    entry.leaf = item.key;
    entry.line = item.keyLine;
    entry.column = item.keyColumn;
    const std::vector<YamlNode> words = item.isList() ? item.items : std::vector{item};
    for (const YamlNode& word : words) {
      readStatus(word, entry);
    }
    if (words.empty()) {
      error(item, "script.empty-list", {item.key});
    }
    script_.entries.push_back(std::move(entry));
  }

  void readStatus(const YamlNode& word, LeafScript::Entry& entry) {
    const std::optional<NodeStatus> status =
        word.isScalar() ? scriptStatusOf(word.text) : std::nullopt;
    if (status) {
      entry.statuses.push_back(*status);
      return;
    }
    const std::string what = word.isScalar() ? "'" + word.text + "' is" : "this is";
    error(word, "script.no-status", {what, kScriptStatuses});
  }

  void error(const YamlNode& node, std::string_view code, base::ProblemValues values = {}) {
    const bool isValue = !node.isNull() || node.keyLine == 0;  // nothing stands behind its key
    problems_.push_back(base::error(code, std::move(values), script_.path,
                                    isValue ? node.line : node.keyLine,
                                    isValue ? node.column : node.keyColumn));
  }

  LeafScript script_;
  base::Diagnostics problems_;
};

}  // namespace

base::Result<LeafScript> readLeafScript(const std::string& path) {
  return ScriptReader(path).read();
}

base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script) {
  std::vector<std::string> names;
  for (int node = 0; node < program.nodeCount(); ++node) {
    if (program.node(node).isStateful) {  // a leaf of the script
      names.push_back(program.label(node));
      names.push_back(program.manifest(node).id);
    }
  }
  base::Diagnostics found;
  for (const LeafScript::Entry& entry : script.entries) {
    if (std::find(names.begin(), names.end(), entry.leaf) == names.end()) {
      found.push_back(base::warning("run.unknown-leaf",
                                    {entry.leaf, base::nearestName(entry.leaf, names)}, script.path,
                                    entry.line, entry.column));
    }
  }
  return found;
}

}  // namespace app
