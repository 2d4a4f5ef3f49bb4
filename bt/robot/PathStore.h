#pragma once

#include <cstdint>
#include <deque>
#include <memory>

#include "sim2d/nav/nav2/Costmap.h"

namespace bt {

/// Number of a path of a store, as blackboard entries hold it: 0 = none, which is an empty path.
/// Each path gets a number of its own, so numbers differ as Nav2's messages with their stamps do.
/// A goal is a path of one pose, goals are one of several.
using PathId = std::int64_t;

/// The paths that entries of one robot's tree name. The newest kMost are kept, and kMostPoses of
/// all of them together, which is more than an hour of a tree that writes a pose in each step;
/// older ones are empty. An entry may name a path that was written long before: a goal, a path that
/// stays.
class PathStore {
 public:
  static constexpr std::size_t kMost = 100'000;
  static constexpr std::size_t kMostPoses = 2'000'000;

  PathId add(sim2d::nav2::Path path);
  /// `known` when its path is the same: the output of a node that did not change.
  PathId addUnlessEqual(sim2d::nav2::Path path, PathId known);
  const sim2d::nav2::Path& get(PathId id) const;  // valid until a path is added

 private:
  std::deque<std::unique_ptr<const sim2d::nav2::Path>> paths_;
  PathId newest_ = 0;
  std::size_t poses_ = 0;  // of all that are kept
};

/// Sum of the distances between neighbours [m].
double lengthOf(const sim2d::nav2::Path& path);

}  // namespace bt
