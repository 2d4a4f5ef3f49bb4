#pragma once

#include <string>

/// How names of ROS 2 look in DDS. Source: design.ros2.org, "Topic and Service name mapping to
/// DDS".
namespace bridge {

/// "human_states" in namespace "/lab" -> "/lab/human_states"; "~/x" of node "a" -> "/lab/a/x";
/// absolute names stay.
std::string resolvedName(const std::string& name, const std::string& space,
                         const std::string& node);

/// "/a/b" -> "rt/a/b".
std::string ddsTopic(const std::string& topic);
/// "/a/b" of "rt/a/b"; empty: it is no topic of ROS 2.
std::string rosTopic(const std::string& ddsTopic);
std::string ddsRequestTopic(const std::string& service);  // "rq/sRequest"
std::string ddsReplyTopic(const std::string& service);    // "rr/sReply"
/// Of "pkg/srv/Name": "pkg::srv::dds_::Name_Request_", "pkg::srv::dds_::Name_Response_".
std::string ddsRequestType(const std::string& type);
std::string ddsReplyType(const std::string& type);

}  // namespace bridge
