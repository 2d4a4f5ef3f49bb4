#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "bt/engine/NodeLibrary.h"

/// Short forms for the manifests of people's nodes.
namespace bt {

/// A port in the making: port::length("distance", "…").required().suggest("5.0").
class Port {
 public:
  Port(std::string name, PortType type, std::string unit, std::string description) {
    spec_.name = std::move(name);
    spec_.type = type;
    spec_.unit = std::move(unit);
    spec_.description = std::move(description);
  }
  /// Taken when the attribute is absent.
  Port& byDefault(const char* text);
  /// What an editor writes into a new node.
  Port& suggest(const char* text);
  Port& range(double min, double max);
  Port& atMost(double max);  // negative numbers have a meaning of their own
  /// Absent is fine when these two are given.
  Port& orElse(const char* first, const char* second);
  Port& required();
  Port& output();
  operator PortSpec() const { return spec_; }  // NOLINT: meant to convert

 private:
  PortSpec spec_;
};

namespace port {

/// Id of a person, required; `suggested` "{id}" = the person of the tree.
Port person(const char* name, const char* description, const char* suggested = "{id}");
Port agent();     // "agent_id", whose action or perception it is
Port timeStep();  // "time_step", kept for the original; the step of the simulation counts here
Port length(const char* name, const char* description);        // [m], 0 … 1000
Port speed(const char* name, const char* description);         // [m/s], 0 … 10
Port duration(const char* name, const char* description);      // [s], 0 … 36000
Port openDuration(const char* name, const char* description);  // [s]; 0 and less: no end
Port lasting();                                                // "duration" of the actions
Port angle(const char* name, const char* description);         // [rad], 0 … pi
/// "goal_id" …
Port goal(const char* description, const char* x = "target_x", const char* y = "target_y");
Port oldX(const char* name = "target_x");  // … or a point (files before mid 2025)
Port oldY(const char* name = "target_y");
Port others();  // "non_main_agent_ids"
/// Accepted for older files.
Port unused(const char* name, PortType type, const char* unit = "");

}  // namespace port

/// Manifest of one of HuNavSim's nodes; kind Condition makes a stateful node one in name.
NodeManifest humanNode(const char* id, const char* category, const char* description,
                       std::initializer_list<PortSpec> ports, NodeKind kind = NodeKind::Action);
/// Of a node that the original does not have.
NodeManifest ownNode(const char* id, const char* category, const char* description,
                     std::initializer_list<PortSpec> ports, NodeKind kind = NodeKind::Action);

}  // namespace bt
