#pragma once

#include <cstddef>
#include <string>

namespace bridge {

/// Which middleware layer the nodes of others use (their RMW_IMPLEMENTATION). Topics work across
/// both; the identity of a service call is written in two ways, so services are for one of them.
enum class Rmw { FastRtps, CycloneDds };
/// From Iron on the graph has shorter identities; the rest is the same.
enum class Distro { Humble, Jazzy };

constexpr int kLastDomain = 232;  // its ports are the last that UDP has

struct DomainSettings {
  int domain = 0;  // ROS_DOMAIN_ID, 0 … 232
  Rmw rmw = Rmw::FastRtps;
  Distro distro = Distro::Humble;
  bool localhostOnly = true;  // false: every interface, with multicast
};

/// "/" or "/lab/a": words of letters, digits and _, no digit first.
inline bool isNamespace(const std::string& name) {
  bool begins = true;  // a word
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

/// A message in CDR with its header of four bytes.
using Bytes = std::string;

/// How samples are kept and sent. The defaults are those of a plain ROS 2 topic.
struct Qos {
  bool reliable = true;
  bool transientLocal = false;  // who comes later gets the last ones
  int depth = 10;               // of the history
  double lifespan = 0.0;        // [s]; 0: for ever
  /// For a subscription: publishers that offer less than it requests are received too, without
  /// retransmission of lost samples. DDS alone does not match them.
  bool anyPublisher = false;

  static Qos keepLast(int depth) { return {true, false, depth, 0.0, false}; }
  static Qos sensor() { return {false, false, 5, 0.0, false}; }  // for subscriptions
  static Qos latched() { return {true, true, 1, 0.0, false}; }   // /map, /tf_static
  static Qos clockReader() { return {false, false, 1, 0.0, false}; }
  /// For input from other programs, whatever quality of service they publish with.
  static Qos input(int depth = 10) { return {true, false, depth, 0.0, true}; }
  static Qos transforms() { return keepLast(100); }
  static Qos parameters() { return keepLast(1000); }  // their services and events
  static Qos log() { return {true, true, 1000, 10.0, false}; }
};

}  // namespace bridge
