// Reads PGM images; converts pixels to cells and back.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
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

/// Reads a PGM file; stops at the first problem.
class PgmReader {
 public:
  explicit PgmReader(const std::string& path) : path_(path), input_(path, std::ios::binary) {}

  base::Result<MapImage> read() {
    try {
      return readFile();
    } catch (const std::ios_base::failure&) {  // disk error
      return base::error("image.not-readable", {}, path_);
    }
  }

 private:
  base::Result<MapImage> readFile() {
    std::error_code code;
    const auto size = std::filesystem::file_size(path_, code);
    if (code || !input_) {
      return base::error("image.not-readable", {}, path_);
    }
    if (size == 0) {
      return base::error("image.empty", {}, path_);
    }
    if (!readHeader()) {
      return problem_;
    }
    const auto left = static_cast<std::int64_t>(size) - static_cast<std::int64_t>(input_.tellg());
    const std::int64_t pixels = std::int64_t{image_.width} * image_.height;
    const std::int64_t needed = isText_ ? 2 * pixels - 1 : pixels * (image_.maximum > 255 ? 2 : 1);
    if (left < needed) {
      return base::error("image.cut",
                         {image_.width, image_.height, needed, std::max<std::int64_t>(left, 0)},
                         path_);
    }
    return image_.maximum > 255 ? readPixels<std::uint16_t>() : readPixels<std::uint8_t>();
  }

  bool fail(const char* code, base::ProblemValues values = {}) {
    problem_ = base::error(code, std::move(values), path_);
    return false;
  }

  bool readHeader() {
    char magic[2] = {};
    input_.read(magic, 2);
    if (!input_ || magic[0] != 'P' || (magic[1] != '2' && magic[1] != '5')) {
      return fail("image.no-pgm");
    }
    isText_ = magic[1] == '2';
    const std::optional<int> width = readNumber();
    const std::optional<int> height = readNumber();
    const std::optional<int> maximum = readNumber();
    if (!width || !height || !maximum) {
      return fail("image.bad-header");
    }
    if (*width < 1 || *height < 1) {
      return fail("image.no-pixels");
    }
    if (*maximum < 1 || *maximum > 65535) {
      return fail("image.bad-maximum", {*maximum});
    }
    if (std::int64_t{*width} * *height > kMaxMapCells) {
      return fail("image.too-large", {*width, *height, kMaxMapCells});
    }
    image_.width = *width;
    image_.height = *height;
    image_.maximum = *maximum;
    image_.isGrey = true;
    return true;
  }

  static bool isSpace(int c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
  }

  int next() { return input_.rdbuf()->sbumpc(); }

  int nextAfterBlanks() {
    int c = next();
    while (isSpace(c) || c == '#') {
      if (c == '#') {
        input_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      }
      c = next();
    }
    return c;
  }

  /// The next decimal number after blanks and comments; also consumes the character after it.
  std::optional<int> readNumber() {
    int c = nextAfterBlanks();
    constexpr int kLimit = 100'000'000;
    int value = 0;
    bool any = false;
    for (; c >= '0' && c <= '9'; c = next()) {
      value = std::min(value, kLimit) * 10 + (c - '0');
      any = true;
    }
    const bool ends = isSpace(c) || c == kEnd || c == '#';
    if (c == '#') {
      input_.rdbuf()->sungetc();
    }
    return any && ends ? std::optional<int>(value) : std::nullopt;
  }

  template <class Value>
  base::Result<MapImage> readPixels() {
    std::vector<Value> shades(static_cast<std::size_t>(image_.width) *
                              static_cast<std::size_t>(image_.height));
    const std::size_t read = isText_ ? readText(shades) : readBinary(shades);
    if (read < shades.size()) {
      return base::error("image.pixel-missing", {read + 1, shades.size()}, path_);
    }
    image_.setValues(std::move(shades));
    base::Diagnostics warnings;
    if (isAbove_) {
      warnings.push_back(base::warning("image.too-bright", {image_.maximum}, path_));
    }
    return {std::move(image_), std::move(warnings)};
  }

  int shadeOf(int value) {
    isAbove_ = isAbove_ || value > image_.maximum;
    return std::min(value, image_.maximum);
  }

  /// Returns the number of values read.
  template <class Value>
  std::size_t readText(std::vector<Value>& shades) {
    for (std::size_t i = 0; i < shades.size(); ++i) {
      const std::optional<int> value = readNumber();
      if (!value) {
        return i;
      }
      shades[i] = static_cast<Value>(shadeOf(*value));
    }
    return shades.size();
  }

  /// The file has sizeof(Value) bytes per pixel.
  template <class Value>
  std::size_t readBinary(std::vector<Value>& shades) {
    constexpr std::size_t kBytes = sizeof(Value);
    std::vector<char> row(static_cast<std::size_t>(image_.width) * kBytes);
    std::size_t at = 0;
    while (at < shades.size()) {
      const auto got = static_cast<std::size_t>(
          input_.rdbuf()->sgetn(row.data(), static_cast<std::streamsize>(row.size())));
      for (std::size_t i = 0; i + kBytes <= got; i += kBytes) {
        const int first = static_cast<unsigned char>(row[i]);
        const int value =
            kBytes == 2 ? first * 256 + static_cast<unsigned char>(row[i + 1]) : first;
        shades[at++] = static_cast<Value>(shadeOf(value));
      }
      if (got < row.size()) {
        break;
      }
    }
    return at;
  }

  static constexpr int kEnd = std::char_traits<char>::eof();

  std::string path_;
  std::ifstream input_;
  base::Diagnostic problem_;
  bool isText_ = false;
  bool isAbove_ = false;  // some pixels exceed the maximum
  MapImage image_;
};

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

base::Result<MapImage> readPgm(const std::string& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) {
    return base::error("image.not-there", {}, path);
  }
  if (!std::filesystem::is_regular_file(status)) {
    return base::error("image.no-file", {}, path);
  }
  return PgmReader(path).read();
}

}  // namespace sim2d
