#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// A message, request or response that we know, by its name.
struct KnownType {
  std::string_view type;   // "hunav_msgs/msg/Agents"
  std::string definition;  // form `ros2msg`
};

/// All of them, in the order of AllMessages.
const std::vector<KnownType>& knownTypes();
const KnownType* findType(std::string_view type);  // nullptr: not known

}  // namespace bridge
