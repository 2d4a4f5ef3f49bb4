#include "bt/tree/NodeCatalogue.h"

#include <utility>

#include "sim2d/base/Text.h"

namespace bt {

const char* nodeKindName(NodeKind kind) {
  switch (kind) {
    case NodeKind::Condition:
      return "Condition";
    case NodeKind::Action:
      return "Action";
    case NodeKind::Control:
      return "Control";
    case NodeKind::Decorator:
      return "Decorator";
    case NodeKind::SubTree:
      return "SubTree";
  }
  return "";
}

const char* portDirectionTag(PortDirection direction) {
  switch (direction) {
    case PortDirection::Input:
      return "input_port";
    case PortDirection::Output:
      return "output_port";
    case PortDirection::InOut:
      return "inout_port";
  }
  return "";
}

const char* portTypeName(PortType type) {
  switch (type) {
    case PortType::Int:
      return "int";
    case PortType::Unsigned:
      return "unsigned int";
    case PortType::Double:
      return "double";
    case PortType::Bool:
      return "bool";
    case PortType::Status:
      return "NodeStatus";
    case PortType::String:
    case PortType::Queue:
      return "std::string";
    case PortType::Any:
      return "";
  }
  return "";
}

const char* nodeOriginName(NodeOrigin origin) {
  switch (origin) {
    case NodeOrigin::BehaviorTreeCpp:
      return "BehaviorTree.CPP";
    case NodeOrigin::HuNavSim:
      return "HuNavSim";
    case NodeOrigin::Ours:
      return "HuNavSim Desktop";
  }
  return "";
}

int NodeManifest::portIndex(std::string_view name) const {
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (ports[i].name == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

const PortSpec* NodeManifest::port(std::string_view name) const {
  const int index = portIndex(name);
  return index < 0 ? nullptr : &ports[static_cast<std::size_t>(index)];
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

}  // namespace bt
