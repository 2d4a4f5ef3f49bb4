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
  std::string name, type;
  std::uint64_t messages = 0;
  std::string qos;  // that its writer offers, as YAML
};

/// The quality of service that the topic's writer offers, as YAML.
std::string offeredQos(const Topic& topic);

struct BagSpan {
  std::int64_t begin = 0, end = 0;  // [ns]
  std::uint64_t messages = 0;
};

/// metadata.yaml of a folder with one file of that name, in that storage ("mcap", "sqlite3").
/// Topics without messages are left out.
std::string bagMetadata(const std::string& file, const std::vector<BagTopic>& topics,
                        const BagSpan& span, const std::string& storage = "mcap");

/// A layout for Foxglove: the map with people and robots, their speeds, raw messages.
std::string foxgloveLayout();

}  // namespace bridge
