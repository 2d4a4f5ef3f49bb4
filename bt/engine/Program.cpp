#include "bt/engine/Program.h"

#include <algorithm>

namespace bt {

const std::string& Program::label(int node) const {
  return origins_[static_cast<std::size_t>(node)].label;
}

const NodeManifest& Program::manifest(int node) const {
  const int index = origins_[static_cast<std::size_t>(node)].manifest;
  return manifests_[static_cast<std::size_t>(index)];
}

const std::string& Program::treeOf(int node) const {
  return origins_[static_cast<std::size_t>(node)].tree;
}

int Program::lineOf(int node) const {
  return origins_[static_cast<std::size_t>(node)].line;
}

int Program::findSlot(std::string_view key) const {
  const auto place = std::find_if(entries_.begin(), entries_.end(),
                                  [key](const Entry& entry) { return entry.key == key; });
  return place == entries_.end() ? -1 : place->slot;
}

}  // namespace bt
