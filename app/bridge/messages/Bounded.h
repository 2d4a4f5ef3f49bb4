#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bridge {

/// string<=N: a longer one is neither written nor read.
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

}  // namespace bridge
