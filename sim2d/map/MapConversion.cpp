// Converts pixels to cells and back.
#include <cassert>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlEmitter.h"
#include "sim2d/map/MapReader.h"

namespace sim2d {

namespace {

constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kFree = 0;
constexpr std::int8_t kOccupied = 100;

/// Converts one pixel by the rules of Nav2's map_io (Humble or main).
class PixelRule {
 public:
  PixelRule(int maximum, bool hasAlpha, const MapDescription& description, MapRule rule)
      : maximum_(maximum),
        hasAlpha_(hasAlpha),
        description_(description),
        isMain_(rule == MapRule::Main) {}

  std::int8_t cellOf(const std::uint16_t* rgba) const {
    const double shade = shadeOf(rgba);
    if (description_.mode == MapMode::Raw) {
      const double value = std::round(255.0 * shade);
      return value <= 100.0 ? static_cast<std::int8_t>(value) : kUnknown;
    }
    const bool isOpaque = !hasAlpha_ || rgba[3] == maximum_;
    if (!isOpaque && (isMain_ || description_.mode == MapMode::Scale)) {
      return kUnknown;
    }
    const double high = description_.occupiedThreshold;
    const double low = description_.freeThreshold;
    const double p = description_.negate ? shade : 1.0 - shade;
    if (p > high || (isMain_ && p == high)) {
      return kOccupied;
    }
    if (p < low || (isMain_ && p == low)) {
      return kFree;
    }
    if (description_.mode == MapMode::Trinary) {
      return kUnknown;
    }
    const double scaled = (p - low) / (high - low) * 100.0;
    return static_cast<std::int8_t>(isMain_ ? std::round(scaled) : std::nearbyint(scaled));
  }

 private:
  double shadeOf(const std::uint16_t* rgba) const {
    const bool isGrey = rgba[0] == rgba[1] && rgba[1] == rgba[2];
    if (isMain_) {  // luma of ITU-R BT.601
      const double grey = isGrey ? rgba[0] : 0.299 * rgba[0] + 0.587 * rgba[1] + 0.114 * rgba[2];
      return grey / maximum_;
    }
    const int sum = rgba[0] + rgba[1] + rgba[2];
    if (hasAlpha_ && description_.mode == MapMode::Trinary) {
      return (sum + rgba[3]) / (4.0 * maximum_);
    }
    return sum / (3.0 * maximum_);
  }

  int maximum_;
  bool hasAlpha_;
  const MapDescription& description_;
  bool isMain_;
};

/// The first pixel row becomes the last cell row. `cellOf` receives the values of one pixel.
template <class CellOf>
OccupancyGrid gridOf(const MapImage& image, const MapDescription& description, CellOf cellOf) {
  assert(image.width > 0 && image.height > 0);
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<std::uint16_t> values(image.valuesPerRow());
  std::vector<std::int8_t> cells(width * static_cast<std::size_t>(image.height));
  for (int row = 0; row < image.height; ++row) {
    image.readRow(row, values.data());
    std::int8_t* cell = cells.data() + width * static_cast<std::size_t>(image.height - 1 - row);
    for (std::size_t at = 0; at < values.size(); at += values.size() / width) {
      *cell++ = cellOf(values.data() + at);
    }
  }
  return OccupancyGrid(image.width, image.height, description.resolution, description.origin,
                       std::move(cells));
}

bool needsQuotes(const std::string& name) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return name.find_first_not_of(kPlain) != std::string::npos || name.front() == '-' ||
         name.front() == '.';
}

std::string withDecimalPoint(double value) {
  const std::string text = base::formatDouble(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string pgmText(const OccupancyGrid& grid) {
  std::string image =
      "P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n";
  image.reserve(image.size() + grid.cells().size());
  for (int row = grid.height() - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width(); ++column) {
      const Cell cell{column, row};
      const int shade = grid.isWall(cell) ? 0 : (grid.isUnknown(cell) ? 205 : 254);
      image += static_cast<char>(shade);
    }
  }
  return image;
}

}  // namespace

OccupancyGrid gridFromImage(const MapImage& image, const MapDescription& description,
                            MapRule rule) {
  const PixelRule pixels(image.maximum, image.hasAlpha, description, rule);
  if (!image.isGrey) {
    return gridOf(image, description,
                  [&pixels](const std::uint16_t* rgba) { return pixels.cellOf(rgba); });
  }
  std::vector<std::int8_t> cellOf;  // indexed by shade
  for (int value = 0; value <= image.maximum; ++value) {
    const auto shade = static_cast<std::uint16_t>(value);
    const std::uint16_t rgba[] = {shade, shade, shade, static_cast<std::uint16_t>(image.maximum)};
    cellOf.push_back(pixels.cellOf(rgba));
  }
  return gridOf(image, description,
                [&cellOf](const std::uint16_t* shade) { return cellOf[*shade]; });
}

base::Result<std::vector<base::FileContent>> mapFileContents(const OccupancyGrid& grid,
                                                             const std::string& yamlPath) {
  if (grid.isEmpty()) {
    return base::error("map.no-cells", {}, yamlPath);
  }
  const std::filesystem::path path(yamlPath);
  const std::string name = path.stem().string() + ".pgm";
  const Pose2& origin = grid.origin();
  const std::string text = "image: " + (needsQuotes(name) ? base::quotedText(name) : name) +
                           "\nmode: trinary\nresolution: " + withDecimalPoint(grid.resolution()) +
                           "\norigin: [" + withDecimalPoint(origin.position.x()) + ", " +
                           withDecimalPoint(origin.position.y()) + ", " +
                           withDecimalPoint(origin.heading) +
                           "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return std::vector<base::FileContent>{{(path.parent_path() / name).string(), pgmText(grid)},
                                        {yamlPath, text}};
}

}  // namespace sim2d
