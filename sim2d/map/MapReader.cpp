#include "sim2d/map/MapReader.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <yaml-cpp/yaml.h>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/Pgm.h"

namespace sim2d {

namespace {

constexpr double kFinest = 0.001, kCoarsest = 10.0;  // [m/pixel]
constexpr double kFarthest = 1e6;                    // [m]

namespace fs = std::filesystem;

const std::vector<std::string>& mapKeys() {
  static const std::vector<std::string> keys = {
      "image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"};
  return keys;
}

/// The keys of one YAML text with all that is wrong with them.
class DescriptionReader {
 public:
  explicit DescriptionReader(std::string file) : file_(std::move(file)) {}

  void read(const std::string& text) {
    try {
      root_ = YAML::Load(text);
    } catch (const YAML::Exception& exception) {
      error("map.not-yaml", {exception.msg}, exception.mark);
      return;
    }
    if (!root_.IsMap()) {
      error("map.no-keys", {}, root_.IsNull() ? YAML::Mark::null_mark() : root_.Mark());
      return;
    }
    checkKeys();
    readImage();
    readResolution();
    readOrigin();
    readNegate();
    readThresholds();
    readMode();
  }

  const MapDescription& description() const { return description_; }
  const base::Diagnostics& diagnostics() const { return diagnostics_; }
  /// With the place of the image's name.
  base::Diagnostic atImage(base::Diagnostic problem, const std::string& image) const {
    return base::within("image '" + image + "'", located(std::move(problem), imageMark_));
  }

 private:
  base::Diagnostic located(base::Diagnostic diagnostic, const YAML::Mark& mark) const {
    diagnostic.file = file_;
    diagnostic.line = mark.is_null() ? 0 : mark.line + 1;
    diagnostic.column = mark.is_null() ? 0 : mark.column + 1;
    return diagnostic;
  }

  void error(std::string_view code, base::ProblemValues values, const YAML::Mark& mark) {
    diagnostics_.push_back(located(base::error(code, std::move(values)), mark));
  }
  void warning(std::string_view code, base::ProblemValues values, const YAML::Mark& mark) {
    diagnostics_.push_back(located(base::warning(code, std::move(values)), mark));
  }

  void checkKeys() {
    std::set<std::string> seen;
    for (const auto& entry : root_) {
      if (!entry.first.IsScalar()) {
        error("map.key-no-word", {}, entry.first.Mark());
        continue;
      }
      const std::string key = entry.first.Scalar();
      if (!seen.insert(key).second) {
        error("map.key-twice", {key}, entry.first.Mark());
        continue;
      }
      const std::optional<std::string> near = base::nearestName(key, mapKeys());
      if (!near || *near != key) {
        warning("map.unknown-key", {key, near}, entry.first.Mark());
      }
    }
    for (const std::string& key : mapKeys()) {
      if (seen.count(key) == 0 && key != "mode") {
        error("map.key-missing", {key}, YAML::Mark::null_mark());
      }
    }
  }

  /// The value of a key; none when it is missing, which checkKeys has said.
  std::optional<YAML::Node> find(const std::string& key) const {
    for (const auto& entry : root_) {
      if (entry.first.IsScalar() && entry.first.Scalar() == key) {
        return entry.second;
      }
    }
    return std::nullopt;
  }

  std::optional<double> number(const YAML::Node& node, const char* key) {
    const std::optional<double> value =
        node.IsScalar() ? base::parseDouble(node.Scalar()) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      error(node.IsScalar() ? "map.not-a-number" : "map.no-number",
            node.IsScalar() ? base::ProblemValues{key, node.Scalar()} : base::ProblemValues{key},
            node.Mark());
      return std::nullopt;
    }
    return value;
  }

  void readImage() {
    const std::optional<YAML::Node> node = find("image");
    if (!node) {
      return;
    }
    imageMark_ = node->Mark();
    if (!node->IsScalar() || node->Scalar().empty()) {
      error("map.no-image-name", {}, node->Mark());
      return;
    }
    description_.image = node->Scalar();
  }

  void readResolution() {
    const std::optional<YAML::Node> node = find("resolution");
    const std::optional<double> value = node ? number(*node, "resolution") : std::nullopt;
    if (value && *value <= 0.0) {
      error("map.resolution-not-positive", {node->Scalar()}, node->Mark());
    } else if (value && !(*value >= kFinest && *value <= kCoarsest)) {
      error("map.resolution-out-of-range", {node->Scalar()}, node->Mark());
    } else if (value) {
      description_.resolution = *value;
    }
  }

  void readOrigin() {
    const std::optional<YAML::Node> node = find("origin");
    if (!node) {
      return;
    }
    if (!node->IsSequence() || node->size() != 3) {
      error("map.bad-origin", {}, node->Mark());
      return;
    }
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::optional<double> value = number((*node)[i], "origin");
      if (!value) {
        return;
      }
      values[i] = *value;
    }
    if (std::fabs(values[0]) > kFarthest || std::fabs(values[1]) > kFarthest) {
      error("map.origin-too-far", {}, node->Mark());
      return;
    }
    description_.origin.position = {values[0], values[1]};
    description_.origin.heading = base::wrapToPi(values[2]);
    if (values[2] != 0.0) {
      warning("map.turned", {values[2]}, (*node)[2].Mark());
    }
  }

  void readNegate() {
    const std::optional<YAML::Node> node = find("negate");
    if (!node) {
      return;
    }
    const std::string word = node->IsScalar() ? base::lowered(node->Scalar()) : std::string();
    const std::optional<long long> value = base::parseInt(word);
    if (value) {
      description_.negate = *value != 0;
    } else if (word == "true" || word == "yes" || word == "on") {
      description_.negate = true;
    } else if (word != "false" && word != "no" && word != "off") {
      error("map.bad-negate", {}, node->Mark());
    }
  }

  void readThresholds() {
    const std::optional<YAML::Node> occupied = find("occupied_thresh");
    const std::optional<YAML::Node> free = find("free_thresh");
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const double high = occupied ? number(*occupied, "occupied_thresh").value_or(kNone) : kNone;
    const double low = free ? number(*free, "free_thresh").value_or(kNone) : kNone;
    if (std::isnan(high) || std::isnan(low)) {
      return;
    }
    if (low < 0.0 || low >= high || high > 1.0) {
      error("map.bad-thresholds", {low, high}, free->Mark());
      return;
    }
    description_.occupiedThreshold = high;
    description_.freeThreshold = low;
  }

  void readMode() {
    const std::optional<YAML::Node> node = find("mode");
    if (!node) {
      return;
    }
    const std::string word = node->IsScalar() ? base::lowered(node->Scalar()) : std::string();
    if (word == "trinary") {
      description_.mode = MapMode::Trinary;
    } else if (word == "scale") {
      description_.mode = MapMode::Scale;
    } else if (word == "raw") {
      description_.mode = MapMode::Raw;
    } else {
      error("map.bad-mode", {}, node->Mark());
    }
  }

  std::string file_;
  YAML::Node root_;
  YAML::Mark imageMark_ = YAML::Mark::null_mark();
  MapDescription description_;
  base::Diagnostics diagnostics_;
};

bool isPgm(const fs::path& path) {
  std::ifstream input(path, std::ios::binary);
  std::array<char, 2> magic{};
  input.read(magic.data(), magic.size());
  return input && magic[0] == 'P' && (magic[1] == '2' || magic[1] == '5');
}

base::Result<MapImage> loadImage(const fs::path& path, const ImageLoader& loader) {
  if (!loader) {
    return base::error("image.only-pgm");
  }
  base::Result<MapImage> image = loader(path.string());
  if (!image) {
    return image;
  }
  const std::int64_t pixels = std::int64_t{image->width} * image->height;
  if (pixels > kMostMapCells) {
    return base::error("image.too-large");
  }
  if (pixels <= 0 || image->maximum < 1 ||
      image->rgba.size() != 4 * static_cast<std::size_t>(pixels)) {
    return base::error("image.no-pixels");
  }
  return image;
}

/// The cells of the image, whatever kind of file it is.
base::Result<OccupancyGrid> readCells(const fs::path& path, const ImageLoader& loader,
                                      const MapDescription& description, MapRule rule) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return base::error("image.missing");
  }
  if (!fs::is_regular_file(status)) {
    return base::error("image.no-file");
  }
  if (fs::file_size(path, code) == 0 && !code) {
    return base::error("image.file-empty");
  }
  if (isPgm(path) || base::lowered(path.extension().string()) == ".pgm") {
    const base::Result<PgmImage> image = readPgmShades(path.string());
    return image ? base::Result<OccupancyGrid>(gridFromPgm(*image, description, rule),
                                               image.diagnostics())
                 : image.diagnostics();
  }
  const base::Result<MapImage> image = loadImage(path, loader);
  return image ? base::Result<OccupancyGrid>(gridFromImage(*image, description, rule),
                                             image.diagnostics())
               : image.diagnostics();
}

std::string withHome(const std::string& path) {
  const char* home = path.compare(0, 2, "~/") == 0 ? std::getenv("HOME") : nullptr;
  return home != nullptr ? home + path.substr(1) : path;
}

}  // namespace

base::Result<MapDescription> parseMapDescription(const std::string& text, const std::string& file) {
  DescriptionReader reader(file);
  reader.read(text);
  if (base::hasErrors(reader.diagnostics())) {
    return reader.diagnostics();
  }
  return {reader.description(), reader.diagnostics()};
}

base::Result<MapFile> readMap(const std::string& yamlPath, const ImageLoader& loader,
                              MapRule rule) {
  MapFile map;
  map.path = withHome(yamlPath);
  const base::Result<std::string> text = base::readTextFile(map.path);
  if (!text) {
    return text.diagnostics();
  }
  DescriptionReader reader(map.path);
  reader.read(*text);
  base::Diagnostics diagnostics = reader.diagnostics();
  map.description = reader.description();
  if (map.description.image.empty()) {
    return diagnostics;
  }
  const fs::path imagePath = fs::path(map.path).parent_path() / map.description.image;
  map.imagePath = imagePath.lexically_normal().string();
  base::Result<OccupancyGrid> grid = readCells(map.imagePath, loader, map.description, rule);
  for (const base::Diagnostic& problem : grid.diagnostics()) {
    diagnostics.push_back(reader.atImage(problem, map.imagePath));
  }
  if (base::hasErrors(diagnostics)) {
    return diagnostics;
  }
  map.grid = *std::move(grid);
  return {std::move(map), std::move(diagnostics)};
}

}  // namespace sim2d
