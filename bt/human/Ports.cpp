#include "bt/human/Ports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"

namespace bt {

std::optional<std::vector<int>> parseIds(const std::string& text) {
  std::vector<int> ids;
  for (const std::string& part : base::split(text, ',')) {
    const std::string token = base::trimmed(part);
    if (token.empty()) {
      continue;
    }
    const std::optional<int> id = intFromText(token);
    if (!id) {
      return std::nullopt;
    }
    ids.push_back(*id);
  }
  return ids;
}

std::optional<std::vector<double>> parseWeights(std::string_view text) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const std::string& token : base::split(text, ';')) {
    const std::optional<double> weight = base::parseDouble(base::trimmed(token));
    if (!weight || !(*weight >= 0.0)) {
      return std::nullopt;
    }
    weights.push_back(*weight);
    sum += *weight;
  }
  const bool isUsable = sum > 0.0 && std::isfinite(sum);
  return isUsable ? std::optional<std::vector<double>>(std::move(weights)) : std::nullopt;
}

bool isPersonPort(std::string_view name) {
  constexpr std::array<std::string_view, 6> kPorts = {"agent_id",      "target_agent_id",
                                                      "target_id",     "observer_id",
                                                      "main_agent_id", "non_main_agent_ids"};
  return std::find(kPorts.begin(), kPorts.end(), name) != kPorts.end();
}

namespace port {

PortSpec person(const char* name, const char* description, const char* suggested) {
  return PortSpec(name, PortType::Int, "", description).needed().suggest(suggested);
}

PortSpec agent() {
  return person("agent_id", "Id of the person who acts or perceives.");
}

PortSpec timeStep() {
  return PortSpec("time_step", PortType::Double, "s",
                  "Step length for HuNavSim; here the step of the simulation counts.")
      .suggest("{dt}");
}

PortSpec length(const char* name, const char* description) {
  return PortSpec(name, PortType::Double, "m", description).range(0.0, 1000.0);
}

PortSpec speed(const char* name, const char* description) {
  return PortSpec(name, PortType::Double, "m/s", description).range(0.0, 10.0);
}

PortSpec duration(const char* name, const char* description) {
  return PortSpec(name, PortType::Double, "s", description).range(0.0, 36000.0);
}

PortSpec openDuration(const char* name, const char* description) {
  return duration(name, description).atMost(36000.0);
}

PortSpec lasting() {
  return openDuration("duration", "Ends after this time; 0 = goes on.")
      .byDefault("0.0")
      .suggest("5.0");
}

PortSpec angle(const char* name, const char* description) {
  return PortSpec(name, PortType::Double, "rad", description).range(0.0, base::kPi);
}

PortSpec goal(const char* description, const char* x, const char* y) {
  return PortSpec("goal_id", PortType::Int, "", description).suggest("1").orElse(x, y);
}

PortSpec oldX(const char* name) {
  return PortSpec(name, PortType::Double, "m", "x of a point, when no goal_id is given.");
}

PortSpec oldY(const char* name) {
  return PortSpec(name, PortType::Double, "m", "y of a point, when no goal_id is given.");
}

PortSpec others() {
  return PortSpec("non_main_agent_ids", PortType::Any, "",
                  "Ids of the other members, with commas between them.");
}

PortSpec unused(const char* name, PortType type, const char* unit) {
  return PortSpec(name, type, unit, "Accepted for existing files; has no effect.");
}

}  // namespace port

NodeManifest ownNode(const char* id, const char* category, const char* description,
                     std::initializer_list<PortSpec> ports, NodeKind kind) {
  NodeManifest manifest;
  manifest.id = id;
  manifest.kind = kind;
  manifest.category = category;
  manifest.description = description;
  manifest.ports = ports;
  return manifest;
}

NodeManifest humanNode(const char* id, const char* category, const char* description,
                       std::initializer_list<PortSpec> ports, NodeKind kind) {
  NodeManifest manifest = ownNode(id, category, description, ports, kind);
  manifest.origin = NodeOrigin::HuNavSim;
  return manifest;
}

}  // namespace bt
