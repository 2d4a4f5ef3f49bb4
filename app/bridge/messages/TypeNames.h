#pragma once

#include <string>
#include <string_view>

namespace bridge {

/// "geometry_msgs::msg::dds_::Twist_" of "geometry_msgs/msg/Twist": the name of the type in DDS.
std::string ddsTypeName(std::string_view type);

/// The other way; empty: it is no such name.
std::string rosTypeName(std::string_view ddsType);

/// "geometry_msgs/Twist" of "geometry_msgs/msg/Twist": the name in texts of messages.
std::string shortTypeName(std::string_view type);

}  // namespace bridge
