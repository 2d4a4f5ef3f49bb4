#include "editor/document/MapEdit.h"

#include <cmath>

namespace editor {

namespace {

/// Redo and undo are the same operation: they exchange the current with the stored state.
class SwapCommand : public QUndoCommand {
 public:
  SwapCommand(const QString& text, std::function<void()> swap)
      : QUndoCommand(text), swap_(std::move(swap)) {}
  void redo() override { swap_(); }
  void undo() override { swap_(); }

 private:
  std::function<void()> swap_;
};

}  // namespace

MapStroke::MapStroke(std::shared_ptr<const sim2d::OccupancyGrid> before)
    : before_(std::move(before)), cells_(before_->cells()) {}

void MapStroke::paint(const Vec2& from, const Vec2& to, double radius, MapPaint paint) {
  // Cell coordinates, in which a rotated map has square cells.
  const Vec2 start = before_->worldToCorner(from);
  const Vec2 end = before_->worldToCorner(to);
  const double reach = std::max(radius / before_->resolution(), 0.5);
  const double most = std::max(before_->width(), before_->height()) + reach;
  const auto bound = [most](double value) {
    return static_cast<int>(std::floor(std::clamp(value, -most, most)));
  };
  for (int row = bound(std::min(start.y(), end.y()) - reach);
       row <= bound(std::max(start.y(), end.y()) + reach); ++row) {
    for (int column = bound(std::min(start.x(), end.x()) - reach);
         column <= bound(std::max(start.x(), end.x()) + reach); ++column) {
      const Vec2 centre(column + 0.5, row + 0.5);
      const Vec2 nearest = sim2d::closestOnSegment({start, end}, centre);
      const sim2d::Cell cell{column, row};
      if ((centre - nearest).squaredNorm() <= reach * reach && before_->contains(cell)) {
        cells_[before_->indexOf(cell)] = static_cast<std::int8_t>(paint);
      }
    }
  }
}

std::vector<MapStroke::CellChange> MapStroke::changes() const {
  std::vector<CellChange> changes;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] != before_->cells()[i]) {
      changes.push_back({i, cells_[i]});
    }
  }
  return changes;
}

void pushMap(ScenarioDocument& document, MapState map, ScenarioSettings settings,
             const QString& text) {
  EntitySlot slot{Entity(std::move(settings)), -1};
  const auto swap = [&document, map = std::move(map), slot = std::move(slot)]() mutable {
    slot = document.exchange(kSettingsId, std::move(slot));
    map = document.exchangeMap(std::move(map));  // Receivers of the signal read the settings.
  };
  document.undoStack().push(new SwapCommand(text, swap));
}

void pushNewMap(ScenarioDocument& document, std::shared_ptr<const sim2d::OccupancyGrid> map) {
  ScenarioSettings settings = std::get<ScenarioSettings>(*document.entity(kSettingsId));
  settings.map.reset();
  settings.desktop.mapFile.reset();
  pushMap(document, {std::move(map), {}, false, {}}, std::move(settings),
          QObject::tr("Change map"));
}

void pushOpenPlane(ScenarioDocument& document) {
  ScenarioSettings settings = std::get<ScenarioSettings>(*document.entity(kSettingsId));
  settings.desktop.mapFile = "none";
  pushMap(document, {std::make_shared<sim2d::OccupancyGrid>(), {}, false, {}}, std::move(settings),
          QObject::tr("Use open plane"));
}

void pushStroke(ScenarioDocument& document, const MapStroke& stroke, const QString& text) {
  std::vector<MapStroke::CellChange> changes = stroke.changes();
  if (changes.empty() || !stroke.isOf(document.map().get())) {
    return;
  }
  const auto swap = [&document, changes = std::move(changes)]() mutable {
    MapState state = document.mapState();
    std::vector<std::int8_t> cells = state.grid->cells();
    for (MapStroke::CellChange& change : changes) {
      std::swap(cells[change.index], change.value);
    }
    const sim2d::OccupancyGrid& grid = *state.grid;
    state.grid = std::make_shared<sim2d::OccupancyGrid>(
        grid.width(), grid.height(), grid.resolution(), grid.origin(), std::move(cells));
    document.exchangeMap(std::move(state));
  };
  document.undoStack().push(new SwapCommand(text, swap));
}

std::shared_ptr<const sim2d::OccupancyGrid> emptyRoom(double width, double height,
                                                      double resolution) {
  const int columns = static_cast<int>(std::lround(width / resolution)) + 2;
  const int rows = static_cast<int>(std::lround(height / resolution)) + 2;
  std::vector<std::int8_t> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                                 100);
  for (int row = 1; row < rows - 1; ++row) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(row) * columns + 1;
    std::fill(begin, begin + (columns - 2), std::int8_t{0});
  }
  return std::make_shared<sim2d::OccupancyGrid>(
      columns, rows, resolution, Pose2{Vec2(-resolution, -resolution), 0.0}, std::move(cells));
}

base::Result<std::shared_ptr<const sim2d::OccupancyGrid>> gridOfImage(const QString& imagePath,
                                                                      double resolution) {
  sim2d::MapDescription description;
  description.resolution = resolution;
  const bool isPgm = imagePath.endsWith(QLatin1String(".pgm"), Qt::CaseInsensitive);
  const std::string path = imagePath.toStdString();
  const base::Result<sim2d::MapImage> image = isPgm ? sim2d::readPgm(path) : loadMapImage(path);
  if (!image) {
    return image.diagnostics();
  }
  return {std::make_shared<const sim2d::OccupancyGrid>(
              sim2d::gridFromImage(*image, description, sim2d::MapRule::Humble)),
          image.diagnostics()};
}

}  // namespace editor
