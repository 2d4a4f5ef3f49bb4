#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "bt/tree/TextValue.h"
#include "bt/tree/XmlText.h"

namespace bt {
namespace {

using Names = std::map<std::string, const char*>;

const Names kRenamedNodes = {{"SubTreePlus", "SubTree"},
                             {"SequenceStar", "SequenceWithMemory"},
                             {"RetryUntilSuccesful", "RetryUntilSuccessful"}};
const Names kParallelPorts = {{"success_threshold", "success_count"},
                              {"failure_threshold", "failure_count"}};
const std::set<std::string> kChecks = {"BlackboardCheckInt", "BlackboardCheckDouble",
                                       "BlackboardCheckString", "BlackboardCheckBool"};

/// False = there is no new name.
bool rename(std::string& name, const Names& names) {
  const auto now = names.find(name);
  if (now == names.end()) {
    return false;
  }
  name = now->second;
  return true;
}

/// A word that names an entry; numbers and texts with blanks are constants.
bool isKeyName(const std::string& text) {
  const auto part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::all_of(text.begin(), text.end(), part);
}

bool takeFlag(Attributes& attributes, const char* name) {
  const std::string* const text = findText(attributes, name);
  const bool set = text && boolFromText(*text).value_or(false);
  removeText(attributes, name);
  return set;
}

bool convertSubTree(NodeSpec& node) {
  bool changed = false;
  for (Attribute& port : node.ports) {
    if (isKeyName(port.text)) {
      port.text = "{" + port.text + "}";
      changed = true;
    }
  }
  const bool shared = takeFlag(node.others, "__shared_blackboard");
  const bool automatic = takeFlag(node.others, "__autoremap");
  node.autoRemap = node.autoRemap || shared || automatic;
  return changed || shared || automatic;
}

/// One side of a comparison in the script language.
std::string operandOf(const std::string& text, const std::string& port, bool isText) {
  if (const std::optional<std::string> key = referencedKey(text, port)) {
    return *key;
  }
  if (isText) {
    return "'" + text + "'";
  }
  const std::optional<bool> flag = boolFromText(text);
  const bool word = flag && !doubleFromText(text);
  return word ? (*flag ? "true" : "false") : text;
}

void convertCheck(NodeSpec& node) {
  const bool isText = node.id == "BlackboardCheckString";
  const auto side = [&](const char* port) {
    const std::string* const text = findText(node.ports, port);
    return operandOf(text ? *text : std::string(), port, isText);
  };
  Attributes ports = {{"if", side("value_A") + " == " + side("value_B")}};
  if (const std::string* const result = findText(node.ports, "return_on_mismatch")) {
    ports.push_back({"else", *result});
  }
  node.ports = std::move(ports);
  node.id = "Precondition";
}

}  // namespace

bool isVersion3Name(const std::string& id) {
  return kChecks.count(id) > 0 || kRenamedNodes.count(id) > 0;
}

void convertFromVersion3(NodeSpec& node, const std::string& fileName, base::Diagnostics& notes) {
  const std::string before = node.id;
  bool changed = rename(node.id, kRenamedNodes);
  if (node.isSubTree()) {
    changed = convertSubTree(node) || changed;
  } else if (node.id == "Parallel") {
    for (Attribute& port : node.ports) {
      changed = rename(port.name, kParallelPorts) || changed;
    }
  } else if (kChecks.count(node.id) > 0) {
    convertCheck(node);
    changed = true;
  }
  if (changed) {
    notes.push_back(base::warning("tree.converted", {before}, fileName, node.line));
  }
}

}  // namespace bt
