#include "bt/robot/PathStore.h"

#include <algorithm>
#include <utility>

namespace bt {
namespace {

bool isSamePose(const base::Pose2& a, const base::Pose2& b) {
  return a.position == b.position && a.heading == b.heading;
}

}  // namespace

PathId PathStore::add(sim2d::nav2::Path path) {
  poses_ += path.size();
  paths_.push_back(std::make_unique<const sim2d::nav2::Path>(std::move(path)));
  constexpr std::size_t kAlways = 1;  // the new path is always kept
  while (paths_.size() > kAlways && (paths_.size() > kMost || poses_ > kMostPoses)) {
    poses_ -= paths_.front()->size();
    paths_.pop_front();
  }
  return ++newest_;
}

PathId PathStore::addUnlessEqual(sim2d::nav2::Path path, PathId known) {
  const sim2d::nav2::Path& before = get(known);
  const bool isSame =
      known > 0 && std::equal(path.begin(), path.end(), before.begin(), before.end(), isSamePose);
  return isSame ? known : add(std::move(path));
}

const sim2d::nav2::Path& PathStore::get(PathId id) const {
  static const sim2d::nav2::Path kNone;
  const PathId first = newest_ - static_cast<PathId>(paths_.size()) + 1;
  const bool isKept = id >= first && id <= newest_ && id > 0;
  return isKept ? *paths_[static_cast<std::size_t>(id - first)] : kNone;
}

double lengthOf(const sim2d::nav2::Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (path[i].position - path[i - 1].position).norm();
  }
  return length;
}

}  // namespace bt
