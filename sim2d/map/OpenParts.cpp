#include "sim2d/map/OpenParts.h"

namespace sim2d {

OpenParts::OpenParts(const Terrain& terrain) : parts_(terrain.size(), 0) {
  std::int32_t part = 0;
  for (Terrain::Index index = 0; index < static_cast<Terrain::Index>(parts_.size()); ++index) {
    if (terrain.isOpen(index) && partOf(index) == 0) {
      fill(terrain, index, ++part);
    }
  }
}

/// The closed cells all round a terrain keep the search inside.
void OpenParts::fill(const Terrain& terrain, Terrain::Index from, std::int32_t part) {
  std::vector<Terrain::Index> waiting{from};
  parts_[static_cast<std::size_t>(from)] = part;
  while (!waiting.empty()) {
    const Terrain::Index at = waiting.back();
    waiting.pop_back();
    for (const Terrain::Index next :
         {at - 1, at + 1, at - terrain.stride(), at + terrain.stride()}) {
      if (terrain.isOpen(next) && partOf(next) == 0) {
        parts_[static_cast<std::size_t>(next)] = part;
        waiting.push_back(next);
      }
    }
  }
}

}  // namespace sim2d
