#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "app/bridge/messages/FieldKinds.h"
#include "sim2d/base/JsonText.h"

/// Messages of ROS as JSON, as apps without ROS publish and call: an object of fields by name.
namespace live {

/// Visits the fields of a message: puts in what the object has. A field that is not there keeps its
/// default, one that is unknown is left alone. Lists are left alone too: what clients may send has
/// none.
class JsonFields {
 public:
  explicit JsonFields(const nlohmann::json& object)
      : object_(object), isFine_(object.is_object()) {}

  template <class T>
  void operator()(const char* name, T& value) {
    if (!isFine_) {
      return;
    }
    const auto found = object_.find(name);
    if (found != object_.end()) {
      read(*found, value);
    }
  }
  bool isFine() const { return isFine_; }

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
      JsonFields inner(json);
      if constexpr (!bridge::kIsEmptyMessage<T>) {
        T::fields(value, inner);
      }
      isFine_ = isFine_ && inner.isFine();
    }
  }
  template <class T>
  void take(bool isFine, const nlohmann::json& json, T& value) {
    isFine_ = isFine_ && isFine;
    if (isFine) {
      value = json.get<T>();
    }
  }

  const nlohmann::json& object_;
  bool isFine_;
};

constexpr std::size_t kLargestJson = 65536;  // [B] of a message: no honest one is larger

/// None: the text is no JSON or too large, or a field has another type. Any bytes are safe.
template <class M>
std::optional<M> messageOfJson(std::string_view text) {
  if (text.size() > kLargestJson) {
    return std::nullopt;
  }
  const nlohmann::json object = nlohmann::json::parse(text, nullptr, false);
  M message;
  JsonFields fields(object);
  if constexpr (!bridge::kIsEmptyMessage<M>) {
    M::fields(message, fields);
  }
  return fields.isFine() ? std::optional<M>(message) : std::nullopt;
}

/// Of a message of numbers and texts.
template <class M>
std::string jsonOf(const M& message) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  M::fields(message, [&object](const char* name, const auto& value) { object[name] = value; });
  return base::jsonText(object, -1);
}

}  // namespace live
