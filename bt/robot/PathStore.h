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

/// The paths that entries of one robot's tree speak of. The newest kMost are kept, which is far
/// more than a tree refers to at a time; older ones are empty.
class PathStore {
 public:
  static constexpr std::size_t kMost = 256;

  PathId add(sim2d::nav2::Path path);
  /// `known` when its path is the same: the output of a node that did not change.
  PathId addUnlessEqual(sim2d::nav2::Path path, PathId known);
  const sim2d::nav2::Path& get(PathId id) const;  // good until the next kMost are added

 private:
  std::deque<std::unique_ptr<const sim2d::nav2::Path>> paths_;
  PathId newest_ = 0;
};

/// Sum of the distances between neighbours [m].
double lengthOf(const sim2d::nav2::Path& path);

}  // namespace bt
