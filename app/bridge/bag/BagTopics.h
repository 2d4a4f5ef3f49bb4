#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/topics/RunTopics.h"

/// What rosbag2 wants to know beside the messages (version 5 of its metadata: Humble; later ones
/// read it).
namespace bridge {

/// A topic in a bag.
struct BagTopic {
  Topic topic;
  std::uint64_t messages = 0;
};

/// The quality of service that the topic's writer offers, as YAML.
std::string offeredQos(const Topic& topic);

struct BagSpan {
  std::int64_t begin = 0, end = 0;  // [ns]
  std::uint64_t messages = 0;
};

/// metadata.yaml of a folder with one MCAP file of that name. Topics without messages are left out.
std::string bagMetadata(const std::string& file, const std::vector<BagTopic>& topics,
                        const BagSpan& span);

/// A layout for Foxglove: the map with people and robots, their speeds, raw messages.
std::string foxgloveLayout();

}  // namespace bridge
