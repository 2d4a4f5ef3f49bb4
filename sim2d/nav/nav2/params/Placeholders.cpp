#include "sim2d/nav/nav2/params/Placeholders.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

/// Opening and closing brackets of placeholders.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kBrackets = {
    {{"$(", ")"}, {"${", "}"}, {"{{", "}}"}, {"{%", "%}"}, {"<", ">"}, {"@", "@"}}};

bool isCapital(char c) {
  return 'A' <= c && c <= 'Z';
}

/// "KEEPOUT_ZONE_ENABLED", "TODO".
bool isUpperCase(std::string_view text) {
  return text.size() > 1 && isCapital(text.front()) &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return isCapital(c) || base::isDigit(c) || c == '_' || c == '-';
         });
}

/// Words in capitals that are no values of Nav2 ("REEDS_SHEPP" is one).
bool isPlaceholderWord(std::string_view text) {
  static constexpr std::array<std::string_view, 11> kParts = {
      "OVERRID", "REPLACE", "REWRIT", "PLACEHOLDER", "TO_BE_",  "TODO",
      "TBD",     "CHANGE",  "FIXME",  "SUBSTITUTE",  "_ENABLED"};
  return isUpperCase(text) &&
         std::any_of(kParts.begin(), kParts.end(), [text](std::string_view part) {
           return text.find(part) != std::string_view::npos;
         });
}

/// Whether the text is enclosed in brackets; `<` and `@` only around one word, as they are common
/// in texts.
bool isBracketed(std::string_view text, std::string_view open, std::string_view close) {
  const std::size_t length = open.size() + close.size();
  if (text.size() <= length || text.substr(0, open.size()) != open ||
      text.substr(text.size() - close.size()) != close) {
    return false;
  }
  const std::string_view inner = text.substr(open.size(), text.size() - length);
  const bool isWord = std::all_of(inner.begin(), inner.end(), [](char c) {
    return base::isLetter(c) || base::isDigit(c) || c == '_' || c == '-' || c == ' ';
  });
  const bool isOne = inner.find(close) == std::string_view::npos || open == "$(";
  return open.size() == 1 ? isWord : isOne;
}

/// "$(var a)$(var b)" and "$(var a)/$(var b)" contain several placeholders and are no values
/// either.
bool isPlaceholderPart(std::string_view text) {
  return std::any_of(kBrackets.begin(), kBrackets.end(), [text](const auto& bracket) {
    const std::size_t open = text.find(bracket.first);
    return bracket.first.size() > 1 && open != std::string_view::npos &&
           text.find(bracket.second, open) != std::string_view::npos;
  });
}

}  // namespace

bool isListOfPlugins(const std::string& name) {
  static constexpr std::array<std::string_view, 4> kEnds = {"plugins", "critics", "filters",
                                                            "polygons"};
  return std::any_of(kEnds.begin(), kEnds.end(),
                     [&name](std::string_view end) { return base::endsWith(name, end); });
}

bool isPlaceholderText(std::string_view text) {
  return isPlaceholderWord(text) ||
         std::any_of(kBrackets.begin(), kBrackets.end(), [text](const auto& bracket) {
           return isBracketed(text, bracket.first, bracket.second);
         });
}

bool isLaunchPlaceholder(const std::string& name, const YamlNode& value) {
  if (value.isNull()) {
    return true;
  }
  return value.isScalar() &&
         (isPlaceholderText(value.text) || (isListOfPlugins(name) && isUpperCase(value.text)));
}

bool mayBePlaceholder(const YamlNode& value) {
  if (value.isList()) {
    return std::any_of(value.items.begin(), value.items.end(), [](const YamlNode& item) {
      return item.isScalar() && (isPlaceholderText(item.text) || isPlaceholderPart(item.text));
    });
  }
  return value.isScalar() && (value.text.empty() || isPlaceholderText(value.text) ||
                              isUpperCase(value.text) || isPlaceholderPart(value.text));
}

}  // namespace sim2d::nav2
