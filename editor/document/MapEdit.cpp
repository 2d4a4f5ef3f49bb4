#include "editor/document/MapEdit.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <QFileInfo>

#include "editor/document/DocumentDisk.h"
#include "editor/document/QtImageLoader.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace editor {

namespace {

/// Squared distance of `point` from the way between two points.
double squaredDistance(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const double length = way.squaredNorm();
  const double along = length > 0.0 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0.0;
  const Vec2 nearest = from + along * way;
  return (point - nearest).squaredNorm();
}

/// Other cells on the ground of a grid.
std::shared_ptr<const sim2d::OccupancyGrid> withCells(const sim2d::OccupancyGrid& grid,
                                                      std::vector<std::int8_t> cells) {
  return std::make_shared<sim2d::OccupancyGrid>(grid.width(), grid.height(), grid.resolution(),
                                                grid.origin(), std::move(cells));
}

}  // namespace

MapStroke::MapStroke(std::shared_ptr<const sim2d::OccupancyGrid> before)
    : before_(std::move(before)), cells_(before_->cells()) {}

void MapStroke::set(sim2d::Cell cell, MapPaint paint) {
  if (!before_->contains(cell)) {
    return;
  }
  const std::size_t index = before_->indexOf(cell);
  const auto value = static_cast<std::int8_t>(paint);
  if (cells_[index] != value) {
    cells_[index] = value;
    changed_.push_back({index, value});
  }
}

void MapStroke::paint(const Vec2& from, const Vec2& to, double radius, MapPaint paint) {
  // cell coordinates, where the map may be turned but squares stay squares
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
      if (squaredDistance(centre, start, end) <= reach * reach) {
        set({column, row}, paint);
      }
    }
  }
}

void MapStroke::fill(const Vec2& corner, const Vec2& opposite, MapPaint paint) {
  const Vec2 a = before_->worldToCorner(corner);
  const Vec2 b = before_->worldToCorner(opposite);
  const int left = std::max(0, static_cast<int>(std::ceil(std::min(a.x(), b.x()) - 0.5)));
  const int bottom = std::max(0, static_cast<int>(std::ceil(std::min(a.y(), b.y()) - 0.5)));
  for (int row = bottom; row < before_->height() && row + 0.5 <= std::max(a.y(), b.y()); ++row) {
    for (int column = left; column < before_->width() && column + 0.5 <= std::max(a.x(), b.x());
         ++column) {
      set({column, row}, paint);
    }
  }
}

std::shared_ptr<const sim2d::OccupancyGrid> MapStroke::grid() const {
  return withCells(*before_, cells_);
}

EditMap::EditMap(ScenarioDocument& document, MapState map, ScenarioSettings settings,
                 const QString& text)
    : QUndoCommand(text), document_(document), map_(std::move(map)) {
  settings_.value = Entity(std::move(settings));
}

void EditMap::swap() {
  settings_ = document_.exchange(kSettingsId, std::move(settings_));
  map_ = document_.exchangeMap(std::move(map_));  // who hears of it reads the settings
}

PaintMap::PaintMap(ScenarioDocument& document, const MapStroke& stroke, const QString& text)
    : QUndoCommand(text), document_(document) {
  std::unordered_map<std::size_t, std::int8_t> last;
  for (const MapStroke::CellChange& change : stroke.changes()) {
    last[change.index] = change.value;
  }
  for (const auto& [index, value] : last) {
    if (document.map()->cells()[index] != value) {
      cells_.push_back({index, value});
    }
  }
  setObsolete(cells_.empty());
}

void PaintMap::swap() {
  MapState state = document_.mapState();
  std::vector<std::int8_t> cells = state.grid->cells();
  for (MapStroke::CellChange& change : cells_) {
    std::swap(cells[change.index], change.value);
  }
  state.grid = withCells(*state.grid, std::move(cells));
  document_.exchangeMap(std::move(state));
}

void pushMap(ScenarioDocument& document, MapState map, ScenarioSettings settings,
             const QString& text) {
  document.undoStack().push(new EditMap(document, std::move(map), std::move(settings), text));
}

void pushOpenPlane(ScenarioDocument& document) {
  ScenarioSettings settings = std::get<ScenarioSettings>(*document.entity(kSettingsId));
  settings.desktop.mapFile = "none";
  pushMap(document, {std::make_shared<sim2d::OccupancyGrid>(), {}, false, {}}, std::move(settings),
          QObject::tr("Open plane"));
}

void pushStroke(ScenarioDocument& document, const MapStroke& stroke, const QString& text) {
  auto command = std::make_unique<PaintMap>(document, stroke, text);
  if (!command->isObsolete()) {
    document.undoStack().push(command.release());
  }
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

std::shared_ptr<const sim2d::OccupancyGrid> rescaled(const sim2d::OccupancyGrid& grid,
                                                     double resolution, const Pose2& origin) {
  return std::make_shared<sim2d::OccupancyGrid>(grid.width(), grid.height(), resolution, origin,
                                                grid.cells());
}

base::Result<MapState> readMapFile(const QString& yamlPath, DocumentDisk& disk,
                                   sim2d::MapRule rule) {
  const QString path = QFileInfo(yamlPath).absoluteFilePath();
  base::Result<sim2d::MapFile> map = sim2d::readMap(path.toStdString(), loadMapImage, rule);
  if (!map) {
    return map.diagnostics();
  }
  MapState state{std::make_shared<sim2d::OccupancyGrid>(std::move(map->grid)), path, false,
                 map.diagnostics()};
  disk.maps[path] = state.grid;
  disk.mapImage = QFileInfo(QString::fromStdString(map->imagePath)).absoluteFilePath();
  disk.noteFile(path);
  disk.noteFile(disk.mapImage);
  return {std::move(state), map.diagnostics()};
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
