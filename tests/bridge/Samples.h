#pragma once

#include <cstddef>
#include <string>
#include <type_traits>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include "app/bridge/messages/FieldTraits.h"

/// Fills messages with values of which no two neighbours are alike, each exact in its type. A
/// visitor for `fields`.
class SampleFiller {
 public:
  template <class T>
  void operator()(const char* /*name*/, T& value) {
    fill(value);
  }
  template <class T>
  void fill(T& value) {
    using namespace bridge;
    ++count_;
    if constexpr (std::is_same_v<T, bool>) {
      value = count_ % 2 == 0;
    } else if constexpr (std::is_same_v<T, std::byte>) {
      value = static_cast<std::byte>(count_ % 256);
    } else if constexpr (std::is_floating_point_v<T>) {
      value = static_cast<T>((count_ % 2 == 0 ? -0.25 : 0.25) * count_);
    } else if constexpr (std::is_signed_v<T> && std::is_integral_v<T>) {
      value = static_cast<T>(count_ % 2 == 0 ? -(count_ % 127) : count_ % 127);
    } else if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(count_ % 251);
    } else if constexpr (kIsString<T>) {
      value = std::string(static_cast<std::size_t>(count_ % 6), 'a') + std::to_string(count_);
    } else if constexpr (kIsSequence<T>) {
      fillSequence(value);
    } else if constexpr (kIsArray<T>) {
      for (auto& each : value) {
        fill(each);
      }
    } else if constexpr (!kIsEmptyMessage<T>) {
      T::fields(value, *this);
    }
  }

 private:
  template <class S>
  void fillSequence(S& values) {
    const std::size_t most = bridge::kBoundOf<S>;
    const std::size_t size = most > 0 ? most : 1 + static_cast<std::size_t>(count_) % 3;
    for (std::size_t i = 0; i < size; ++i) {
      typename S::value_type value{};
      fill(value);
      values.push_back(value);
    }
  }

  int count_ = 0;
};

/// The value as JSON in which numbers are texts, as 64 bits do not fit into JSON's.
template <class T>
QJsonValue sampleJson(const T& value) {
  using namespace bridge;
  if constexpr (std::is_same_v<T, bool>) {
    return value;
  } else if constexpr (std::is_same_v<T, std::byte>) {
    return QString::number(std::to_integer<int>(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    return QString::number(static_cast<double>(value), 'g', 17);
  } else if constexpr (kIsPrimitive<T>) {
    return QString::number(value);
  } else if constexpr (kIsString<T>) {
    return QString::fromStdString(value);
  } else if constexpr (kIsSequence<T> || kIsArray<T>) {
    QJsonArray all;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const typename T::value_type each = value[i];
      all.append(sampleJson(each));
    }
    return all;
  } else {
    QJsonObject all;
    if constexpr (!kIsEmptyMessage<T>) {
      T::fields(value, [&](const char* name, const auto& field) {
        all.insert(QLatin1String(name), sampleJson(field));
      });
    }
    return all;
  }
}
