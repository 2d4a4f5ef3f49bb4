#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace bridge {

/// string<=N: a longer string is rejected when written and when read.
template <std::size_t N>
struct BoundedString : std::string {
  static constexpr std::size_t kBound = N;
  using std::string::string;
  using std::string::operator=;
};

/// T[<=N].
template <class T, std::size_t N>
struct BoundedSequence : std::vector<T> {
  static constexpr std::size_t kBound = N;
  using std::vector<T>::vector;
};

/// Traits that select the wire format of a field type.

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

/// The maximum number of elements or characters; 0: unbounded.
template <class T, class = void>
constexpr std::size_t kBoundOf = 0;
template <class T>
constexpr std::size_t kBoundOf<T, std::void_t<decltype(T::kBound)>> = T::kBound;

/// A message without fields is one zero byte on the wire.
template <class M>
constexpr bool kIsEmptyMessage = std::is_empty_v<M>;

/// For a message whose fields are all numbers of one type, contiguous in memory as on the wire. A
/// message declares this by `using PackedElement = double;` and is then copied as one block.
template <class M, class = void>
struct PackedTraits : std::false_type {};
template <class M>
struct PackedTraits<M, std::void_t<typename M::PackedElement>> : std::true_type {
  using Number = typename M::PackedElement;
  static constexpr std::size_t kCount = sizeof(M) / sizeof(Number);
  static_assert(std::is_trivially_copyable_v<M> && sizeof(M) % sizeof(Number) == 0);
};
template <class M>
constexpr bool kIsPacked = PackedTraits<M>::value;

}  // namespace bridge
