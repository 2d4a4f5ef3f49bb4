#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "app/bridge/messages/FieldTraits.h"
#include "sim2d/base/JsonText.h"

/// ROS messages as JSON objects, as clients without ROS send them.
namespace live {

/// A visitor that fills the fields of a message from a JSON object. Missing fields keep their
/// default, unknown fields are ignored. Lists are not supported; accepted messages have none.
class JsonReader {
 public:
  explicit JsonReader(const nlohmann::json& object)
      : object_(object), isValid_(object.is_object()) {}

  template <class T>
  void operator()(const char* name, T& value) {
    if (!isValid_) {
      return;
    }
    const auto found = object_.find(name);
    if (found != object_.end()) {
      read(*found, value);
    }
  }
  bool isValid() const { return isValid_; }

 private:
  template <class T>
  void read(const nlohmann::json& json, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      take(json.is_boolean(), json, value);
    } else if constexpr (std::is_floating_point_v<T>) {
      take(json.is_number(), json, value);
    } else if constexpr (std::is_integral_v<T>) {
      const bool isWhole =
          json.is_number_integer() &&
          json.get<double>() >= static_cast<double>(std::numeric_limits<T>::min()) &&
          json.get<double>() <= static_cast<double>(std::numeric_limits<T>::max());
      take(isWhole, json, value);
    } else if constexpr (bridge::kIsString<T>) {
      take(json.is_string(), json, value);
    } else if constexpr (!bridge::kIsSequence<T> && !bridge::kIsArray<T>) {
      JsonReader inner(json);
      if constexpr (!bridge::kIsEmptyMessage<T>) {
        T::fields(value, inner);
      }
      isValid_ = isValid_ && inner.isValid();
    }
  }
  template <class T>
  void take(bool isValid, const nlohmann::json& json, T& value) {
    isValid_ = isValid_ && isValid;
    if (isValid) {
      value = json.get<T>();
    }
  }

  const nlohmann::json& object_;
  bool isValid_;
};

constexpr std::size_t kLargestJson = 65536;  // [B], far above valid messages

/// Nothing: the text is not JSON or too large, or a field has another type. Any bytes are safe.
template <class M>
std::optional<M> messageOfJson(std::string_view text) {
  if (text.size() > kLargestJson) {
    return std::nullopt;
  }
  const nlohmann::json object = nlohmann::json::parse(text, nullptr, false);
  M message;
  JsonReader fields(object);
  if constexpr (!bridge::kIsEmptyMessage<M>) {
    M::fields(message, fields);
  }
  return fields.isValid() ? std::optional<M>(message) : std::nullopt;
}

/// The JSON of a message that contains only numbers and strings.
template <class M>
std::string jsonOf(const M& message) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  M::fields(message, [&object](const char* name, const auto& value) { object[name] = value; });
  return base::jsonText(object, -1);
}

}  // namespace live
