#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Locale-independent numbers, text functions, and text files.
namespace base {

/// The whole token as a number ("1.5", "-2e3", ".5", "+1"). NaN and infinities are accepted only as
/// "nan", "inf", "-inf" (YAML: ".nan", ".inf"). Numbers outside the range of double ("1e400",
/// "1e-400") are invalid.
std::optional<double> parseDouble(std::string_view token);
std::optional<long long> parseInt(std::string_view token);  // decimal, optional sign

/// Shortest text that reads back equal: "0.1", "1e-07", "3".
std::string formatDouble(double value);
/// As formatDouble, without exponent and with at least `decimals` digits after the point: 1.5 ->
/// "1.500".
std::string formatDecimals(double value, int decimals);

std::string pointText(const Vec2& point);  // "(1.5, -2)", rounded to a millimetre

/// Insertions, deletions, replacements and transpositions that turn one text into the other
/// (optimal string alignment), in bytes.
std::size_t editDistance(const std::string& a, const std::string& b);

/// The candidate with the smallest edit distance to `word`, ignoring case; none if it needs more
/// than one edit per three letters.
std::optional<std::string> nearestName(std::string_view word,
                                       const std::vector<std::string>& candidates);

constexpr std::size_t kMaxText = std::size_t{256} << 20U;  // [B] of files written by users
constexpr std::size_t kMaxRecord = std::size_t{8} << 30U;  // [B] of recordings

/// Reads a file; "-" is the standard input, read once. Missing files, folders, pipes, devices and
/// files of more than `most` bytes are errors.
Result<std::string> readTextFile(const std::string& path, std::size_t most = kMaxText);
/// Writes to a temporary name and renames, so that readers see the old or the new content. Creates
/// folders; keeps the permissions of a replaced file and symbolic links. Empty: it is written.
Diagnostics writeFileAtomically(const std::string& path, std::string_view content);

/// Escapes control characters as "\\x1b" for terminals, where they could move the cursor or forge
/// lines. Those in `kept` are not escaped.
std::string escapedControls(std::string_view text, std::string_view kept = {});
std::string trimmed(std::string_view text);
std::vector<std::string> split(std::string_view text, char separator);
std::string join(const std::vector<std::string>& parts, const std::string& separator);
std::string toLower(std::string_view text);  // ASCII
inline bool startsWith(std::string_view text, std::string_view begin) {
  return text.substr(0, begin.size()) == begin;
}
inline bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}
/// The text as one word of a POSIX shell command, in quotes if it needs them.
std::string shellWord(const std::string& text);
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
inline bool isLetter(char c) {  // ASCII
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Git LFS replaces a large file by a short text file, a pointer, until the large file is fetched:
/// whether the first bytes of a file are those of a pointer.
inline bool isLfsPointer(std::string_view begin) {
  return startsWith(begin, "version https://git-lfs");
}

/// For readers that do not use readTextFile (Text.h), which includes this check. Empty: the file is
/// not a pointer, or cannot be read.
Diagnostics lfsPointerProblem(const std::string& path);

}  // namespace base
