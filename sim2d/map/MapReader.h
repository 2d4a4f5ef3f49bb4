#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/map/OccupancyGrid.h"

namespace sim2d {

/// An image file, first row on top; shade and alpha in 0..1 steps of 1/maximum. Its values are
/// asked for row by row, so that those of a large image stay as narrow as the file has them.
struct MapImage {
  int width = 0, height = 0;
  bool isGrey = false;  // one value per pixel, else four: red, green, blue, alpha
  bool hasAlpha = false;
  int maximum = 255;  // value of full white or opaque, 1..65535
  std::function<void(int row, std::uint16_t* values)> readRow;  // writes `valuesPerRow`

  std::size_t valuesPerRow() const { return static_cast<std::size_t>(width) * (isGrey ? 1U : 4U); }
  /// Those of all rows, one after the other.
  template <class Value>
  void setValues(std::vector<Value> values);
};
template <class Value>
void MapImage::setValues(std::vector<Value> values) {
  const auto kept = std::make_shared<const std::vector<Value>>(std::move(values));
  readRow = [kept, count = valuesPerRow()](int row, std::uint16_t* to) {
    std::copy_n(kept->data() + static_cast<std::size_t>(row) * count, count, to);
  };
}
/// A PGM image (P2 and P5, 8 and 16 bit, comments), which is grey.
base::Result<MapImage> readPgm(const std::string& path);
/// Reads what the reader itself does not (all but PGM): PNG, BMP …
using ImageLoader = std::function<base::Result<MapImage>(const std::string& path)>;

enum class MapMode { Trinary, Scale, Raw };
enum class MapRule { Humble, Main };  // which nav2 decides (differences: thresholds, alpha)

/// The keys of a map_server YAML.
struct MapDescription {
  std::string image;  // as written
  double resolution = 0.05;
  Pose2 origin;
  bool negate = false;
  double occupiedThreshold = 0.65;
  double freeThreshold = 0.196;
  MapMode mode = MapMode::Trinary;
};

struct MapFile {
  std::string path;       // of the YAML
  std::string imagePath;  // resolved
  MapDescription description;
  OccupancyGrid grid;
};

/// More pixels than this are refused with a message, PGM before memory is taken for them.
constexpr std::int64_t kMostMapCells = 100'000'000;

/// Reads YAML and image; a leading `~/` of the path stands for $HOME. All problems of both files
/// come at once; those of the image carry the place of the key `image`. PGM (P2, P5, 8 and 16 bit,
/// comments) is read here whatever it is called, other formats by `loader` (none: an error).
base::Result<MapFile> readMap(const std::string& yamlPath, const ImageLoader& loader,
                              MapRule rule = MapRule::Humble);
/// `file` names the text in messages.
base::Result<MapDescription> parseMapDescription(const std::string& text, const std::string& file);
/// The image must have pixels. First row on top becomes the last row of cells.
OccupancyGrid gridFromImage(const MapImage& image, const MapDescription& description, MapRule rule);

/// A map as files: the image as PGM (P5: 254 free, 0 occupied, 205 unknown; thresholds 0.65 and
/// 0.196, trinary), then the YAML. An error for the open plane.
base::Result<std::vector<base::FileContent>> mapFileContents(const OccupancyGrid& grid,
                                                             const std::string& yamlPath);

}  // namespace sim2d
