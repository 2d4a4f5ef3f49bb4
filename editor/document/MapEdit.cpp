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

/// Returns true if the format implies grey, opaque pixels.
bool isGrey(const QImage& image) {
  return image.format() == QImage::Format_Grayscale8 ||
         image.format() == QImage::Format_Grayscale16;
}

/// Converts row by row: a wide copy of a large image would take a gigabyte.
sim2d::MapImage toMapImage(const QImage& image) {
  sim2d::MapImage result;
  result.width = image.width();
  result.height = image.height();
  result.isGrey = isGrey(image);
  result.hasAlpha = image.hasAlphaChannel();
  const bool deep = image.depth() > 32 || image.format() == QImage::Format_Grayscale16;
  result.maximum = deep ? 65535 : 255;
  if (image.format() == QImage::Format_Grayscale8) {
    result.readRow = [image](int row, std::uint16_t* values) {
      std::copy_n(image.constScanLine(row), image.width(), values);
    };
    return result;
  }
  const int shift = deep ? 0 : 8;
  const int step = result.isGrey ? 4 : 1;  // Uses only the first of four channels.
  result.readRow = [image, shift, step](int row, std::uint16_t* values) {
    const QImage wide = image.copy(0, row, image.width(), 1).convertToFormat(QImage::Format_RGBA64);
    const auto* channels = reinterpret_cast<const quint16*>(wide.constScanLine(0));
    for (int i = 0; i < 4 * wide.width(); i += step) {
      *values++ = static_cast<std::uint16_t>(channels[i] >> shift);
    }
  };
  return result;
}

struct Format {
  const char* name;
  int place;  // Byte offset [B].
  const char* bytes;
};

/// Formats detected by content that Qt does not read, or reads only with plugins.
constexpr Format kOthers[] = {
    {"TIFF", 0, "II*"},      {"TIFF", 0, "MM"},       {"WebP", 8, "WEBP"},
    {"AVIF", 4, "ftypavif"}, {"HEIF", 4, "ftyphei"},  {"JPEG 2000", 4, "jP  "},
    {"GIF", 0, "GIF8"},      {"JPEG", 0, "\xFF\xD8"}, {"XCF (GIMP)", 0, "gimp xcf"},
    {"PDF", 0, "%PDF"},      {"SVG", 0, "<svg"},      {"Photoshop", 0, "8BPS"}};

/// "TIFF"; null if the format is unknown.
const char* formatOf(const QString& path) {
  QFile file(path);
  const QByteArray begin = file.open(QIODevice::ReadOnly) ? file.read(16) : QByteArray();
  const auto* const found =
      std::find_if(std::begin(kOthers), std::end(kOthers), [&](const Format& format) {
        return begin.mid(format.place, static_cast<int>(qstrlen(format.bytes))) == format.bytes;
      });
  return found == std::end(kOthers) ? nullptr : found->name;
}

/// "PGM, PNG, JPEG, BMP": the common formats that this installation supports.
std::string knownFormats() {
  const QList<QByteArray> supported = QImageReader::supportedImageFormats();
  std::string names = "PGM";
  for (const char* const name : {"PNG", "JPEG", "BMP", "GIF", "PPM"}) {
    names += supported.contains(QByteArray(name).toLower()) ? std::string(", ") + name : "";
  }
  return names;
}

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

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  QImageReader reader(QString::fromStdString(path));
  reader.setDecideFormatFromContent(true);
  const QSize size = reader.size();
  if (size.isValid() && qint64{size.width()} * size.height() > sim2d::kMaxMapCells) {
    return base::error("image.too-large", {size.width(), size.height(), sim2d::kMaxMapCells}, path);
  }
  const QImage image = reader.read();
  const char* const format = image.isNull() ? formatOf(reader.fileName()) : nullptr;
  if (format != nullptr && reader.error() == QImageReader::UnsupportedFormatError) {
    return base::error("image.format", {format, knownFormats()}, path);
  }
  if (image.isNull()) {
    return base::error("image.cannot-read", {reader.errorString().toStdString()}, path);
  }
  return toMapImage(image);
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
