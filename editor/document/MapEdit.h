#pragma once

#include <memory>
#include <vector>

#include "editor/document/ScenarioDocument.h"
#include "sim2d/map/MapReader.h"

/// Changing the map under the scenario, undoably.
namespace editor {

/// What a brush leaves behind, as values of cells.
enum class MapPaint { Free = 0, Occupied = 100, Unknown = -1 };

/// Cells that were painted and what they become; apart from the map until pushed.
class MapStroke {
 public:
  explicit MapStroke(std::shared_ptr<const sim2d::OccupancyGrid> before);
  /// All cells whose centres lie within `radius` of the way from `from` to `to` [m].
  void paint(const Vec2& from, const Vec2& to, double radius, MapPaint paint);
  struct CellChange {
    std::size_t index;
    std::int8_t value;
  };
  std::vector<CellChange> changes() const;
  bool isOf(const sim2d::OccupancyGrid* map) const { return before_.get() == map; }

 private:
  std::shared_ptr<const sim2d::OccupancyGrid> before_;
  std::vector<std::int8_t> cells_;
};

/// Another map, with the settings that name it.
void pushMap(ScenarioDocument& document, MapState map, ScenarioSettings settings,
             const QString& text);
/// No map any more, and the scenario says so.
void pushOpenPlane(ScenarioDocument& document);
/// Nothing is pushed when no cell would change, or the map has changed under the brush.
void pushStroke(ScenarioDocument& document, const MapStroke& stroke, const QString& text);

/// A room with walls one cell thick around width x height of free ground [m], lower left corner of
/// the free ground at (0, 0).
std::shared_ptr<const sim2d::OccupancyGrid> emptyRoom(double width, double height,
                                                      double resolution = 0.05);
/// An image without a YAML file: dark is occupied, bright is free, as nav2 reads it; `resolution`
/// [m], lower left corner at (0, 0).
base::Result<std::shared_ptr<const sim2d::OccupancyGrid>> gridOfImage(const QString& imagePath,
                                                                      double resolution);

}  // namespace editor
