#pragma once

#include "editor/document/MapImageReader.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/map/MapReader.h"

/// Undoable changes of the map.
namespace editor {

/// The cell values that a brush writes.
enum class MapPaint { Free = 0, Occupied = 100, Unknown = -1 };

/// The painted cells and their new values, separate from the map until pushed.
class MapStroke {
 public:
  explicit MapStroke(std::shared_ptr<const sim2d::OccupancyGrid> before);
  /// Paints all cells whose centres lie within `radius` of the segment from `from` to `to` [m].
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

/// Replaces the map, together with the settings that name it.
void pushMap(ScenarioDocument& document, MapState map, ScenarioSettings settings,
             const QString& text);
/// Replaces the map by one that is not in a file yet; a save writes it beside the scenario.
void pushNewMap(ScenarioDocument& document, std::shared_ptr<const sim2d::OccupancyGrid> map);
/// Removes the map and its name from the scenario.
void pushOpenPlane(ScenarioDocument& document);
/// Pushes nothing if no cell would change, or if the map has been replaced during the stroke.
void pushStroke(ScenarioDocument& document, const MapStroke& stroke, const QString& text);

/// A room with one-cell walls around a free area of width x height [m]; the lower left corner of
/// the free area is at (0, 0).
std::shared_ptr<const sim2d::OccupancyGrid> emptyRoom(double width, double height,
                                                      double resolution = 0.05);
/// A map from an image without a YAML file: dark is occupied and bright is free, as in nav2;
/// `resolution` [m], lower left corner at (0, 0).
base::Result<std::shared_ptr<const sim2d::OccupancyGrid>> gridOfImage(const QString& imagePath,
                                                                      double resolution);

}  // namespace editor
