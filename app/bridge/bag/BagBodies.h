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
#include "app/bridge/bag/TopicSelection.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/Time.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "sim2d/base/Types.h"
#include "sim2d/trace/Trace.h"

namespace bridge {

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
  std::optional<double> heading;  // none: unknown
  std::optional<base::Vec2> velocity;
  std::optional<double> omega;
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
  const Part* find(const std::string& name) const;
};

/// Reads the bodies, map, goals and obstacles from the chosen topics.
class BagBodies {
 public:
  BagBodies(Bag& bag, TopicSelection choice, std::string path);

  /// Returns all problems. Warnings: unreadable messages, topics without readable messages.
  base::Diagnostics read();

  const std::map<int, BagBody>& people() const { return people_; }
  const std::map<int, BagBody>& robots() const { return robots_; }
  const std::optional<sim2d::OccupancyGrid>& map() const { return map_; }
  /// The goals sent to the robot, each once, in order.
  const std::vector<base::Vec2>& goals() const { return goals_; }
  std::optional<std::int64_t> firstGoal() const { return firstGoal_; }  // [ns], stamp
  const std::vector<BagObstacles>& obstacles() const { return obstacles_; }
  bool hasInvalidSamples() const { return invalid_.hasDiscardedSamples(); }

 private:
  struct ReadCounts {
    std::size_t read = 0, lost = 0;
    std::string first;  // first error
  };

  void take(std::size_t channel, std::int64_t time, std::string_view bytes);
  template <class M>
  std::optional<M> decoded(std::size_t channel, std::string_view bytes);
  void takeAgents(std::size_t channel, std::string_view bytes, std::int64_t time);
  void takePeople(std::size_t channel, std::string_view bytes);
  bool isValid(std::size_t channel, const people_msgs::Person& person, bool hasTurning);
  void takeRobot(std::size_t channel, std::int64_t time, std::string_view bytes);
  void takeAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
                 std::map<int, BagBody>& to);
  bool isValid(std::size_t channel, const hunav_msgs::Agent& agent);
  std::vector<base::Vec2> obstaclesOf(std::size_t channel, const hunav_msgs::Agent& agent);
  void setMissing(std::size_t channel, const hunav_msgs::Agent& agent, BagBody& body);
  void takeOdometry(std::size_t channel, const nav_msgs::Odometry& odometry);
  bool takePose(std::size_t channel, const std_msgs::Header& header,
                const geometry_msgs::Pose& pose);
  void takeTransforms(std::size_t channel, std::string_view bytes);
  void takeMap(std::size_t channel, std::string_view bytes);
  void takeGoal(std::size_t channel, std::string_view bytes);
  void takeObstacles(std::size_t channel, std::string_view bytes);
  base::Pose2 toMap(const std::string& frame);
  BagBody& robot();
  void assignRobotStamps();
  base::Diagnostics losses() const;

  Bag& bag_;
  TopicSelection selection_;
  std::string path_;
  FrameTree frames_;
  std::map<int, BagBody> people_, robots_;
  std::optional<sim2d::OccupancyGrid> map_;
  std::vector<base::Vec2> goals_;
  std::optional<std::int64_t> firstGoal_;
  std::vector<BagObstacles> obstacles_;
  InvalidNumbers invalid_;
  std::map<std::size_t, ReadCounts> readCounts_;      // by channel
  std::map<std::string, std::size_t> unknownFrames_;  // frames without a transform to map
  std::map<std::string, int> named_;                  // ids assigned to people by name
  std::vector<std::pair<std::int64_t, std::int64_t>>
      peopleStamps_;  // [ns], recording time and stamp
};

template <class M>
std::optional<M> BagBodies::decoded(std::size_t channel, std::string_view bytes) {
  ReadCounts& losses = readCounts_[channel];
  base::Result<M> message = decode<M>(bytes);
  if (!message) {
    if (losses.lost++ == 0) {
      losses.first = message.diagnostics().front().text();
    }
    return std::nullopt;
  }
  ++losses.read;
  return *std::move(message);
}

}  // namespace bridge
