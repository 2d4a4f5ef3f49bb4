#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Types.h"

/// Descriptions of all node types, used by the palette, the checks and the compiler. Sources:
/// BehaviorTree.CPP 4.10 (controls, decorators, its leaves) and HuNavSim 2.0 (nodes for people,
/// added by bt/human).
namespace bt {

enum class NodeKind { Condition, Action, Control, Decorator, SubTree };
enum class PortDirection { Input, Output, InOut };
/// Unsigned is a non-negative integer. Queue is text with ';' between the elements. Any accepts
/// every value.
enum class PortType : std::uint8_t { Int, Unsigned, Double, Bool, String, Status, Queue, Any };
enum class NodeOrigin { BehaviorTreeCpp, HuNavSim, Ours };

const char* nodeKindName(NodeKind kind);                // XML tag: "Condition", "Action", …
const char* portDirectionTag(PortDirection direction);  // "input_port", "output_port", "inout_port"
const char* portTypeName(PortType type);  // "int", "double", "std::string" …; Any: ""
const char* nodeOriginName(NodeOrigin origin);

/// Port of a node. `key` is the XML attribute, `range` the recommended range, `fallback` the text
/// that is used when the attribute is absent.
struct PortSpec : base::ParameterSpec {
  PortType portType = PortType::Any;
  PortDirection direction = PortDirection::Input;
  bool required = false;                // absent without fallback: an error when the port is read
  std::vector<std::string> replacedBy;  // the port may be absent if all of these are given
  std::string suggested;                // initial text for a node created in the editor

  const std::string* fallbackText() const { return std::get_if<std::string>(&fallback); }
};

struct NodeManifest {
  std::string id;  // XML name
  NodeKind kind = NodeKind::Action;
  std::vector<PortSpec> ports;  // the index is the port number that leaves use
  std::string category;         // group in the palette
  std::string description;
  NodeOrigin origin = NodeOrigin::Ours;
  int minChildren = 0;
  int maxChildren = 0;     // -1 = any number
  bool usesGoals = false;  // walks to the goals of the person's list, or changes the list

  const PortSpec* port(std::string_view name) const;  // nullptr = no such port
};

class NodeCatalogue {
 public:
  /// Replaces an existing manifest with the same id.
  void add(NodeManifest manifest);
  const NodeManifest* find(std::string_view id) const;                 // nullptr = unknown
  const std::vector<NodeManifest>& all() const { return manifests_; }  // in insertion order
  std::optional<std::string> nearest(std::string_view id) const;

 private:
  std::vector<NodeManifest> manifests_;
  std::map<std::string, std::size_t, std::less<>> indexOf_;
};

/// Parses node manifests from text with one item per line: a node, then its ports.
///
///   Condition IsAgentClose|Perception|Another person is nearer than the threshold.
///   agent_id int needed suggest {id}|Id of the person who looks.
///   threshold length default 1.0|Nearer than this is close.
///
/// The name of a node may be followed by `own` (origin NodeOrigin::Ours instead of `origin`) and
/// `children MIN MAX` and `goals` (NodeManifest::usesGoals). A port has a name, a type (int,
/// number, bool, text, status, queue, any, milliseconds, seconds, metres, or, with a recommended
/// range, length, speed, duration, angle) and options: needed, default TEXT (also the suggested
/// text), unit UNIT, range MIN MAX, atMost MAX (no lower limit), unless PORT PORT (optional if both
/// of these ports are given), output, inout, suggest TEXT (up to the bar). A line without a bar
/// repeats ports that are defined above it; the last definition of each name is used. Ports defined
/// before the first node belong to no node.
NodeCatalogue parseNodeCatalogue(std::string_view text, NodeOrigin origin);

/// All controls, decorators and leaves of BehaviorTree.CPP that are supported, including "SubTree".
NodeCatalogue builtinNodes();

/// Converts port text to values by the rules of BehaviorTree.CPP: a number ends at the first
/// character that does not belong to it ("5abc" is 5), leading blanks and '+' are rejected, C
/// locale.
std::optional<int> intFromText(std::string_view text);
std::optional<std::int64_t> unsignedFromText(std::string_view text);  // 0 … 4294967295
std::optional<double> doubleFromText(std::string_view text);
std::optional<bool> boolFromText(std::string_view text);  // 0 1 true TRUE True false FALSE False
std::optional<base::NodeStatus> statusFromText(std::string_view text);

/// Splits a queue at ';'. A trailing ';' is ignored.
std::vector<std::string> splitQueue(std::string_view list);

/// The number that a port of a numeric type reads from this text if the text has further characters
/// ("1,5" is read as 1). Empty if the whole text is a number or if it contains none.
std::optional<double> partiallyReadNumber(std::string_view text, PortType type);

/// Whether a port of this type accepts the constant.
bool isConvertible(std::string_view text, PortType type);

}  // namespace bt
