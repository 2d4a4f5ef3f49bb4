#include "sim2d/map/GoalSearch.h"

namespace sim2d {

void CellCosts::set(Terrain::Index index, std::uint32_t cost) {
  const auto cell = static_cast<std::size_t>(index);
  std::unique_ptr<Tile>& tile = tiles_[cell / kTile];
  if (!tile) {
    tile = std::make_unique<Tile>();
    tile->fill(kNone);
    ++made_;
  }
  (*tile)[cell % kTile] = cost;
}

}  // namespace sim2d
