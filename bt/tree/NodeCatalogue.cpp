#include "bt/tree/NodeCatalogue.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"

namespace bt {

namespace {

/// The name at the place of the enumerator.
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
  const auto place = std::find_if(ports.begin(), ports.end(),
                                  [name](const PortSpec& port) { return port.key == name; });
  return place == ports.end() ? nullptr : &*place;
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

/// A type in texts, with what goes with it.
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

/// Cuts off the first word; empty at the end.
std::string takeWord(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::string word(text.substr(0, text.find(' ')));
  text.remove_prefix(word.size());
  return word;
}

double takeNumber(std::string_view& text) {
  return base::parseDouble(takeWord(text)).value();
}

void applyMark(PortSpec& port, const std::string& mark, std::string_view& rest) {
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

PortSpec portOf(const std::string& line) {
  const std::size_t bar = line.find('|');
  std::string_view rest = std::string_view(line).substr(0, bar);
  PortSpec port;
  port.key = takeWord(rest);
  const std::string word = takeWord(rest);
  const auto* const kind =
      std::find_if(kPortWords.begin(), kPortWords.end(),
                   [&word](const PortWord& known) { return known.word == word; });
  assert(kind != kPortWords.end());
  port.type = parameterTypeOf(kind->type);
  port.portType = kind->type;
  port.unit = kind->unit;
  port.range = kind->range;
  port.help = line.substr(bar + 1);
  for (std::string mark = takeWord(rest); !mark.empty(); mark = takeWord(rest)) {
    applyMark(port, mark, rest);
  }
  return port;
}

/// Nothing for the line of a port.
std::optional<NodeManifest> nodeOf(const std::string& line, NodeOrigin origin) {
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
    } else {
      assert(mark == "children");
      node.minChildren = static_cast<int>(takeNumber(rest));
      node.maxChildren = static_cast<int>(takeNumber(rest));
    }
  }
  return node;
}

}  // namespace

NodeCatalogue nodesOf(std::string_view text, NodeOrigin origin) {
  std::vector<NodeManifest> nodes;
  std::map<std::string, PortSpec> known;
  for (const std::string& line : base::split(text, '\n')) {
    if (std::optional<NodeManifest> node = nodeOf(line, origin)) {
      nodes.push_back(*std::move(node));
      continue;
    }
    std::string_view names = line;
    if (line.find('|') != std::string::npos) {
      PortSpec port = portOf(line);
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

}  // namespace bt
