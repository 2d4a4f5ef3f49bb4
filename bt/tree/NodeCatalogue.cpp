#include "bt/tree/NodeCatalogue.h"

#include <array>
#include <utility>

#include "sim2d/base/Text.h"

namespace bt {

namespace {

/// The name at the place of the enumerator.
template <class Enum, std::size_t count>
const char* nameOf(Enum value, const std::array<const char*, count>& names) {
  return names.at(static_cast<std::size_t>(value));
}

}  // namespace

const char* nodeKindName(NodeKind kind) {
  return nameOf(kind, std::array{"Condition", "Action", "Control", "Decorator", "SubTree"});
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

PortSpec::PortSpec(std::string itsName, PortType itsType, std::string itsUnit, std::string text)
    : name(std::move(itsName)),
      type(itsType),
      unit(std::move(itsUnit)),
      description(std::move(text)) {}

PortSpec& PortSpec::byDefault(const std::string& text) {
  defaultText = text;
  required = false;
  return suggested.empty() ? suggest(text) : *this;
}

PortSpec& PortSpec::suggest(std::string text) {
  suggested = std::move(text);
  return *this;
}

PortSpec& PortSpec::range(double least, double most) {
  min = least;
  max = most;
  return *this;
}

PortSpec& PortSpec::atMost(double most) {
  min.reset();
  max = most;
  return *this;
}

PortSpec& PortSpec::orElse(const char* first, const char* second) {
  replacedBy = {first, second};
  return *this;
}

PortSpec& PortSpec::needed() {
  required = true;
  return *this;
}

PortSpec& PortSpec::directed(PortDirection way) {
  direction = way;
  return *this;
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
