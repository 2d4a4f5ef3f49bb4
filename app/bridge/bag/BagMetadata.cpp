#include "app/bridge/bag/BagMetadata.h"

namespace bridge {
namespace {

constexpr int kKeepLast = 1, kReliable = 1, kTransientLocal = 1, kVolatile = 2, kAutomatic = 1;
constexpr const char* kForEver = "\n    sec: 9223372036\n    nsec: 854775807\n";

/// A double-quoted YAML string.
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
  return R"(    - topic_metadata:
        name: )" +
         quoted(topic.name) + R"(
        type: )" +
         quoted(topic.type) + R"(
        serialization_format: cdr
        offered_qos_profiles: )" +
         quoted(topic.qos) + R"(
      message_count: )" +
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
  std::string text = R"(rosbag2_bagfile_information:
  version: 5
  storage_identifier: )" +
                     storage + R"(
  duration:
    nanoseconds: )" + length +
                     R"(
  starting_time:
    nanoseconds_since_epoch: )" +
                     begin + R"(
  message_count: )" + count +
                     R"(
  topics_with_message_count:
)";
  for (const BagTopic& topic : topics) {
    text += topic.messages > 0 ? topicLines(topic) : std::string();
  }
  return text + R"(  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - )" +
         quoted(file) + R"(
  files:
    - path: )" +
         quoted(file) + R"(
      starting_time:
        nanoseconds_since_epoch: )" +
         begin + R"(
      duration:
        nanoseconds: )" +
         length + R"(
      message_count: )" +
         count + "\n";
}

}  // namespace bridge
