#pragma once

#include <optional>
#include <string>

/// How names of ROS 2 look in DDS. Source: design.ros2.org, "Topic and Service name mapping to DDS".
namespace bridge {

/// "human_states" in namespace "/lab" -> "/lab/human_states"; "~/x" of node "a" -> "/lab/a/x";
/// absolute names stay.
std::string resolvedName(const std::string& name, const std::string& space,
                         const std::string& node);

/// "/a/b" -> "rt/a/b".
std::string ddsTopic(const std::string& topic);
std::string ddsRequestTopic(const std::string& service);  // "rq/sRequest"
std::string ddsReplyTopic(const std::string& service);    // "rr/sReply"
/// "pkg/msg/Name" -> "pkg::msg::dds_::Name_"; nothing when it is no such name.
std::optional<std::string> ddsType(const std::string& type);
/// "pkg/srv/Name" -> "pkg::srv::dds_::Name_Request_".
std::optional<std::string> ddsRequestType(const std::string& type);
std::optional<std::string> ddsReplyType(const std::string& type);

/// A namespace or node name: letters, digits, _, no digit first; a namespace has / between, and
/// before.
bool isNodeName(const std::string& name);
bool isNamespace(const std::string& name);

}  // namespace bridge
