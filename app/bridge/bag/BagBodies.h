#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"
#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "sim2d/base/Types.h"
#include "sim2d/trace/Trace.h"

namespace bridge {

/// Indices of the channels from which a trace is created.
struct TopicSelection {
  std::optional<std::size_t> people, map;
  std::vector<std::size_t> robots;       // several only in bags written by hunavsim
  std::vector<std::size_t> transforms;   // tf and tf_static
  bool isRobotFromTf = false;            // the robot's pose is a transform
  std::optional<std::size_t> goals;      // /goal_pose of the chosen robot
  std::optional<std::size_t> obstacles;  // obstacle outlines published by hunavsim
};

/// The topics of a bag written by hunavsim. Without people: the bag was modified.
TopicSelection hunavsimTopics(const std::vector<BagChannel>& channels);

/// Selects topics by the user's options, otherwise by types and usual names. Errors: a missing
/// topic, a topic of an unsuitable type, neither people nor a robot.
TopicSelection selectTopics(const std::vector<BagChannel>& channels, const BagTopicOptions& use,
                            const std::string& path, base::Diagnostics& problems);

// Limits for plausible numbers in recordings.
constexpr double kMostMetres = 1e9;    // [m] from the origin, as in the track reader
constexpr double kMostSpeed = 1e4;     // [m/s] and [rad/s]
constexpr double kMostRadius = 100.0;  // [m], radius of a body
constexpr double kMostFactor = 1e6;    // force factors; also [m], radius of a goal

/// Counts numbers that are not finite or implausibly large, by topic and field.
class InvalidNumbers {
 public:
  enum class Loss { Sample, Value };  // what is discarded with the number

  /// Returns false and counts the problem if a number is not finite or its magnitude is above
  /// `most`.
  bool areValid(std::size_t channel, const char* field, std::initializer_list<double> numbers,
                double most, Loss loss = Loss::Sample);
  bool hasDiscardedSamples() const;  // whether samples were discarded
  /// One warning per topic and field.
  base::Diagnostics warnings(const std::vector<BagChannel>& channels,
                             const std::string& path) const;

 private:
  struct Count {
    std::size_t count = 0;
    double first = 0.0;
    Loss loss = Loss::Sample;
  };
  std::map<std::pair<std::size_t, std::string>, Count> counts_;
};

/// The newest tf transforms, projected to the plane.
class FrameTree {
 public:
  void add(const tf2_msgs::TFMessage& message);
  /// The pose of the frame in the map frame. Nothing: not connected to the map frame.
  std::optional<base::Pose2> inMap(const std::string& frame) const;

 private:
  struct Link {
    std::string parent;
    base::Pose2 pose;  // in the parent frame
  };
  std::map<std::string, Link> links_;  // by child frame
};

base::Pose2 planarPose(const geometry_msgs::Pose& pose);

/// The double closest to the shortest decimal representation of a float: 0.05 instead of
/// 0.0500000007.
double shortestDecimal(float value);

constexpr double kNanosecond = 1e-9;  // [s]
constexpr double kSamePlace = 1e-6;   // [m], precision of positions in messages

/// The state of a body at one time, in the map frame.
struct BagSample {
  std::int64_t time = 0;  // [ns]
  base::Pose2 pose;
  std::optional<double> heading;       // [rad]; none: unknown
  std::optional<base::Vec2> velocity;  // [m/s]
  std::optional<double> omega;         // [rad/s]
  int group = -1;
  std::uint8_t state = 0;
  std::optional<base::Vec2> goal;     // current goal
  std::vector<base::Vec2> obstacles;  // points near the body (closest_obs)
};

/// A person or robot in a bag.
struct BagBody {
  int id = 0;
  std::string name;
  /// Properties from hunav_msgs, each from the first message that sets it. The goals are all goals
  /// in the messages, in order.
  std::optional<hunav_msgs::Agent> properties;
  std::vector<BagSample> samples;  // in bag order
};

/// The outlines on /obstacles from `time` on.
struct BagObstacles {
  struct Part {
    std::string name;  // name of the obstacle or door
    std::vector<sim2d::Outline> outlines;
  };
  std::int64_t time = 0;  // [ns]
  std::vector<Part> parts;
};

/// What the chosen topics contain.
struct BagBodies {
  std::map<int, BagBody> people, robots;  // by id
  std::optional<sim2d::OccupancyGrid> map;
  std::vector<base::Vec2> goals;          // sent to the robot, each once, in order
  std::optional<std::int64_t> firstGoal;  // [ns], stamp
  std::vector<BagObstacles> obstacles;
  bool hasInvalidSamples = false;  // whether samples were discarded
};

/// Reads the chosen topics. `problems` receives all problems. Warnings: unreadable messages, topics
/// without readable messages.
BagBodies readBodies(Bag& bag, const TopicSelection& selection, const std::string& path,
                     base::Diagnostics& problems);

/// Adds a sample to the body of the agent, and properties that it does not have yet. Agents with
/// invalid numbers are discarded.
void addAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
              InvalidNumbers& invalid, std::map<int, BagBody>& to);

}  // namespace bridge
