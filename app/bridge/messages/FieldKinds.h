#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/bridge/messages/Bounded.h"

/// What the type of a field is on the wire.
namespace bridge {

template <class T>
constexpr bool kIsPrimitive = std::is_arithmetic_v<T> || std::is_same_v<T, std::byte>;

template <class T>
constexpr bool kIsString = std::is_base_of_v<std::string, T>;

template <class T>
struct SequenceTraits : std::false_type {};
template <class T>
struct SequenceTraits<std::vector<T>> : std::true_type {};
template <class T, std::size_t N>
struct SequenceTraits<BoundedSequence<T, N>> : std::true_type {};
template <class T>
constexpr bool kIsSequence = SequenceTraits<T>::value;

template <class T>
struct ArrayTraits : std::false_type {};
template <class T, std::size_t N>
struct ArrayTraits<std::array<T, N>> : std::true_type {};
template <class T>
constexpr bool kIsArray = ArrayTraits<T>::value;

/// The most elements or characters; 0: any number.
template <class T, class = void>
constexpr std::size_t kBoundOf = 0;
template <class T>
constexpr std::size_t kBoundOf<T, std::void_t<decltype(T::kBound)>> = T::kBound;

/// A message without fields: one byte of value 0 on the wire.
template <class M>
constexpr bool kIsEmptyMessage = std::is_empty_v<M>;

/// All fields are numbers of one size and stand one after the other, as on the wire: those that say
/// so by `using AllOf = double;` are taken as one.
template <class M, class = void>
struct BlockTraits : std::false_type {};
template <class M>
struct BlockTraits<M, std::void_t<typename M::AllOf>> : std::true_type {
  using Number = typename M::AllOf;
  static constexpr std::size_t kCount = sizeof(M) / sizeof(Number);
  static_assert(std::is_trivially_copyable_v<M> && sizeof(M) % sizeof(Number) == 0);
};
template <class M>
constexpr bool kIsBlock = BlockTraits<M>::value;

struct ConstantVisitor {
  template <class T>
  void operator()(const char* name, T value);
};
template <class M, class = void>
struct ConstantTraits : std::false_type {};
template <class M>
struct ConstantTraits<M, std::void_t<decltype(M::constants(std::declval<ConstantVisitor&>()))>>
    : std::true_type {};
/// Whether the message has constants.
template <class M>
constexpr bool kHasConstants = ConstantTraits<M>::value;

}  // namespace bridge
