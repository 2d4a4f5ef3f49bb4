#include "sim2d/nav/nav2/params/RosValue.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

enum class ScalarType { Bool, Integer, Double, String };

bool isOneOf(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

std::optional<bool> boolOf(const YamlNode& value) {
  if (value.quoted) {
    return std::nullopt;
  }
  if (isOneOf(value.text,
              {"Y", "y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"})) {
    return true;
  }
  const bool isFalse = isOneOf(
      value.text, {"N", "n", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"});
  return isFalse ? std::optional<bool>(false) : std::nullopt;
}

std::optional<long long> integerOf(const YamlNode& value) {
  return value.quoted ? std::nullopt : base::parseInt(value.text);
}

std::optional<double> doubleOf(const YamlNode& value) {
  return value.quoted ? std::nullopt : base::parseDouble(value.text);
}

ScalarType typeOf(const YamlNode& value) {
  if (boolOf(value)) {
    return ScalarType::Bool;
  }
  if (integerOf(value)) {
    return ScalarType::Integer;
  }
  return doubleOf(value) ? ScalarType::Double : ScalarType::String;
}

constexpr std::array<const char*, 4> kScalarNames = {"bool", "integer", "double", "string"};

bool areAll(const YamlNode& list, ScalarType type) {
  return std::all_of(list.items.begin(), list.items.end(), [type](const YamlNode& item) {
    return item.isScalar() && typeOf(item) == type;
  });
}

/// `isSet`: an integer is accepted for a double.
template <class T>
std::optional<T> scalarOf(const YamlNode& value, bool isSet) {
  if (!value.isScalar()) {
    return std::nullopt;
  }
  const ScalarType type = typeOf(value);
  if constexpr (std::is_same_v<T, bool>) {
    return boolOf(value);
  } else if constexpr (std::is_same_v<T, int>) {
    const auto number = integerOf(value);
    constexpr long long kMax = std::numeric_limits<int>::max();
    const bool fits = number && -kMax <= *number && *number <= kMax;
    return fits ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
  } else if constexpr (std::is_same_v<T, double>) {
    const bool fits = type == ScalarType::Double || (isSet && type == ScalarType::Integer);
    return fits ? doubleOf(value) : std::nullopt;
  } else {
    return type == ScalarType::String ? std::optional<std::string>(value.text) : std::nullopt;
  }
}

/// A scalar, or a list of which each item is one.
template <class T>
std::optional<T> valueAs(const YamlNode& value) {
  const bool isSet = value.tag == kOverrideTag;
  if constexpr (std::is_same_v<T, std::vector<double>> ||
                std::is_same_v<T, std::vector<std::string>>) {
    T items;
    for (const YamlNode& item : value.items) {
      auto one = scalarOf<typename T::value_type>(item, isSet);
      if (!one) {
        return std::nullopt;
      }
      items.push_back(*std::move(one));
    }
    return value.isList() ? std::optional<T>(std::move(items)) : std::nullopt;
  } else {
    return scalarOf<T>(value, isSet);
  }
}

std::string listText(const std::vector<std::string>& items) {
  return "[" + base::join(items, ", ") + "]";
}

}  // namespace

std::string rosTypeName(const YamlNode& value) {
  switch (value.kind) {
    case YamlNode::Kind::Null:
      return "empty";
    case YamlNode::Kind::Map:
      return "map";
    case YamlNode::Kind::Scalar:
      return kScalarNames[static_cast<std::size_t>(typeOf(value))];
    case YamlNode::Kind::List:
      break;
  }
  if (value.items.empty()) {
    return "empty_array";
  }
  for (const ScalarType type :
       {ScalarType::Bool, ScalarType::Integer, ScalarType::Double, ScalarType::String}) {
    if (areAll(value, type)) {
      return std::string(kScalarNames[static_cast<std::size_t>(type)]) + "_array";
    }
  }
  return "mixed_array";
}

std::optional<Nav2Value> toRosValue(const YamlNode& value, const Nav2Value& like) {
  return std::visit(
      [&value](const auto& wanted) -> std::optional<Nav2Value> {
        auto found = valueAs<std::decay_t<decltype(wanted)>>(value);
        return found ? std::optional<Nav2Value>(*std::move(found)) : std::nullopt;
      },
      like);
}

std::optional<Nav2Value> toRosValue(const YamlNode& value) {
  if (value.isList()) {
    const Nav2Value like = areAll(value, ScalarType::String) ? Nav2Value(std::vector<std::string>())
                                                             : Nav2Value(std::vector<double>());
    return toRosValue(value, like);
  }
  if (!value.isScalar()) {
    return std::nullopt;
  }
  switch (typeOf(value)) {
    case ScalarType::Bool:
      return toRosValue(value, Nav2Value(false));
    case ScalarType::Integer:
      return toRosValue(value, Nav2Value(0));
    case ScalarType::Double:
      return toRosValue(value, Nav2Value(0.0));
    case ScalarType::String:
      break;
  }
  return toRosValue(value, Nav2Value(std::string()));
}

std::string valueText(const Nav2Value& value) {
  return std::visit(
      [](const auto& held) -> std::string {
        using T = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<T, double>) {
          return base::formatDecimals(held, 1);
        } else if constexpr (std::is_same_v<T, int>) {
          return std::to_string(held);
        } else if constexpr (std::is_same_v<T, bool>) {
          return held ? "true" : "false";
        } else if constexpr (std::is_same_v<T, std::string>) {
          return "\"" + held + "\"";
        } else if constexpr (std::is_same_v<T, std::vector<double>>) {
          std::vector<std::string> items;
          items.reserve(held.size());
          for (const double item : held) {
            items.push_back(base::formatDecimals(item, 1));
          }
          return listText(items);
        } else {
          return listText(held);
        }
      },
      value);
}

std::string valueText(const YamlNode& value) {
  if (value.isList()) {
    std::vector<std::string> items;
    for (const YamlNode& item : value.items) {
      items.push_back(item.text);
    }
    return listText(items);
  }
  return value.isScalar() ? value.text : value.isMap() ? "{…}" : "";
}

namespace {

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
