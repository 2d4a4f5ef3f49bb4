#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/topics/RunTopics.h"

/// What the sources of RunTopics share.
namespace bridge {

constexpr const char* kOdometry = "odom";
constexpr const char* kSensor = "base_scan";

/// Where the frame `child` is in the frame `parent`, at `seconds` of simulation time.
geometry_msgs::TransformStamped transformTo(double seconds, const std::string& parent,
                                            const std::string& child, const base::Pose2& pose);

/// One frame on its way.
struct RunTopics::Telling {
  const sim2d::Frame& frame;
  const Send& send;
  const Wants& wants;
  std::vector<std::size_t>& lengths;  // [bytes] of the last messages

  bool isWanted(std::size_t topic) const { return !wants || wants(topic); }
  template <class M>
  void sendMade(std::size_t topic, const M& message) const {
    std::string bytes = encode(message, lengths[topic]);
    lengths[topic] = bytes.size();
    send(topic, std::move(bytes));
  }
  template <class Make>
  void tell(std::size_t topic, const Make& make) const {
    if (isWanted(topic)) {
      sendMade(topic, make());
    }
  }
  /// One that is made in the memory of the last.
  template <class M, class Set>
  void tellReused(std::size_t topic, M& message, const Set& set) const {
    if (isWanted(topic)) {
      set(message);
      sendMade(topic, message);
    }
  }
  /// One that is shorter than the others of its topic.
  template <class Make>
  void tellShort(std::size_t topic, const Make& make) const {
    if (isWanted(topic)) {
      send(topic, encode(make()));
    }
  }
};

}  // namespace bridge
