#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/map/MapReader.h"

namespace bt {
namespace {

using sim2d::nav2::BinaryFilterParameters;
using sim2d::nav2::CostmapPlugin;
using sim2d::nav2::FilterMask;
using sim2d::nav2::KeepoutFilterParameters;
using sim2d::nav2::SpeedFilterParameters;

/// Where a filter's mask lies and how it counts; empty: it names none.
std::string maskOf(const CostmapPlugin& filter, FilterMask& mask) {
  if (const auto* const keepout = std::get_if<KeepoutFilterParameters>(&filter.parameters)) {
    return keepout->enabled ? keepout->maskFile : std::string();
  }
  if (const auto* const binary = std::get_if<BinaryFilterParameters>(&filter.parameters)) {
    mask.base = binary->maskBase;
    mask.multiplier = binary->maskMultiplier;
    return binary->enabled ? binary->maskFile : std::string();
  }
  const auto* const speed = std::get_if<SpeedFilterParameters>(&filter.parameters);
  if (speed == nullptr || !speed->enabled) {
    return {};
  }
  mask.base = speed->maskBase;
  mask.multiplier = speed->maskMultiplier;
  mask.isPercentage = speed->maskIsPercentage;
  return speed->maskFile;
}

}  // namespace

Nav2Masks loadNav2Masks(const sim2d::nav2::Nav2Parameters& parameters) {
  namespace fs = std::filesystem;
  Nav2Masks masks;
  const auto load = [&](const std::vector<CostmapPlugin>& filters, sim2d::nav2::FilterMasks& to) {
    for (const CostmapPlugin& filter : filters) {
      FilterMask mask;
      const std::string named = maskOf(filter, mask);
      if (named.empty()) {
        continue;
      }
      const fs::path file = (fs::path(parameters.file).parent_path() / named).lexically_normal();
      base::Result<sim2d::MapFile> map = sim2d::readMap(file.string(), {});
      base::append(masks.problems, map.diagnostics());
      if (map) {
        mask.grid = std::move(map->grid);
        masks.files.insert(masks.files.end(), {file.string(), map->imagePath});
        to[filter.name] = std::move(mask);
      }
    }
  };
  load(parameters.localCostmap.filters, masks.local);
  load(parameters.globalCostmap.filters, masks.global);
  return masks;
}

}  // namespace bt
