#include "app/bridge/bag/BagTopics.h"

namespace bridge {
namespace {

constexpr int kKeepLast = 1, kReliable = 1, kTransientLocal = 1, kVolatile = 2, kAutomatic = 1;
constexpr int kMetadataVersion = 5;
constexpr const char* kForEver = "\n    sec: 9223372036\n    nsec: 854775807\n";

/// Between double quotes of YAML.
std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '\n') {
      all += "\\n";
      continue;
    }
    all += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return all + "\"";
}

std::string topicLines(const BagTopic& topic) {
  return "    - topic_metadata:\n"
         "        name: " +
         quoted(topic.name) +
         "\n"
         "        type: " +
         quoted(topic.type) +
         "\n"
         "        serialization_format: cdr\n"
         "        offered_qos_profiles: " +
         quoted(topic.qos) +
         "\n"
         "      message_count: " +
         std::to_string(topic.messages) + "\n";
}

}  // namespace

std::string offeredQos(const Topic& topic) {
  const auto line = [](const char* key, int value) {
    return std::string(key) + ": " + std::to_string(value) + "\n";
  };
  return line("- history", kKeepLast) + line("  depth", topic.depth) +
         line("  reliability", kReliable) +
         line("  durability", topic.isLatched ? kTransientLocal : kVolatile) +
         "  deadline:" + kForEver + "  lifespan:" + kForEver + line("  liveliness", kAutomatic) +
         "  liveliness_lease_duration:" + kForEver + "  avoid_ros_namespace_conventions: false";
}

std::string bagMetadata(const std::string& file, const std::vector<BagTopic>& topics,
                        const BagSpan& span, const std::string& storage) {
  const std::string begin = std::to_string(span.begin);
  const std::string length = std::to_string(span.end - span.begin);
  const std::string count = std::to_string(span.messages);
  std::string text =
      "rosbag2_bagfile_information:\n  version: " + std::to_string(kMetadataVersion) +
      "\n"
      "  storage_identifier: " +
      storage +
      "\n"
      "  duration:\n    nanoseconds: " +
      length +
      "\n"
      "  starting_time:\n    nanoseconds_since_epoch: " +
      begin +
      "\n"
      "  message_count: " +
      count +
      "\n"
      "  topics_with_message_count:\n";
  for (const BagTopic& topic : topics) {
    text += topic.messages > 0 ? topicLines(topic) : std::string();
  }
  return text +
         "  compression_format: \"\"\n"
         "  compression_mode: \"\"\n"
         "  relative_file_paths:\n    - " +
         quoted(file) +
         "\n"
         "  files:\n"
         "    - path: " +
         quoted(file) +
         "\n"
         "      starting_time:\n        nanoseconds_since_epoch: " +
         begin +
         "\n"
         "      duration:\n        nanoseconds: " +
         length +
         "\n"
         "      message_count: " +
         count + "\n";
}

}  // namespace bridge
