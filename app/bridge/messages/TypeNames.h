#pragma once

#include <string>
#include <string_view>

namespace bridge {

/// The DDS type name: "geometry_msgs/msg/Twist" -> "geometry_msgs::msg::dds_::Twist_".
std::string ddsTypeName(std::string_view type);

/// The inverse of ddsTypeName. Empty if `ddsType` is not a ROS type name.
std::string rosTypeName(std::string_view ddsType);

/// The name in message definitions: "geometry_msgs/msg/Twist" -> "geometry_msgs/Twist".
std::string shortTypeName(std::string_view type);

}  // namespace bridge
