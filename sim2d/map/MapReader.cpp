#include "sim2d/map/MapReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlMap.h"

namespace sim2d {

namespace {

constexpr double kFinest = 0.001, kCoarsest = 10.0;  // [m/pixel]

namespace fs = std::filesystem;
using base::YamlNode;

/// Common spellings of non-finite numbers: nan, -.nan, -nan(ind), +inf, 1.#QNAN, 1e999.
bool isNotFinite(const std::string& text) {
  std::string word = base::toLower(text);
  word.erase(0, word.find_first_not_of("+-"));
  word.erase(0, word.find_first_not_of('.'));
  const bool isTooLarge = !word.empty() && base::isDigit(word.front()) &&
                          word.find_first_not_of("0123456789.e+-") == std::string::npos &&
                          word.find('e') != std::string::npos;
  return base::startsWith(word, "nan") || base::startsWith(word, "inf") ||
         base::startsWith(word, "1.#") || isTooLarge;
}

const std::vector<std::string>& mapKeys() {
  static const std::vector<std::string> keys = {
      "image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"};
  return keys;
}

/// Reads the keys of a map YAML and collects all problems.
class DescriptionReader {
 public:
  explicit DescriptionReader(std::string file) { report_.file = std::move(file); }

  void read(const std::string& text) {
    base::Diagnostics problems;
    root_ = base::parseYaml(text, report_.file, base::DuplicateKeys::FirstWins, problems);
    translateProblems(problems);
    if (!isReadable_) {
      return;
    }
    if (!root_.isMap()) {
      error("map.no-keys", {}, root_.isNull() ? YamlNode() : root_);
      return;
    }
    checkKeys();
    using Reader = void (DescriptionReader::*)(const YamlNode&);
    constexpr std::pair<const char*, Reader> kReaders[] = {
        {"image", &DescriptionReader::readImage},
        {"resolution", &DescriptionReader::readResolution},
        {"origin", &DescriptionReader::readOrigin},
        {"negate", &DescriptionReader::readNegate},
        {"occupied_thresh", &DescriptionReader::readOccupiedThreshold},
        {"free_thresh", &DescriptionReader::readFreeThreshold},
        {"mode", &DescriptionReader::readMode}};
    for (const auto& [key, reader] : kReaders) {
      if (const YamlNode* const node = root_.find(key)) {
        (this->*reader)(*node);
      }
    }
  }

  const MapDescription& description() const { return description_; }
  const base::Diagnostics& diagnostics() const { return report_.diagnostics; }
  /// A problem of the image, reported at the key `image`.
  void add(const base::Diagnostic& problem, const std::string& image) {
    report_.add(imagePlace_, base::withContext("image '" + image + "'", problem));
  }

 private:
  void error(std::string_view code, base::ProblemValues values, const YamlNode& at) {
    report_.add(at, base::error(code, std::move(values)));
  }
  void warning(std::string_view code, base::ProblemValues values, const YamlNode& at) {
    report_.add(at, base::warning(code, std::move(values)));
  }

  /// Reports the problems of the YAML text as problems of map files. A second document is ignored.
  void translateProblems(const base::Diagnostics& problems) {
    for (const base::Diagnostic& problem : problems) {
      YamlNode at;
      at.line = problem.line;
      at.column = problem.column;
      if (problem.severity == base::Severity::Warning) {
        report_.add(at, problem);
      } else if (problem.code == "yaml.key-no-word") {
        error("map.key-no-word", {}, at);
      } else if (problem.code != "yaml.second-document") {
        const std::string reason = problem.value("reason");
        error("map.not-yaml", {reason.empty() ? problem.message : reason}, at);
        isReadable_ = false;
      }
    }
  }

  void checkKeys() {
    std::set<std::string> seen;
    for (const YamlNode& item : root_.items) {
      const YamlNode at = keyNode(item);
      seen.insert(item.key);
      const std::optional<std::string> near = base::nearestName(item.key, mapKeys());
      if (!item.key.empty() && (!near || *near != item.key)) {
        warning("map.unknown-key", {item.key, near}, at);
      }
    }
    for (const std::string& key : mapKeys()) {
      if (seen.count(key) == 0 && key != "mode") {
        error("map.key-missing", {key}, {});
      }
    }
  }

  /// `instead`: suggestion for a number that is not finite.
  std::optional<double> number(const YamlNode& node, const char* key, const char* instead) {
    const std::optional<double> value =
        node.isScalar() ? base::parseDouble(node.text) : std::nullopt;
    if (!node.isScalar()) {
      error("map.no-number", {key}, node);
      return std::nullopt;
    }
    if (!value || !std::isfinite(*value)) {
      error("map.not-a-number", {key, node.text, isNotFinite(node.text) ? instead : ""}, node);
      return std::nullopt;
    }
    return value;
  }

  void readImage(const YamlNode& node) {
    imagePlace_ = node;
    if (!node.isScalar() || node.text.empty()) {
      error("map.no-image-name", {}, node);
      return;
    }
    description_.image = node.text;
  }

  void readResolution(const YamlNode& node) {
    const std::optional<double> value =
        number(node, "resolution", "the metres per pixel, usually 0.05");
    if (value && *value <= 0.0) {
      error("map.resolution-not-positive", {node.text}, node);
    } else if (value && !(*value >= kFinest && *value <= kCoarsest)) {
      error("map.resolution-out-of-range", {node.text}, node);
    } else if (value) {
      description_.resolution = *value;
    }
  }

  void readOrigin(const YamlNode& node) {
    if (!node.isList() || node.items.size() != 3) {
      error("map.bad-origin", {}, node);
      return;
    }
    std::array<double, 3> values{};
    bool areFine = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::optional<double> value = number(node.items[i], "origin", "0");
      areFine = areFine && value.has_value();
      values[i] = value.value_or(0.0);
    }
    if (!areFine) {
      return;
    }
    if (std::fabs(values[0]) > base::kMaxCoordinate ||
        std::fabs(values[1]) > base::kMaxCoordinate) {
      error("map.origin-too-far", {}, node);
      return;
    }
    description_.origin.position = {values[0], values[1]};
    description_.origin.heading = base::wrapToPi(values[2]);
    if (values[2] != 0.0) {
      warning("map.turned", {values[2]}, node.items[2]);
    }
  }

  void readNegate(const YamlNode& node) {
    const std::string word = node.isScalar() ? base::toLower(node.text) : std::string();
    const std::optional<long long> value = base::parseInt(word);
    if (value) {
      description_.negate = *value != 0;
    } else if (word == "true" || word == "yes" || word == "on") {
      description_.negate = true;
    } else if (word != "false" && word != "no" && word != "off") {
      error("map.bad-negate", {}, node);
    }
  }

  void readOccupiedThreshold(const YamlNode& node) {
    high_ = number(node, "occupied_thresh", "0.65");
  }

  /// Read after occupied_thresh; checks both.
  void readFreeThreshold(const YamlNode& node) {
    const std::optional<double> low = number(node, "free_thresh", "0.196");
    if (!high_ || !low) {
      return;
    }
    if (*low < 0.0 || *low >= *high_ || *high_ > 1.0) {
      error("map.bad-thresholds", {*low, *high_}, node);
      return;
    }
    description_.occupiedThreshold = *high_;
    description_.freeThreshold = *low;
  }

  void readMode(const YamlNode& node) {
    static const std::map<std::string, MapMode> kModes = {
        {"trinary", MapMode::Trinary}, {"scale", MapMode::Scale}, {"raw", MapMode::Raw}};
    const auto mode = node.isScalar() ? kModes.find(base::toLower(node.text)) : kModes.end();
    if (mode == kModes.end()) {
      error("map.bad-mode", {}, node);
    } else {
      description_.mode = mode->second;
    }
  }

  base::ReadReport report_;
  YamlNode root_;
  YamlNode imagePlace_;
  std::optional<double> high_;  // occupied_thresh
  bool isReadable_ = true;
  MapDescription description_;
};

bool isPgm(const fs::path& path) {
  std::ifstream input(path, std::ios::binary);
  std::array<char, 2> magic{};
  input.read(magic.data(), magic.size());
  return input && magic[0] == 'P' && (magic[1] == '2' || magic[1] == '5');
}

/// Whether the first bytes are those of another image format, whatever the file's name is.
bool isOtherImage(const fs::path& path) {
  static constexpr std::string_view kBegins[] = {
      {"\x89PNG", 4}, {"\xFF\xD8\xFF", 3}, {"GIF8", 4}, {"BM", 2}, {"RIFF", 4}, {"II*\0", 4},
      {"MM\0*", 4},   {"P1", 2},           {"P3", 2},   {"P4", 2}, {"P6", 2}};
  std::ifstream input(path, std::ios::binary);
  std::array<char, 4> begin{};
  input.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), static_cast<std::size_t>(input.gcount()));
  return std::any_of(std::begin(kBegins), std::end(kBegins),
                     [text](std::string_view each) { return base::startsWith(text, each); });
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
  if (pixels > kMaxMapCells) {
    return base::error("image.too-large", {image->width, image->height, kMaxMapCells});
  }
  if (pixels < 1 || image->maximum < 1 || !image->readRow) {
    return base::error("image.no-pixels");
  }
  return image;
}

/// Reads the image in any supported format and converts it to cells.
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
  if (const base::Diagnostics pointer = base::lfsPointerProblem(path.string()); !pointer.empty()) {
    return pointer;
  }
  const bool isGrey =
      isPgm(path) || (base::toLower(path.extension().string()) == ".pgm" && !isOtherImage(path));
  const base::Result<MapImage> image = isGrey ? readPgm(path.string()) : loadImage(path, loader);
  return image ? base::Result<OccupancyGrid>(gridFromImage(*image, description, rule),
                                             image.diagnostics())
               : image.diagnostics();
}

std::string withHome(const std::string& path) {
  const char* home = base::startsWith(path, "~/") ? std::getenv("HOME") : nullptr;
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
  map.description = reader.description();
  if (map.description.image.empty()) {
    return reader.diagnostics();
  }
  const fs::path imagePath = fs::path(map.path).parent_path() / map.description.image;
  map.imagePath = imagePath.lexically_normal().string();
  base::Result<OccupancyGrid> grid = readCells(map.imagePath, loader, map.description, rule);
  for (const base::Diagnostic& problem : grid.diagnostics()) {
    reader.add(problem, map.imagePath);
  }
  if (base::hasErrors(reader.diagnostics())) {
    return reader.diagnostics();
  }
  map.grid = *std::move(grid);
  return {std::move(map), reader.diagnostics()};
}

}  // namespace sim2d
