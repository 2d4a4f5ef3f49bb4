#include "sim2d/base/Text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fcntl.h>
#include <limits>
#include <numeric>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "sim2d/base/Files.h"
#include "sim2d/base/SystemError.h"

namespace base {
namespace {

constexpr std::size_t kLongestFixed = 1100;  // sign, "0.", 323 zeros and 17 digits; or 309 digits

char toLowerChar(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Parses the whole token with std::from_chars; also accepts a leading '+'.
template <class Number>
std::optional<Number> parseWhole(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  const std::string_view number = token.substr(plus ? 1 : 0);
  const char* const end = number.data() + number.size();
  Number value = 0;
  const std::from_chars_result result = std::from_chars(number.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::make_optional(value) : std::nullopt;
}

std::optional<double> parseNotFinite(std::string_view token) {
  if (token == "nan" || token == ".nan" || token == ".NaN" || token == ".NAN") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const bool isNegative = token.substr(0, 1) == "-";
  const std::string_view size = token.substr(isNegative || token.substr(0, 1) == "+" ? 1 : 0);
  if (size == "inf" || size == ".inf" || size == ".Inf" || size == ".INF") {
    const double infinity = std::numeric_limits<double>::infinity();
    return isNegative ? -infinity : infinity;
  }
  return std::nullopt;
}

/// Length [bytes] of the UTF-8 character at the start (RFC 3629); 0: invalid.
std::size_t lengthOfCharacter(std::string_view text) {
  const auto byteAt = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byteAt(0);
  if (first < 0x80U) {
    return 1;
  }
  const std::size_t length = first >= 0xf0U ? 4 : first >= 0xe0U ? 3 : 2;
  unsigned code = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byteAt(i) & 0xc0U) != 0x80U) {
      return 0;
    }
    code = (code << 6U) | (byteAt(i) & 0x3fU);
  }
  constexpr std::array<unsigned, 5> kLeast = {0, 0, 0x80U, 0x800U, 0x10000U};
  const bool isSurrogate = code >= 0xd800U && code < 0xe000U;
  return first < 0xc0U || first > 0xf4U || code < kLeast[length] || code > 0x10ffffU || isSurrogate
             ? 0
             : length;
}

/// Opening a pipe does not block.
FileDescriptor openedForReading(const std::string& path) {
  return FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
}

Diagnostic tooLarge(const std::string& path, std::size_t most) {
  return error("file.too-large", {most >> 20U}, path);
}

Diagnostic unreadable(const std::string& path, int error) {
  return base::error("file.cannot-read", {systemErrorMessage({error, std::generic_category()})},
                     path);
}

/// Reads to the end; `expected`: probable size [bytes].
Result<std::string> readAll(int descriptor, const std::string& path, std::size_t expected,
                            std::size_t most) {
  constexpr std::size_t kReadPiece = std::size_t{1} << 16U;  // [B]
  std::string content;
  std::size_t size = 0;
  while (true) {
    if (size == content.size()) {
      content.resize(std::max(size == 0 ? expected + 1 : 2 * size, size + kReadPiece));
    }
    const ssize_t count = ::read(descriptor, content.data() + size, content.size() - size);
    if (count < 0 && errno != EINTR) {
      return unreadable(path, errno);
    }
    size += count > 0 ? static_cast<std::size_t>(count) : 0;
    if (size > most) {
      return tooLarge(path, most);
    }
    if (count == 0) {
      content.resize(size);
      return content;
    }
  }
}

/// The text, or an error if it is a Git LFS pointer.
Result<std::string> rejectLfsPointer(Result<std::string> text, const std::string& path) {
  return text && isLfsPointer(*text) ? error("file.lfs-pointer", {}, path) : std::move(text);
}

/// Read once and cached, because a run opens its files more than once.
const Result<std::string>& standardInput() {
  static const Result<std::string> kText =
      rejectLfsPointer(readAll(STDIN_FILENO, "-", 0, kMaxRecord), "-");
  return kText;
}

}  // namespace

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> above(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::optional<double> parseDouble(std::string_view token) {
  const auto value = parseWhole<double>(token);
  return value && std::isfinite(*value) ? value : parseNotFinite(token);
}

std::optional<long long> parseInt(std::string_view token) {
  return parseWhole<long long>(token);
}

std::string formatDouble(double value) {
  if (std::isnan(value)) {
    return "nan";  // of either sign
  }
  std::array<char, 32> buffer{};
  char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string formatDecimals(double value, int decimals) {
  if (!std::isfinite(value)) {
    return formatDouble(value);
  }
  std::array<char, kLongestFixed> buffer{};
  char* const end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
          .ptr;
  std::string text(buffer.data(), end);
  const std::size_t wanted = decimals > 0 ? static_cast<std::size_t>(decimals) : 0;
  const std::size_t point = text.find('.');
  const std::size_t present = point == std::string::npos ? 0 : text.size() - point - 1;
  if (present < wanted) {
    text += point == std::string::npos ? "." : "";
    text.append(wanted - present, '0');
  }
  return text;
}

std::string pointText(const Vec2& point) {
  const auto rounded = [](double value) {
    return formatDouble(std::round(value * 1000.0) / 1000.0);
  };
  return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ")";
}

std::optional<std::string> nearestName(std::string_view word,
                                       const std::vector<std::string>& candidates) {
  const std::string wanted = toLower(word);
  std::size_t smallest = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::optional<std::string> nearest;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(wanted, toLower(candidate));
    if (distance < smallest && distance < wanted.size()) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string escapedControls(std::string_view text, std::string_view kept) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string shown;
  shown.reserve(text.size());
  const auto escape = [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    shown += "\\x";
    shown += kDigits[byte >> 4U];
    shown += kDigits[byte & 15U];
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = lengthOfCharacter(text.substr(i));
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool isControl = byte < 0x20U || byte == 0x7fU;
    if (length == 2 && byte == 0xc2U && static_cast<unsigned char>(text[i + 1]) < 0xa0U) {
      escape(text[i + 1]);  // U+0080 to U+009F
    } else if (length == 0 || (isControl && kept.find(text[i]) == std::string_view::npos)) {
      escape(text[i]);
    } else {
      shown += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\n\v\f\r";
  const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) + 1 - first));
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || text[i] == separator) {
      parts.emplace_back(text.substr(start, i - start));
      start = i + 1;
    }
  }
  return parts;
}

std::string join(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() ? "" : separator) + part;
  }
  return text;
}

std::string toLower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), toLowerChar);
  return result;
}

std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=-+,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

Result<std::string> readTextFile(const std::string& path, std::size_t most) {
  if (path == "-") {
    return standardInput();
  }
  const FileDescriptor file = openedForReading(path);
  struct stat about = {};
  if (!file.isOpen() || ::fstat(file.number(), &about) != 0) {
    return unreadable(path, errno);
  }
  if (S_ISDIR(about.st_mode)) {
    return unreadable(path, EISDIR);
  }
  if (!S_ISREG(about.st_mode)) {
    return error("file.no-file", {}, path);
  }
  const auto size = static_cast<std::size_t>(std::max<off_t>(about.st_size, 0));
  return size > most ? Result<std::string>(tooLarge(path, most))
                     : rejectLfsPointer(readAll(file.number(), path, size, most), path);
}

Diagnostics lfsPointerProblem(const std::string& path) {
  const FileDescriptor file = openedForReading(path);
  std::array<char, 64> begin{};
  const ssize_t count = file.isOpen() ? ::read(file.number(), begin.data(), begin.size()) : 0;
  const std::string_view text(begin.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return isLfsPointer(text) ? Diagnostics{error("file.lfs-pointer", {}, path)} : Diagnostics();
}

}  // namespace base
