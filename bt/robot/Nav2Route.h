#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"

namespace bt {

/// The goals of one run of a navigator's tree: one, or all of a route through several. Those that
/// the world counts as reached and those that the tree has taken away are told apart.
class Nav2Route {
 public:
  /// From `from` to the goal, with `isThrough` on through those after it.
  void begin(const base::Pose2& from, const base::Vec2& goal, const std::vector<base::Vec2>& after,
             bool isThrough);
  /// Whether what the world still wants is the end of this route; else a new run has to begin.
  bool goesOnWith(const base::Vec2& goal, const std::vector<base::Vec2>& after);
  bool isEmpty() const { return poses_.empty(); }

  /// Scenarios have points: each pose looks along the straight way from the one before.
  const sim2d::nav2::Path& poses() const { return poses_; }
  /// So many are left in the tree's own list.
  void treeLeft(std::size_t count);
  /// Those that the world still wants, the current one included; at least one.
  std::size_t left() const { return poses_.size() > reached_ ? poses_.size() - reached_ : 1; }
  /// Those that the tree has passed and the world has not.
  std::size_t takePassed();

 private:
  sim2d::nav2::Path poses_;
  bool isThrough_ = false;
  std::size_t reached_ = 0, passed_ = 0;  // of the world, of the tree
};

}  // namespace bt
