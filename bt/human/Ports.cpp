#include "bt/human/Ports.h"

#include "sim2d/base/Types.h"

namespace bt {

Port& Port::byDefault(const char* text) {
  spec_.defaultText = text;
  if (spec_.suggested.empty()) {
    spec_.suggested = text;
  }
  return *this;
}

Port& Port::suggest(const char* text) {
  spec_.suggested = text;
  return *this;
}

Port& Port::range(double min, double max) {
  spec_.min = min;
  spec_.max = max;
  return *this;
}

Port& Port::atMost(double max) {
  spec_.min.reset();
  spec_.max = max;
  return *this;
}

Port& Port::orElse(const char* first, const char* second) {
  spec_.replacedBy = {first, second};
  return *this;
}

Port& Port::required() {
  spec_.required = true;
  return *this;
}

Port& Port::output() {
  spec_.direction = PortDirection::Output;
  return *this;
}

namespace port {

Port person(const char* name, const char* description, const char* suggested) {
  return Port(name, PortType::Int, "", description).required().suggest(suggested);
}

Port agent() {
  return person("agent_id", "Id of the person who acts or perceives.");
}

Port timeStep() {
  return Port("time_step", PortType::Double, "s",
              "Step length for HuNavSim; here the step of the simulation counts.")
      .suggest("{dt}");
}

Port length(const char* name, const char* description) {
  return Port(name, PortType::Double, "m", description).range(0.0, 1000.0);
}

Port speed(const char* name, const char* description) {
  return Port(name, PortType::Double, "m/s", description).range(0.0, 10.0);
}

Port duration(const char* name, const char* description) {
  return Port(name, PortType::Double, "s", description).range(0.0, 36000.0);
}

Port openDuration(const char* name, const char* description) {
  return duration(name, description).atMost(36000.0);
}

Port lasting() {
  return openDuration("duration", "Ends after this time; 0 = goes on.")
      .byDefault("0.0")
      .suggest("5.0");
}

Port angle(const char* name, const char* description) {
  return Port(name, PortType::Double, "rad", description).range(0.0, base::kPi);
}

Port goal(const char* description, const char* x, const char* y) {
  return Port("goal_id", PortType::Int, "", description).suggest("1").orElse(x, y);
}

Port oldX(const char* name) {
  return Port(name, PortType::Double, "m", "x of a point, when no goal_id is given.");
}

Port oldY(const char* name) {
  return Port(name, PortType::Double, "m", "y of a point, when no goal_id is given.");
}

Port others() {
  return Port("non_main_agent_ids", PortType::Any, "",
              "Ids of the other members, with commas between them.");
}

Port unused(const char* name, PortType type, const char* unit) {
  return Port(name, type, unit, "Accepted for existing files; has no effect.");
}

}  // namespace port

namespace {

NodeManifest makeManifest(const char* id, const char* category, const char* description,
                          std::initializer_list<PortSpec> ports, NodeKind kind) {
  NodeManifest manifest;
  manifest.id = id;
  manifest.kind = kind;
  manifest.category = category;
  manifest.description = description;
  manifest.ports = ports;
  return manifest;
}

}  // namespace

NodeManifest humanNode(const char* id, const char* category, const char* description,
                       std::initializer_list<PortSpec> ports, NodeKind kind) {
  NodeManifest manifest = makeManifest(id, category, description, ports, kind);
  manifest.origin = NodeOrigin::HuNavSim;
  return manifest;
}

NodeManifest ownNode(const char* id, const char* category, const char* description,
                     std::initializer_list<PortSpec> ports, NodeKind kind) {
  return makeManifest(id, category, description, ports, kind);
}

}  // namespace bt
