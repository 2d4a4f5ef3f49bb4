#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/topics/RunTopics.h"

/// Metadata of rosbag2 (version 5: Humble and later).
namespace bridge {

/// A topic of a bag.
struct BagTopic {
  std::string name, type;
  std::uint64_t messages = 0;
  std::string qos;  // offered QoS profile as YAML
};

/// The offered QoS profile of the topic as YAML.
std::string offeredQos(const Topic& topic);

struct BagSpan {
  std::int64_t begin = 0, end = 0;  // [ns]
  std::uint64_t messages = 0;
};

/// The contents of metadata.yaml for a folder with one file `file` and this storage ("mcap",
/// "sqlite3"). Topics without messages are omitted.
std::string bagMetadata(const std::string& file, const std::vector<BagTopic>& topics,
                        const BagSpan& span, const std::string& storage = "mcap");

/// A Foxglove layout: the map with people and robots, their speeds, raw messages. The file
/// resources/foxglove_layout.json, embedded by the build.
extern const char* const kFoxgloveLayoutText;

}  // namespace bridge
