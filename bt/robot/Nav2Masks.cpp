#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/nav/nav2/params/NamedFiles.h"

namespace bt {
namespace {

using sim2d::nav2::BinaryFilterParameters;
using sim2d::nav2::CostmapPlugin;
using sim2d::nav2::FilterMask;
using sim2d::nav2::KeepoutFilterParameters;
using sim2d::nav2::SpeedFilterParameters;

/// Where a filter's mask lies and how it counts.
struct NamedMask {
  std::string file;          // empty: none
  bool isPublished = false;  // by a node, else named in the filter's block
  FilterMask mask;
};
NamedMask maskOf(const CostmapPlugin& filter) {
  const auto* const keepout = std::get_if<KeepoutFilterParameters>(&filter.parameters);
  if (keepout != nullptr && keepout->enabled) {
    return {keepout->maskFile, keepout->isMaskPublished, {}};
  }
  if (const auto* const binary = std::get_if<BinaryFilterParameters>(&filter.parameters)) {
    FilterMask mask;
    mask.base = binary->maskBase;
    mask.multiplier = binary->maskMultiplier;
    return {binary->enabled ? binary->maskFile : std::string(), binary->isMaskPublished, mask};
  }
  const auto* const speed = std::get_if<SpeedFilterParameters>(&filter.parameters);
  if (speed == nullptr || !speed->enabled) {
    return {};
  }
  NamedMask named{speed->maskFile, speed->isMaskPublished, {}};
  named.mask.base = speed->maskBase;
  named.mask.multiplier = speed->maskMultiplier;
  named.mask.isPercentage = speed->maskIsPercentage;
  return named;
}

}  // namespace

Nav2Masks loadNav2Masks(const sim2d::nav2::Nav2Parameters& parameters) {
  Nav2Masks masks;
  const auto load = [&](const std::vector<CostmapPlugin>& filters, sim2d::nav2::FilterMasks& to) {
    for (const CostmapPlugin& filter : filters) {
      NamedMask named = maskOf(filter);
      if (named.file.empty()) {
        continue;
      }
      const std::string folder = std::filesystem::path(parameters.file).parent_path().string();
      std::string file = sim2d::nav2::findNamedFile(named.file, {folder}).file;
      if (file.empty() && named.isPublished) {  // a path of the robot's computer
        masks.problems.push_back(
            base::warning("nav2.mask-not-found", {filter.name, named.file}, parameters.file));
        continue;
      }
      file = file.empty() ? (std::filesystem::path(folder) / named.file).string() : file;
      base::Result<sim2d::MapFile> map = sim2d::readMap(file, {});
      base::append(masks.problems, map.diagnostics());
      if (map) {
        named.mask.grid = std::move(map->grid);
        masks.files.insert(masks.files.end(), {file, map->imagePath});
        to[filter.name] = std::move(named.mask);
      }
    }
  };
  load(parameters.localCostmap.filters, masks.local);
  load(parameters.globalCostmap.filters, masks.global);
  return masks;
}

}  // namespace bt
