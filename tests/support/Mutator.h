#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

/// Bytes with some damage in them, as a bad disk, a bad editor or bad will makes it. The same seed
/// damages the same bytes in the same way, on every machine.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  /// 0 … count - 1.
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  std::string mutated(std::string bytes) {
    const std::size_t wounds = 1 + pick(3);
    for (std::size_t k = 0; k < wounds; ++k) {
      wound(bytes);
    }
    return bytes;
  }

  /// One to three of its numbers are others of the same kind: whole ones stay whole, those with a
  /// point keep one. Readers that want the very type read on.
  std::string withOtherNumbers(std::string bytes) {
    const std::size_t count = 1 + pick(3);
    for (std::size_t k = 0; k < count; ++k) {
      replaceNumber(bytes);
    }
    return bytes;
  }

 private:
  void replaceNumber(std::string& bytes) {
    static const std::regex kNumber("[-+]?\\d+(\\.\\d*)?(e[-+]?\\d+)?",
                                    std::regex::ECMAScript | std::regex::icase);
    static const std::array<const char*, 16> kPointed = {
        "0.0",   "-0.0", "1e9",    "-1e9",  "1e-300", ".nan", ".inf",  "-.inf",
        "1e308", "-1.0", "1000.0", "0.001", "1e-9",   "1e6",  "-1e-5", "0.5"};
    static const std::array<const char*, 12> kWhole = {
        "0",   "-1",  "1",     "2",          "3",          "255",
        "256", "300", "65536", "1000000000", "2147483647", "-2147483648"};
    std::vector<std::pair<std::size_t, std::size_t>> places;  // where, and how long
    for (std::sregex_iterator at(bytes.begin(), bytes.end(), kNumber), end; at != end; ++at) {
      places.emplace_back(at->position(), at->length());
    }
    if (places.empty()) {
      return;
    }
    const auto [from, length] = places[pick(places.size())];
    const bool isPointed = bytes.find_first_of(".eE", from) < from + length;
    bytes.replace(from, length,
                  isPointed ? kPointed[pick(kPointed.size())] : kWhole[pick(kWhole.size())]);
  }

  void wound(std::string& bytes) {
    if (bytes.empty()) {
      bytes = word();
      return;
    }
    const std::size_t at = pick(bytes.size());
    const std::size_t count = std::min(bytes.size() - at, 1 + pick(pick(8) == 0 ? 4000 : 12));
    switch (pick(9)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << pick(8)));
        break;
      case 1:
        bytes.insert(at, 1, static_cast<char>(pick(256)));
        break;
      case 2:
        bytes.erase(at, count);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, count));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.insert(at, word());
        break;
      case 6:
        swapLines(bytes);
        break;
      default:
        replaceToken(bytes, at);
        break;
    }
  }

  static bool isOfToken(char c) {
    return std::string(" \t\r\n,:;=<>\"'{}[]/|").find(c) == std::string::npos;
  }

  /// The number or word there by an odd one, or by another of the same text.
  void replaceToken(std::string& bytes, std::size_t at) {
    at = static_cast<std::size_t>(
        std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), isOfToken) -
        bytes.begin());
    std::size_t end = at;
    while (end < bytes.size() && isOfToken(bytes[end])) {
      ++end;
    }
    std::string other = word();
    if (pick(3) == 0) {
      const std::size_t from = pick(bytes.size());
      std::size_t to = from;
      while (to < bytes.size() && isOfToken(bytes[to])) {
        ++to;
      }
      other = bytes.substr(from, to - from);
    }
    bytes.replace(at, end - at, other);
  }

  /// A line takes the place of another one, or comes twice.
  void swapLines(std::string& bytes) {
    std::vector<std::string> lines(1);
    for (const char c : bytes) {
      lines.back() += c;
      if (c == '\n') {
        lines.emplace_back();
      }
    }
    const std::string line = lines[pick(lines.size())];
    std::string& other = lines[pick(lines.size())];
    other = pick(2) == 0 ? line : other + line;
    bytes.clear();
    for (const std::string& each : lines) {
      bytes += each;
    }
  }

  std::string word() {
    static const std::array<const char*, 44> kWords = {"-1",
                                                       "0",
                                                       "-0",
                                                       "1e308",
                                                       "-1e308",
                                                       "1e-308",
                                                       ".nan",
                                                       "nan",
                                                       ".inf",
                                                       "-inf",
                                                       "1e400",
                                                       "2147483648",
                                                       "-2147483649",
                                                       "4294967296",
                                                       "9223372036854775808",
                                                       "99999999999999999999999",
                                                       "6000000000",
                                                       "0x10",
                                                       "1e9",
                                                       "0.5.5",
                                                       "true",
                                                       "null",
                                                       "~",
                                                       "",
                                                       "*a",
                                                       "&a *a",
                                                       "<<: *a",
                                                       "{",
                                                       "[",
                                                       "]",
                                                       "- - -",
                                                       "!!binary x",
                                                       "\"",
                                                       "'",
                                                       "|",
                                                       "#",
                                                       "\t",
                                                       "<!ENTITY x \"y\">",
                                                       "&#0;",
                                                       "]]>",
                                                       "\xEF\xBB\xBF",
                                                       "\xFF\xFE",
                                                       "\x1b[2J",
                                                       "../../x"};
    const std::size_t kind = pick(kWords.size() + 2);
    if (kind == kWords.size()) {
      return std::string(1, '\0');
    }
    return kind > kWords.size() ? std::string(70000, "[{(<"[pick(4)]) : kWords[kind];
  }

  std::mt19937_64 random_;
};
