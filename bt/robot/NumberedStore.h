#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

namespace bt {

/// Values that entries of a blackboard name by number, as a PathStore does for paths: 0 is none,
/// which is a default value. Each value gets a number of its own, from 1. The newest kMost are
/// kept; older ones read as none.
template <class T>
class NumberedStore {
 public:
  static constexpr std::size_t kMost = 256;

  std::int64_t add(T value) {
    values_.push_back(std::make_unique<const T>(std::move(value)));
    if (values_.size() > kMost) {
      values_.pop_front();
    }
    return ++newest_;
  }
  /// Valid until the next kMost values are added.
  const T& get(std::int64_t number) const {
    static const T kNone{};
    const std::int64_t first = newest_ - static_cast<std::int64_t>(values_.size()) + 1;
    const bool isKept = number >= first && number <= newest_ && number > 0;
    return isKept ? *values_[static_cast<std::size_t>(number - first)] : kNone;
  }

 private:
  std::deque<std::unique_ptr<const T>> values_;
  std::int64_t newest_ = 0;
};

}  // namespace bt
