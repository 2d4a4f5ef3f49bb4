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

/// An image, first row on top; grey and alpha values from 0 to `maximum`. Rows are read on request,
/// so that a large image keeps the value size of its file.
struct MapImage {
  int width = 0, height = 0;
  bool isGrey = false;  // one value per pixel; else four: red, green, blue, alpha
  bool hasAlpha = false;
  int maximum = 255;  // value of white or opaque, 1 to 65535
  std::function<void(int row, std::uint16_t* values)> readRow;  // writes `valuesPerRow`

  std::size_t valuesPerRow() const { return static_cast<std::size_t>(width) * (isGrey ? 1U : 4U); }
  /// Sets the values of all rows, row by row.
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
/// Reads a PGM image (P2 and P5, 8 and 16 bit, comments).
base::Result<MapImage> readPgm(const std::string& path);
/// Reads image formats other than PGM: PNG, BMP …
using ImageLoader = std::function<base::Result<MapImage>(const std::string& path)>;

enum class MapMode { Trinary, Scale, Raw };
enum class MapRule { Humble, Main };  // Nav2 version (thresholds and alpha differ)

/// The keys of a map_server YAML.
struct MapDescription {
  std::string image;  // as given in the file
  double resolution = 0.05;
  Pose2 origin;
  bool negate = false;
  double occupiedThreshold = 0.65;
  double freeThreshold = 0.196;
  MapMode mode = MapMode::Trinary;
};

struct MapFile {
  std::string path;       // of the YAML file
  std::string imagePath;  // resolved path
  MapDescription description;
  OccupancyGrid grid;
};

/// Larger images are rejected; PGM before memory is allocated.
constexpr std::int64_t kMaxMapCells = 100'000'000;

/// Reads YAML and image; a leading `~/` of the path means $HOME. Returns the problems of both
/// files; those of the image are reported at the key `image`. PGM is recognised by its content and
/// read here, other formats by `loader` (empty: an error).
base::Result<MapFile> readMap(const std::string& yamlPath, const ImageLoader& loader,
                              MapRule rule = MapRule::Humble);
/// `file` is the file name in messages.
base::Result<MapDescription> parseMapDescription(const std::string& text, const std::string& file);
/// The image must have pixels. Its first row becomes the last cell row.
OccupancyGrid gridFromImage(const MapImage& image, const MapDescription& description, MapRule rule);

/// The files of a map: a PGM image (P5: 254 free, 0 occupied, 205 unknown) and a trinary YAML with
/// thresholds 0.65 and 0.196. An error for the open plane.
base::Result<std::vector<base::FileContent>> mapFileContents(const OccupancyGrid& grid,
                                                             const std::string& yamlPath);

}  // namespace sim2d
