#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim2d/base/ParameterSpec.h"

/// What is known about every kind of node: for the palette, the checks and the compiler.
/// Sources: BehaviorTree.CPP 4.10 (controls, decorators, its leaves), HuNavSim 2.0 (nodes for
/// people, added by bt/human).
namespace bt {

enum class NodeKind { Condition, Action, Control, Decorator, SubTree };
enum class PortDirection { Input, Output, InOut };
/// Unsigned is a non-negative whole number; Queue is text with ';' between the elements; Any takes
/// whatever it is given.
enum class PortType : std::uint8_t { Int, Unsigned, Double, Bool, String, Status, Queue, Any };
enum class NodeOrigin { BehaviorTreeCpp, HuNavSim, Ours };

const char* nodeKindName(NodeKind kind);                // "Condition", … as the XML tag
const char* portDirectionTag(PortDirection direction);  // "input_port", "output_port", "inout_port"
const char* portTypeName(PortType type);  // "int", "double", "std::string" …; Any: ""
const char* nodeOriginName(NodeOrigin origin);

/// A parameter of a node: its key is the attribute, its range what is sensible, its fallback the
/// text that is taken when the attribute is absent.
struct PortSpec : base::ParameterSpec {
  PortType portType = PortType::Any;
  PortDirection direction = PortDirection::Input;
  bool required = false;                // absent and no fallback: an error as soon as it is read
  std::vector<std::string> replacedBy;  // absent is fine when all of these ports are given
  std::string suggested;                // text that an editor writes into a new node

  const std::string* fallbackText() const { return std::get_if<std::string>(&fallback); }
};

struct NodeManifest {
  std::string id;  // the name in XML
  NodeKind kind = NodeKind::Action;
  std::vector<PortSpec> ports;  // the index here is the port number that leaves use
  std::string category;         // heading in the palette
  std::string description;
  NodeOrigin origin = NodeOrigin::Ours;
  int minChildren = 0;
  int maxChildren = 0;  // -1 = any number

  const PortSpec* port(std::string_view name) const;  // nullptr = no such port
};

class NodeCatalogue {
 public:
  /// Replaces a manifest of the same id.
  void add(NodeManifest manifest);
  const NodeManifest* find(std::string_view id) const;                 // nullptr = unknown
  const std::vector<NodeManifest>& all() const { return manifests_; }  // in order of adding
  std::optional<std::string> nearest(std::string_view id) const;

 private:
  std::vector<NodeManifest> manifests_;
  std::map<std::string, std::size_t, std::less<>> indexOf_;
};

/// Nodes as a text says them, one thing per line: a node, then its ports.
///
///   Condition IsAgentClose|Perception|Another person is nearer than the threshold.
///   agent_id int needed suggest {id}|Id of the person who looks.
///   threshold length default 1.0|Nearer than this is close.
///
/// A node may say `own` (its origin is Ours, not `origin`) and `children LEAST MOST` behind its
/// name. A port has a name, a type (int, number, bool, text, status, queue, any, milliseconds,
/// seconds, metres, or with a sensible range length, speed, duration, angle) and then what is true
/// of it: needed, default TEXT (also suggested), unit UNIT, range LEAST MOST, atMost MOST (below it
/// anything), unless PORT PORT (these two make it dispensable), output, inout, suggest TEXT (up to
/// the bar). A line without a bar names ports that stand further up, the last of each name; those
/// above all nodes belong to none.
NodeCatalogue nodesOf(std::string_view text, NodeOrigin origin);

/// All controls, decorators and leaves of BehaviorTree.CPP that we run, "SubTree" included.
NodeCatalogue builtinNodes();

}  // namespace bt
