#pragma once

#include <cstddef>
#include <string>

namespace bridge {

/// The RMW implementation of the other nodes (their RMW_IMPLEMENTATION). Topics are compatible
/// between both. Service calls encode the request identity differently, so services work with one
/// of them.
enum class Rmw { FastRtps, CycloneDds };
/// From Iron on, GIDs in the graph are 16 bytes instead of 24. There is no other difference.
enum class Distro { Humble, Jazzy };

constexpr int kLastDomain = 232;  // the last domain with valid UDP ports

struct DomainSettings {
  int domain = 0;  // ROS_DOMAIN_ID, 0 … 232
  Rmw rmw = Rmw::FastRtps;
  Distro distro = Distro::Humble;
  bool localhostOnly = true;  // false: every interface, with multicast
};

/// Whether `name` is a namespace: "/" or "/lab/a", parts of letters, digits and _, not starting
/// with a digit.
inline bool isNamespace(const std::string& name) {
  bool begins = true;  // start of a name part
  for (std::size_t i = 1; i < name.size(); ++i) {
    const char c = name[i];
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool isInside = !begins && ((c >= '0' && c <= '9') || c == '/');
    if (!isLetter && !isInside) {
      return false;
    }
    begins = c == '/';
  }
  return !name.empty() && name.front() == '/' && (name.size() == 1 || !begins);
}

/// A CDR message with its 4-byte encapsulation header.
using Bytes = std::string;

/// Quality of service of a topic. The defaults are those of a ROS 2 topic.
struct Qos {
  bool reliable = true;
  bool transientLocal = false;  // late subscribers get the last samples
  int depth = 10;               // history depth
  double lifespan = 0.0;        // [s]; 0: infinite
  /// For subscriptions: also receives from publishers whose offered QoS is incompatible, without
  /// retransmission of lost samples. Plain DDS does not match them.
  bool anyPublisher = false;

  static Qos keepLast(int depth) { return {true, false, depth, 0.0, false}; }
  static Qos sensor() { return {false, false, 5, 0.0, false}; }  // for subscriptions
  static Qos latched() { return {true, true, 1, 0.0, false}; }   // /map, /tf_static
  static Qos clockReader() { return {false, false, 1, 0.0, false}; }
  /// For input from other programs with any QoS.
  static Qos input(int depth = 10) { return {true, false, depth, 0.0, true}; }
  static Qos transforms() { return keepLast(100); }
  static Qos parameters() { return keepLast(1000); }  // parameter services and events
  static Qos log() { return {true, true, 1000, 10.0, false}; }
};

/// Mangling of ROS 2 names for DDS. See design.ros2.org, "Topic and Service name mapping to
/// DDS".

/// "human_states" in namespace "/lab" -> "/lab/human_states"; "~/x" of node "a" -> "/lab/a/x".
/// Absolute names are unchanged.
std::string resolvedName(const std::string& name, const std::string& nameSpace,
                         const std::string& node);

/// "/a/b" -> "rt/a/b".
std::string ddsTopic(const std::string& topic);
/// "rt/a/b" -> "/a/b". Empty if it is not a ROS 2 topic.
std::string rosTopic(const std::string& ddsTopic);
std::string ddsRequestTopic(const std::string& service);  // "rq/sRequest"
std::string ddsReplyTopic(const std::string& service);    // "rr/sReply"
/// "pkg/srv/Name" -> "pkg::srv::dds_::Name_Request_", "pkg::srv::dds_::Name_Response_".
std::string ddsRequestType(const std::string& type);
std::string ddsReplyType(const std::string& type);

}  // namespace bridge
