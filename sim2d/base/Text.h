#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Numbers and files without a locale.
namespace base {

/// The whole token as a number ("1.5", "-2e3", ".5", "+1"); nothing else around it. NaN and
/// infinities are accepted only as "nan", "inf", "-inf" (YAML's ".nan", ".inf" as well). What no
/// double can hold ("1e400", "1e-400") is no number.
std::optional<double> parseDouble(std::string_view token);
std::optional<long long> parseInt(std::string_view token);  // decimal, optional sign

/// Shortest text that reads back equal: "0.1", "1e-07", "3".
std::string formatDouble(double value);
/// The same without exponent and with at least `decimals` digits after the point: 1.5 -> "1.500".
std::string formatDecimals(double value, int decimals);

std::string pointText(const Vec2& point);  // "(1.5, -2)", to the millimetre

/// Insertions, deletions, replacements and swaps of neighbours that turn one text into the other
/// (optimal string alignment), in bytes.
std::size_t editDistance(const std::string& a, const std::string& b);

/// The candidate closest to `word` by edit distance (case ignored), if it is close enough to be
/// meant: at most one edit in three letters.
std::optional<std::string> nearestName(std::string_view word,
                                       const std::vector<std::string>& candidates);

constexpr std::size_t kMostText = std::size_t{256} << 20U;  // [B] of what people write
constexpr std::size_t kMostRecord = std::size_t{8} << 30U;  // [B] of what programs record

/// "-" is the standard input, read once. A missing file, a folder, a pipe or a device, and a file
/// of more than `most` bytes are errors; nothing is read of them.
Result<std::string> readTextFile(const std::string& path, std::size_t most = kMostText);
/// Writes beside the file, then renames, so a reader sees the old or the new content, never half.
/// Folders are made, the permissions of a replaced file and symbolic links stay. Empty = written.
Diagnostics writeFileAtomically(const std::string& path, std::string_view content);

/// For a terminal: control characters, which could move its cursor or forge a line, as "\\x1b".
/// `kept`: those that are meant.
std::string visible(std::string_view text, std::string_view kept = {});
std::string trimmed(std::string_view text);
std::vector<std::string> split(std::string_view text, char separator);
std::string join(const std::vector<std::string>& parts, const std::string& separator);
std::string lowered(std::string_view text);  // ASCII
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
inline bool isLetter(char c) {  // ASCII
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace base
