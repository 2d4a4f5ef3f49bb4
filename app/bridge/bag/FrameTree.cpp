#include "app/bridge/bag/FrameTree.h"

#include "app/bridge/topics/RunMessages.h"

namespace bridge {
namespace {

constexpr int kLongestChain = 32;

/// Some write "/map".
std::string nameOf(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

base::Pose2 composed(const base::Pose2& outer, const base::Pose2& inner) {
  return {outer.toWorld(inner.position), base::wrapToPi(outer.heading + inner.heading)};
}

}  // namespace

base::Pose2 planarPose(const geometry_msgs::Pose& pose) {
  return {{pose.position.x, pose.position.y}, headingOf(pose.orientation)};
}

void FrameTree::add(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& each : message.transforms) {
    const geometry_msgs::Transform& t = each.transform;
    links_[nameOf(each.childFrameId)] = {
        nameOf(each.header.frameId), {{t.translation.x, t.translation.y}, headingOf(t.rotation)}};
  }
}

std::optional<base::Pose2> FrameTree::inMap(const std::string& frame) const {
  std::string name = nameOf(frame);
  base::Pose2 pose;
  for (int k = 0; k < kLongestChain; ++k) {
    if (name == kMapFrame) {
      return pose;
    }
    const auto link = links_.find(name);
    if (link == links_.end()) {
      return std::nullopt;
    }
    pose = composed(link->second.pose, pose);
    name = link->second.parent;
  }
  return std::nullopt;  // a ring
}

}  // namespace bridge
