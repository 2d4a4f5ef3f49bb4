#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// The DDS type name: "geometry_msgs/msg/Twist" -> "geometry_msgs::msg::dds_::Twist_".
std::string ddsTypeName(std::string_view type);

/// The inverse of ddsTypeName. Empty if `ddsType` is not a ROS type name.
std::string rosTypeName(std::string_view ddsType);

/// A supported message, request or response type.
struct KnownType {
  std::string_view type;   // "hunav_msgs/msg/Agents"
  const char* definition;  // in the ros2msg format
};

/// All supported types, in the order of AllMessages.
const std::vector<KnownType>& knownTypes();
const KnownType* findType(std::string_view type);  // null: unknown type

}  // namespace bridge
