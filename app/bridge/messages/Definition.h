#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/bridge/messages/FieldTraits.h"
#include "app/bridge/messages/TypeNames.h"

namespace bridge {

/// The ROS name of a primitive type: "uint8", "float64" …
template <class T>
std::string primitiveName() {
  if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_same_v<T, std::byte>) {
    return "byte";
  } else {
    const char* kind = std::is_floating_point_v<T> ? "float" : std::is_signed_v<T> ? "int" : "uint";
    return kind + std::to_string(8 * sizeof(T));
  }
}

/// The type of a field as written in .msg files: "geometry_msgs/Pose[]", "string<=256".
template <class T>
std::string fieldTypeName() {
  if constexpr (kIsPrimitive<T>) {
    return primitiveName<T>();
  } else if constexpr (kIsString<T>) {
    return kBoundOf<T> > 0 ? "string<=" + std::to_string(kBoundOf<T>) : "string";
  } else if constexpr (kIsSequence<T>) {
    const std::string bound = kBoundOf<T> > 0 ? "<=" + std::to_string(kBoundOf<T>) : "";
    return fieldTypeName<typename T::value_type>() + "[" + bound + "]";
  } else if constexpr (kIsArray<T>) {
    return fieldTypeName<typename T::value_type>() + "[" + std::to_string(T().size()) + "]";
  } else {
    return shortTypeName(T::kType);
  }
}

/// The .msg definitions of a message and of all message types it contains.
class Definitions {
 public:
  /// Adds the message, then the types it contains, each once.
  template <class M>
  void add() {
    const std::size_t at = begin(shortTypeName(M::kType));
    if (at == kAlreadyAdded) {
      return;
    }
    if constexpr (kHasConstants<M>) {
      M::constants([this, at](const char* name, auto value) {
        sections_[at].lines +=
            primitiveName<decltype(value)>() + " " + name + "=" + std::to_string(value) + "\n";
      });
    }
    if constexpr (kIsEmptyMessage<M>) {
      sections_[at].lines += "uint8 structure_needs_at_least_one_member\n";
    } else {
      const M message{};
      M::fields(message, [this, at](const char* name, const auto& value) {
        using T = std::decay_t<decltype(value)>;
        sections_[at].lines += fieldTypeName<T>() + " " + name + "\n";
        addNested<T>();
      });
    }
  }

  /// The definitions in MCAP's `ros2msg` format: the first one, then each dependency after a
  /// separator line with its name.
  std::string text() const;

 private:
  static constexpr std::size_t kAlreadyAdded = static_cast<std::size_t>(-1);
  struct Section {
    std::string name, lines;
  };

  std::size_t begin(const std::string& name);  // starts a section; kAlreadyAdded: it exists
  template <class T>
  void addNested() {
    if constexpr (kIsSequence<T> || kIsArray<T>) {
      addNested<typename T::value_type>();
    } else if constexpr (!kIsPrimitive<T> && !kIsString<T>) {
      add<T>();
    }
  }

  std::vector<Section> sections_;
};

/// The definition of a message for MCAP (schema encoding "ros2msg") and the live view.
template <class M>
std::string definition() {
  Definitions definitions;
  definitions.add<M>();
  return definitions.text();
}

/// A supported message, request or response type.
struct KnownType {
  std::string_view type;   // "hunav_msgs/msg/Agents"
  std::string definition;  // in the ros2msg format
};

/// All supported types, in the order of AllMessages.
const std::vector<KnownType>& knownTypes();
const KnownType* findType(std::string_view type);  // null: unknown type

}  // namespace bridge
