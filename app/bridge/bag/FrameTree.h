#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/bridge/messages/GeometryMessages.h"
#include "sim2d/base/Types.h"

namespace bridge {

/// The newest transforms of tf, in the plane.
class FrameTree {
 public:
  void add(const tf2_msgs::TFMessage& message);
  /// Where the frame is in the map's; none: no chain of transforms leads there.
  std::optional<base::Pose2> inMap(const std::string& frame) const;

 private:
  struct Link {
    std::string parent;
    base::Pose2 pose;  // in the parent
  };
  std::map<std::string, Link> links_;  // by child
};

base::Pose2 planarPose(const geometry_msgs::Pose& pose);

}  // namespace bridge
