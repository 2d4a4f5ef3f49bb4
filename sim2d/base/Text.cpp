#include "sim2d/base/Text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace base {
namespace {

constexpr std::size_t kLongestFixed = 1100;  // sign, "0.", 323 zeros and 17 digits; or 309 digits

char loweredChar(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The whole token, as std::from_chars reads it, and a '+' before it.
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
  const std::string wanted = lowered(word);
  std::size_t smallest = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  std::optional<std::string> nearest;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(wanted, lowered(candidate));
    if (distance < smallest && distance < wanted.size()) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

namespace {

/// Bytes of the character of UTF-8 that begins there (RFC 3629); 0: none does.
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

}  // namespace

std::string visible(std::string_view text, std::string_view kept) {
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

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), loweredChar);
  return result;
}

}  // namespace base
