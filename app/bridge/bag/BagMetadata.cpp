#include "app/bridge/bag/BagMetadata.h"

namespace bridge {
namespace {

constexpr int kKeepLast = 1, kReliable = 1, kTransientLocal = 1, kVolatile = 2, kAutomatic = 1;
constexpr int kMetadataVersion = 5;
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

/// Uses Foxglove's panel types: 3D, Plot, RawMessages.
std::string foxgloveLayout() {
  return R"~~~({
  "configById": {
    "3D!hunavsim": {
      "cameraState": {
        "perspective": false,
        "distance": 25,
        "phi": 0,
        "thetaOffset": 0,
        "targetOffset": [0, 0, 0],
        "target": [0, 0, 0],
        "targetOrientation": [0, 0, 0, 1],
        "fovy": 45,
        "near": 0.5,
        "far": 5000
      },
      "followMode": "follow-none",
      "followTf": "map",
      "scene": {"transforms": {"showLabel": false, "axisScale": 0.5}},
      "layers": {"grid": {"layerId": "foxglove.Grid", "visible": true, "frameId": "map"}},
      "topics": {
        "/map": {"visible": true, "colorMode": "map"},
        "/obstacles": {"visible": true},
        "/markers": {"visible": true},
        "/scan": {"visible": true, "colorMode": "flat", "flatColor": "#d0632dff"},
        "/plan": {"visible": true, "type": "line", "lineWidth": 0.08},
        "/goal_pose": {"visible": true},
        "/odom": {"visible": false}
      }
    },
    "Plot!hunavsim": {
      "title": "Speed of the robot",
      "paths": [
        {"value": "/robot_states.linear_vel", "enabled": true, "timestampMethod": "receiveTime", "label": "linear [m/s]"},
        {"value": "/robot_states.angular_vel", "enabled": true, "timestampMethod": "receiveTime", "label": "angular [rad/s]"}
      ],
      "showLegend": true,
      "xAxisVal": "timestamp"
    },
    "RawMessages!hunavsim": {"topicPath": "/human_states", "diffEnabled": false}
  },
  "globalVariables": {},
  "userNodes": {},
  "playbackConfig": {"speed": 1},
  "layout": {
    "direction": "row",
    "first": "3D!hunavsim",
    "second": {
      "direction": "column",
      "first": "Plot!hunavsim",
      "second": "RawMessages!hunavsim",
      "splitPercentage": 40
    },
    "splitPercentage": 68
  }
}
)~~~";
}

}  // namespace bridge
