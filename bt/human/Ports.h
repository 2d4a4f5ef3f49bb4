#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt/engine/NodeLibrary.h"

/// Short forms for the manifests of people's nodes, and what their ports take.
namespace bt {

/// "2, 3": leading number of each token, empty tokens skipped; nothing when a token has no number.
std::optional<std::vector<int>> parseIds(const std::string& text);
/// "3;1;1": numbers of 0 or more, at least one above 0, with a finite sum. Nothing = it is not
/// that.
std::optional<std::vector<double>> parseWeights(std::string_view text);
/// A port that takes the id of a person, or of several.
bool isPersonPort(std::string_view name);

namespace port {

/// Id of a person, required; `suggested` "{id}" = the person of the tree.
PortSpec person(const char* name, const char* description, const char* suggested = "{id}");
PortSpec agent();     // "agent_id", whose action or perception it is
PortSpec timeStep();  // "time_step", kept for the original; the step of the simulation counts here
PortSpec length(const char* name, const char* description);        // [m], 0 … 1000
PortSpec speed(const char* name, const char* description);         // [m/s], 0 … 10
PortSpec duration(const char* name, const char* description);      // [s], 0 … 36000
PortSpec openDuration(const char* name, const char* description);  // [s]; 0 and less: no end
PortSpec lasting();                                                // "duration" of the actions
PortSpec angle(const char* name, const char* description);         // [rad], 0 … pi
/// "goal_id" …
PortSpec goal(const char* description, const char* x = "target_x", const char* y = "target_y");
PortSpec oldX(const char* name = "target_x");  // … or a point (files before mid 2025)
PortSpec oldY(const char* name = "target_y");
PortSpec others();  // "non_main_agent_ids"
/// Accepted for older files.
PortSpec unused(const char* name, PortType type, const char* unit = "");

}  // namespace port

/// Manifest of one of HuNavSim's nodes; kind Condition makes a stateful node one in name.
NodeManifest humanNode(const char* id, const char* category, const char* description,
                       std::initializer_list<PortSpec> ports, NodeKind kind = NodeKind::Action);
/// Of a node that the original does not have.
NodeManifest ownNode(const char* id, const char* category, const char* description,
                     std::initializer_list<PortSpec> ports, NodeKind kind = NodeKind::Action);

}  // namespace bt
