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
      add(base::Severity::Error, "not readable as YAML: " + exception.msg, exception.mark);
      return;
    }
    if (!root_.IsMap()) {
      add(base::Severity::Error, "a map file must hold keys and values (image, resolution …)",
          root_.IsNull() ? YAML::Mark::null_mark() : root_.Mark());
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
  base::Diagnostic atImage(base::Severity severity, const std::string& message) const {
    return located(severity, message, imageMark_);
  }

 private:
  base::Diagnostic located(base::Severity severity, const std::string& message,
                           const YAML::Mark& mark) const {
    base::Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.message = message;
    diagnostic.file = file_;
    if (!mark.is_null()) {
      diagnostic.line = mark.line + 1;
      diagnostic.column = mark.column + 1;
    }
    return diagnostic;
  }

  void add(base::Severity severity, const std::string& message, const YAML::Mark& mark) {
    diagnostics_.push_back(located(severity, message, mark));
  }

  void error(const std::string& message, const YAML::Node& node) {
    add(base::Severity::Error, message, node.Mark());
  }

  void checkKeys() {
    std::set<std::string> seen;
    for (const auto& entry : root_) {
      if (!entry.first.IsScalar()) {
        error("a key must be a word", entry.first);
        continue;
      }
      const std::string key = entry.first.Scalar();
      if (!seen.insert(key).second) {
        error("key '" + key + "' is given twice", entry.first);
        continue;
      }
      const std::optional<std::string> near = base::nearestName(key, mapKeys());
      if (!near || *near != key) {
        add(base::Severity::Warning,
            "unknown key '" + key + "'" + (near ? " (did you mean '" + *near + "'?)" : ""),
            entry.first.Mark());
      }
    }
    for (const std::string& key : mapKeys()) {
      if (seen.count(key) == 0 && key != "mode") {
        add(base::Severity::Error, "key '" + key + "' is missing", YAML::Mark::null_mark());
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

  std::optional<double> number(const YAML::Node& node, const std::string& what) {
    const std::optional<double> value =
        node.IsScalar() ? base::parseDouble(node.Scalar()) : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      error(what + " must be a finite number" +
                (node.IsScalar() ? ", not '" + node.Scalar() + "'" : std::string()),
            node);
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
      error("image must name a file", *node);
      return;
    }
    description_.image = node->Scalar();
  }

  void readResolution() {
    const std::optional<YAML::Node> node = find("resolution");
    const std::optional<double> value = node ? number(*node, "resolution") : std::nullopt;
    if (value && *value <= 0.0) {
      error("resolution must be above 0 m per pixel, not " + node->Scalar(), *node);
    } else if (value && !(*value >= kFinest && *value <= kCoarsest)) {
      error("resolution must be 0.001 to 10 m per pixel, not " + node->Scalar(), *node);
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
      error("origin must be a list of three numbers: x, y, yaw", *node);
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
      error("origin must lie within 1e6 m", *node);
      return;
    }
    description_.origin.position = {values[0], values[1]};
    description_.origin.heading = base::wrapToPi(values[2]);
    if (values[2] != 0.0) {
      add(base::Severity::Warning,
          "the map is turned by yaw " + base::formatDouble(values[2]) +
              " rad (many ROS programs ignore that)",
          (*node)[2].Mark());
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
      error("negate must be 0, 1, false or true", *node);
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
      error("thresholds must be 0 <= free_thresh < occupied_thresh <= 1, not " +
                base::formatDouble(low) + " and " + base::formatDouble(high),
            *free);
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
      error("mode must be trinary, scale or raw", *node);
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
    return base::makeError("this program reads only PGM images (P2, P5)");
  }
  base::Result<MapImage> image = loader(path.string());
  if (!image) {
    return image;
  }
  const std::int64_t pixels = std::int64_t{image->width} * image->height;
  if (pixels > kMostMapCells) {
    return base::makeError("the image is too large (at most 100 million pixels; scale it down)");
  }
  if (pixels <= 0 || image->maximum < 1 ||
      image->rgba.size() != 4 * static_cast<std::size_t>(pixels)) {
    return base::makeError("the image has no pixels");
  }
  return image;
}

/// The cells of the image, whatever kind of file it is.
base::Result<OccupancyGrid> readCells(const fs::path& path, const ImageLoader& loader,
                                      const MapDescription& description, MapRule rule) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return base::makeError("the file does not exist");
  }
  if (!fs::is_regular_file(status)) {
    return base::makeError("not a file");
  }
  if (fs::file_size(path, code) == 0 && !code) {
    return base::makeError("the file is empty");
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
    diagnostics.push_back(
        reader.atImage(problem.severity, "image '" + map.imagePath + "': " + problem.message));
  }
  if (base::hasErrors(diagnostics)) {
    return diagnostics;
  }
  map.grid = *std::move(grid);
  return {std::move(map), std::move(diagnostics)};
}

}  // namespace sim2d
