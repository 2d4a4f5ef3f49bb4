#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "sim2d/map/MapReader.h"

namespace sim2d {

namespace {

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
