#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>

#include "sim2d/nav/nav2/Costmap.h"

namespace bt {

/// Number of a path in a store, as stored in blackboard entries: 0: none, an empty path. Each path
/// has a unique number, so numbers differ like the time stamps of Nav2's messages. A goal is a path
/// of one pose, goals are a path of several.
using PathId = std::int64_t;

/// The paths that entries of one robot's tree refer to. The newest kMost paths with at most
/// kMostPoses poses in total are kept, more than an hour of a tree that writes a pose in each step;
/// older ones are empty. An entry may refer to an old path, for example to a goal.
class PathStore {
 public:
  static constexpr std::size_t kMost = 100'000;
  static constexpr std::size_t kMostPoses = 2'000'000;

  PathId add(sim2d::nav2::Path path);
  /// Returns `known` if that path is equal: the output of a node has not changed.
  PathId addUnlessEqual(sim2d::nav2::Path path, PathId known);
  const sim2d::nav2::Path& get(PathId id) const;  // valid until a path is added

 private:
  std::deque<std::unique_ptr<const sim2d::nav2::Path>> paths_;
  PathId newest_ = 0;
  std::size_t poses_ = 0;  // total of the stored paths
};

/// Length along the poses [m].
double lengthOf(const sim2d::nav2::Path& path);

/// Values that blackboard entries refer to by number, like the paths of a PathStore. Numbers start
/// at 1; 0 is a default value. The newest kMost values are kept; older numbers give the default
/// value.
template <class T>
class HandleStore {
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
