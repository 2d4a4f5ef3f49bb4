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

std::optional<std::vector<double>> doublesOf(const YamlNode& list, bool isSet) {
  std::vector<double> numbers;
  for (const YamlNode& item : list.items) {
    const bool fits = item.isScalar() && (typeOf(item) == ScalarType::Double ||
                                          (isSet && typeOf(item) == ScalarType::Integer));
    if (!fits) {
      return std::nullopt;
    }
    numbers.push_back(*doubleOf(item));
  }
  return numbers;
}

std::optional<std::vector<std::string>> textsOf(const YamlNode& list) {
  if (!areAll(list, ScalarType::String)) {
    return std::nullopt;
  }
  std::vector<std::string> texts;
  for (const YamlNode& item : list.items) {
    texts.push_back(item.text);
  }
  return texts;
}

template <class T>
std::optional<T> scalarOf(const YamlNode& value) {
  const bool isSet = value.tag == kOverrideTag;
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

template <class T>
std::optional<T> valueAs(const YamlNode& value) {
  if constexpr (std::is_same_v<T, std::vector<double>>) {
    return value.isList() ? doublesOf(value, value.tag == kOverrideTag) : std::nullopt;
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    return value.isList() ? textsOf(value) : std::nullopt;
  } else {
    return scalarOf<T>(value);
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

}  // namespace sim2d::nav2
