#include "bt/tree/NodeCatalogue.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"

namespace bt {

namespace {

/// The name at the index of the enumerator.
template <class Enum, std::size_t count>
const char* nameOf(Enum value, const std::array<const char*, count>& names) {
  return names.at(static_cast<std::size_t>(value));
}

constexpr std::array kKindNames = {"Condition", "Action", "Control", "Decorator", "SubTree"};

}  // namespace

const char* nodeKindName(NodeKind kind) {
  return nameOf(kind, kKindNames);
}

const char* portDirectionTag(PortDirection direction) {
  return nameOf(direction, std::array{"input_port", "output_port", "inout_port"});
}

const char* portTypeName(PortType type) {
  return nameOf(type, std::array{"int", "unsigned int", "double", "bool", "std::string",
                                 "NodeStatus", "std::string", ""});
}

const char* nodeOriginName(NodeOrigin origin) {
  return nameOf(origin, std::array{"BehaviorTree.CPP", "HuNavSim", "HuNavSim Desktop"});
}

const PortSpec* NodeManifest::port(std::string_view name) const {
  return base::findBy(ports, &PortSpec::key, name);
}

void NodeCatalogue::add(NodeManifest manifest) {
  const auto [place, isNew] = indexOf_.emplace(manifest.id, manifests_.size());
  if (isNew) {
    manifests_.push_back(std::move(manifest));
  } else {
    manifests_[place->second] = std::move(manifest);
  }
}

const NodeManifest* NodeCatalogue::find(std::string_view id) const {
  const auto place = indexOf_.find(id);
  return place == indexOf_.end() ? nullptr : &manifests_[place->second];
}

std::optional<std::string> NodeCatalogue::nearest(std::string_view id) const {
  std::vector<std::string> names;
  names.reserve(manifests_.size());
  for (const NodeManifest& manifest : manifests_) {
    names.push_back(manifest.id);
  }
  return base::nearestName(id, names);
}

namespace {

/// A type name in node definitions, with its unit and range.
struct PortWord {
  std::string_view word;
  PortType type;
  const char* unit = "";
  base::Range range = {};
};
constexpr std::array<PortWord, 14> kPortWords = {
    {{"int", PortType::Int},
     {"number", PortType::Double},
     {"bool", PortType::Bool},
     {"text", PortType::String},
     {"status", PortType::Status},
     {"queue", PortType::Queue},
     {"any", PortType::Any},
     {"milliseconds", PortType::Unsigned, "ms"},
     {"seconds", PortType::Double, "s"},
     {"metres", PortType::Double, "m"},
     {"length", PortType::Double, "m", {0.0, 1000.0}},
     {"speed", PortType::Double, "m/s", {0.0, 10.0}},
     {"duration", PortType::Double, "s", {0.0, 36000.0}},
     {"angle", PortType::Double, "rad", {0.0, base::kPi}}}};

/// Removes and returns the first word; empty at the end.
std::string takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::string word(text.substr(0, text.find(' ')));
  text.remove_prefix(word.size());
  return word;
}

double takeNumber(std::string_view& text) {
  return base::parseDouble(takeWord(text)).value();
}

void applyPortOption(PortSpec& port, const std::string& mark, std::string_view& rest) {
  if (mark == "needed") {
    port.required = true;
  } else if (mark == "default") {
    port.suggested = takeWord(rest);
    port.fallback = port.suggested;
  } else if (mark == "unit") {
    port.unit = takeWord(rest);
  } else if (mark == "range") {
    port.range.low = takeNumber(rest);
    port.range.high = takeNumber(rest);
  } else if (mark == "atMost") {
    port.range = {base::kAnyNumber.low, takeNumber(rest)};
  } else if (mark == "unless") {
    port.replacedBy = {takeWord(rest), takeWord(rest)};
  } else if (mark == "output" || mark == "inout") {
    port.direction = mark == "output" ? PortDirection::Output : PortDirection::InOut;
  } else {
    assert(mark == "suggest");
    port.suggested = base::trimmed(rest);
    rest = {};
  }
}

base::ParameterType parameterTypeOf(PortType type) {
  switch (type) {
    case PortType::Int:
    case PortType::Unsigned:
      return base::ParameterType::Integer;
    case PortType::Double:
      return base::ParameterType::Number;
    case PortType::Bool:
      return base::ParameterType::Boolean;
    default:
      return base::ParameterType::Text;
  }
}

PortSpec parsePort(const std::string& line) {
  const std::size_t bar = line.find('|');
  std::string_view rest = std::string_view(line).substr(0, bar);
  PortSpec port;
  port.key = takeWord(rest);
  const std::string word = takeWord(rest);
  const PortWord* const kind = base::findBy(kPortWords, &PortWord::word, word);
  assert(kind != nullptr);
  port.type = parameterTypeOf(kind->type);
  port.portType = kind->type;
  port.unit = kind->unit;
  port.range = kind->range;
  port.help = line.substr(bar + 1);
  for (std::string mark = takeWord(rest); !mark.empty(); mark = takeWord(rest)) {
    applyPortOption(port, mark, rest);
  }
  return port;
}

/// Empty for a line that defines a port.
std::optional<NodeManifest> parseNode(const std::string& line, NodeOrigin origin) {
  const std::vector<std::string> fields = base::split(line, '|');
  std::string_view rest = fields.front();
  const std::string word = takeWord(rest);
  const auto* const kind = std::find(kKindNames.begin(), kKindNames.end(), word);
  if (kind == kKindNames.end()) {
    return std::nullopt;
  }
  NodeManifest node;
  node.id = takeWord(rest);
  node.kind = static_cast<NodeKind>(kind - kKindNames.begin());
  node.category = fields.at(1);
  node.description = fields.at(2);
  node.origin = origin;
  const bool isControl = node.kind == NodeKind::Control;
  node.minChildren = isControl || node.kind == NodeKind::Decorator ? 1 : 0;
  node.maxChildren = isControl ? -1 : node.minChildren;
  for (std::string mark = takeWord(rest); !mark.empty(); mark = takeWord(rest)) {
    if (mark == "own") {
      node.origin = NodeOrigin::Ours;
    } else if (mark == "goals") {
      node.usesGoals = true;
    } else {
      assert(mark == "children");
      node.minChildren = static_cast<int>(takeNumber(rest));
      node.maxChildren = static_cast<int>(takeNumber(rest));
    }
  }
  return node;
}

}  // namespace

NodeCatalogue parseNodeCatalogue(std::string_view text, NodeOrigin origin) {
  std::vector<NodeManifest> nodes;
  std::map<std::string, PortSpec> known;
  for (const std::string& line : base::split(text, '\n')) {
    if (std::optional<NodeManifest> node = parseNode(line, origin)) {
      nodes.push_back(*std::move(node));
      continue;
    }
    std::string_view names = line;
    if (line.find('|') != std::string::npos) {
      PortSpec port = parsePort(line);
      names = names.substr(0, port.key.size());
      known[port.key] = std::move(port);
    }
    for (std::string name = takeWord(names); !nodes.empty() && !name.empty();
         name = takeWord(names)) {
      nodes.back().ports.push_back(known.at(name));
    }
  }
  NodeCatalogue catalogue;
  for (NodeManifest& node : nodes) {
    catalogue.add(std::move(node));
  }
  return catalogue;
}

namespace {

constexpr const char* kNodes = R"(
Control Sequence|Control|Runs the children in order until one fails; resumes at the running child.
Control Fallback|Control|Runs the children in order until one succeeds; resumes at the running child.
Control ReactiveSequence|Control|A sequence that restarts at the first child in every time step, so that conditions are checked again.
Control ReactiveFallback|Control|A fallback that restarts at the first child in every time step, so that earlier children take precedence.
Control SequenceWithMemory|Control|A sequence that resumes at the child that failed.
Control AsyncSequence|Control|A sequence that completes at most one child per time step.
Control AsyncFallback|Control|A fallback that completes at most one child per time step.
Control Parallel|Control|Runs all children in every time step until enough have succeeded or failed.
success_count int default -1|Number of successes after which the node succeeds; negative: counted from all children (-1: all).
failure_count int default 1|Number of failures after which the node fails; negative: counted from all children (-1: all).
Control ParallelAll|Control|Runs all children and ends when all are completed.
max_failures int default 1|Number of failures after which the node fails.
Control IfThenElse children 2 3|Control|The first child is the condition, run once; if it succeeds, the second child is run, otherwise the third.
Control WhileDoElse children 2 3|Control|The first child is the condition, run in every time step; while it succeeds, the second child is run, otherwise the third.
Control Switch2 children 3 3|Control|Runs the child whose case equals the variable, for any other value the last child.
variable text|Value that is compared.
case_1 text needed|Value for which child 1 is run.
case_2 text needed|Value for which child 2 is run.
Control Switch3 children 4 4|Control|Runs the child whose case equals the variable, for any other value the last child.
variable case_1 case_2
case_3 text needed|Value for which child 3 is run.
Control Switch4 children 5 5|Control|Runs the child whose case equals the variable, for any other value the last child.
variable case_1 case_2 case_3
case_4 text needed|Value for which child 4 is run.
Control Switch5 children 6 6|Control|Runs the child whose case equals the variable, for any other value the last child.
variable case_1 case_2 case_3 case_4
case_5 text needed|Value for which child 5 is run.
Control Switch6 children 7 7|Control|Runs the child whose case equals the variable, for any other value the last child.
variable case_1 case_2 case_3 case_4 case_5
case_6 text needed|Child 6 is run for this value.
Control TryCatch children 2 -1|Control|Runs all children except the last as a sequence; if it fails, runs the last child.
catch_on_halt bool default false|The last child is also ticked once when the node is halted.
Decorator Inverter|Decorator|Inverts success and failure of the child.
Decorator ForceSuccess|Decorator|Succeeds whatever the result of the child.
Decorator ForceFailure|Decorator|Fails whatever the result of the child.
Decorator KeepRunningUntilFailure|Decorator|Repeats the child until it fails.
Decorator Repeat|Decorator|Repeats the child this number of times, or until it fails.
num_cycles int needed suggest 3|Number of runs; -1: unlimited.
Decorator RetryUntilSuccessful|Decorator|Repeats the child until it succeeds.
num_attempts int needed suggest 3|Number of runs; -1: unlimited.
Decorator RunOnce|Decorator|Runs the child to completion once in the lifetime of the tree.
then_skip bool default true|Afterwards: true: skipped, false: returns the same result.
Decorator Delay|Decorator|Waits before the child is run.
delay_msec milliseconds needed suggest 1000|Duration in simulated time.
Decorator Timeout|Decorator|Fails when the child takes longer.
msec milliseconds needed suggest 1000|Limit in simulated time; 0: none.
Decorator Precondition|Decorator|Runs the child only if a script is true.
if text needed suggest true|Script.
else status default FAILURE|Result if the script is false.
Decorator LoopInt|Decorator|Runs the child once for each element of a list.
queue queue needed inout suggest 1;2;3|Elements, separated by ';'.
if_empty status default SUCCESS|Result at the end.
value int output suggest {value}|Current element.
Decorator LoopBool|Decorator|Runs the child once for each element of a list.
queue if_empty
value bool output suggest {value}|Current element.
Decorator LoopDouble|Decorator|Runs the child once for each element of a list.
queue if_empty
value number output suggest {value}|Current element.
Decorator LoopString|Decorator|Runs the child once for each element of a list.
queue if_empty
value text output suggest {value}|Current element.
Decorator SkipUnlessUpdated|Decorator|Skips the child unless the blackboard entry was written.
entry any needed suggest {key}|Blackboard entry.
Decorator WaitValueUpdate|Decorator|Waits until the blackboard entry is written, then runs the child.
entry
SubTree SubTree|SubTree|Runs another tree.
Action AlwaysSuccess|Blackboard|Succeeds.
Action AlwaysFailure|Blackboard|Fails.
Action SetBlackboard|Blackboard|Writes an entry of the blackboard.
value any needed suggest 1|Text, or {key} of the entry that is copied.
output_key any needed inout suggest key|Name of the entry.
Action UnsetBlackboard|Blackboard|Removes an entry of the blackboard.
key text needed suggest key|Name of the entry.
Action Script|Blackboard|Runs a script.
code text needed suggest x := 1|Script.
Condition ScriptCondition|Condition|Succeeds if a script is true.
code text needed suggest x == 1|Script.
Action Sleep|Blackboard|Waits.
msec milliseconds needed suggest 1000|Duration in simulated time.
Condition WasEntryUpdated|Condition|Succeeds if the entry was written since the last check.
entry
)";

}  // namespace

NodeCatalogue builtinNodes() {
  return parseNodeCatalogue(kNodes, NodeOrigin::BehaviorTreeCpp);
}

namespace {

/// The number at the start of the text; empty if there is none or if it is out of range.
template <class T>
std::optional<T> leadingNumber(std::string_view text) {
  T value{};
  const std::from_chars_result end = std::from_chars(text.data(), text.data() + text.size(), value);
  return end.ec == std::errc() ? std::optional<T>(value) : std::nullopt;
}

}  // namespace

std::optional<int> intFromText(std::string_view text) {
  return leadingNumber<int>(text);
}

std::optional<std::int64_t> unsignedFromText(std::string_view text) {
  const std::optional<std::uint32_t> value = leadingNumber<std::uint32_t>(text);
  return value ? std::optional<std::int64_t>(*value) : std::nullopt;
}

std::optional<double> doubleFromText(std::string_view text) {
  const std::optional<double> value = leadingNumber<double>(text);
  const bool isNumber = value && (std::isfinite(*value) || text == "inf" || text == "-inf");
  return isNumber ? value : std::nullopt;
}

std::optional<bool> boolFromText(std::string_view text) {
  if (text == "1" || text == "true" || text == "TRUE" || text == "True") {
    return true;
  }
  if (text == "0" || text == "false" || text == "FALSE" || text == "False") {
    return false;
  }
  return std::nullopt;
}

std::optional<base::NodeStatus> statusFromText(std::string_view text) {
  using base::NodeStatus;
  for (const NodeStatus status : {NodeStatus::Idle, NodeStatus::Running, NodeStatus::Success,
                                  NodeStatus::Failure, NodeStatus::Skipped}) {
    if (text == base::nodeStatusName(status)) {
      return status;
    }
  }
  return std::nullopt;
}

std::vector<std::string> splitQueue(std::string_view list) {
  std::vector<std::string> elements = base::split(std::string(list), ';');
  if (!elements.empty() && elements.back().empty()) {
    elements.pop_back();
  }
  return elements;
}

std::optional<double> partiallyReadNumber(std::string_view text, PortType type) {
  std::optional<double> read;
  if (type == PortType::Double) {
    read = doubleFromText(text);
  } else if (type == PortType::Int || type == PortType::Unsigned) {
    const std::optional<long long> whole = leadingNumber<long long>(text);
    read = whole ? std::optional<double>(static_cast<double>(*whole)) : std::nullopt;
  }
  return read && read != base::parseDouble(text) ? read : std::nullopt;
}

bool isConvertible(std::string_view text, PortType type) {
  switch (type) {
    case PortType::Int:
      return intFromText(text).has_value();
    case PortType::Unsigned:
      return unsignedFromText(text).has_value();
    case PortType::Double:
      return doubleFromText(text).has_value();
    case PortType::Bool:
      return boolFromText(text).has_value();
    case PortType::Status:
      return statusFromText(text).has_value();
    case PortType::String:
    case PortType::Queue:
    case PortType::Any:
      return true;
  }
  return false;
}

}  // namespace bt
