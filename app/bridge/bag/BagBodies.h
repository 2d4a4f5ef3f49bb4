#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/bag/BadNumbers.h"
#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagChoice.h"
#include "app/bridge/bag/FrameTree.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/HunavMessages.h"
#include "app/bridge/messages/MarkerMessages.h"
#include "app/bridge/messages/NavigationMessages.h"
#include "sim2d/trace/Trace.h"

namespace bridge {

/// The shortest decimal number that this float is: 0.05 of 0.0500000007.
double asWritten(float value);

constexpr double kNanosecond = 1e-9;  // [s]
constexpr double kSamePlace = 1e-6;   // [m]: precision of a position in a message

inline std::int64_t nanosecondsOf(const builtin_interfaces::Time& stamp) {
  return std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec;
}

/// A body at an instant. Map frame.
struct BagSample {
  std::int64_t time = 0;  // [ns]
  base::Pose2 pose;
  std::optional<double> heading;  // none: not told
  std::optional<base::Vec2> velocity;
  std::optional<double> omega;
  int group = -1;
  std::uint8_t state = 0;
  std::optional<base::Vec2> goal;     // the current one
  std::vector<base::Vec2> obstacles;  // points near the body (closest_obs)
};

/// A person or robot of a bag.
struct BagBody {
  int id = 0;
  std::string name;
  /// Its properties in hunav_msgs; each is taken from the first message that fills it in. Its goals
  /// are all goals in the messages, in order.
  std::optional<hunav_msgs::Agent> told;
  std::vector<BagSample> samples;  // in the order of the bag
};

/// The outlines on /obstacles from a certain time on.
struct BagObstacles {
  struct Part {
    std::string name;  // of the obstacle or door
    std::vector<sim2d::Outline> outlines;
  };
  std::int64_t time = 0;  // [ns]
  std::vector<Part> parts;
  const Part* find(const std::string& name) const;
};

/// Reads the messages of a choice.
class BagBodies {
 public:
  BagBodies(Bag& bag, BagChoice choice, std::string path);

  /// All problems; warnings: what could not be read, topics of which nothing could.
  base::Diagnostics read();

  const std::map<int, BagBody>& people() const { return people_; }
  const std::map<int, BagBody>& robots() const { return robots_; }
  const std::optional<sim2d::OccupancyGrid>& map() const { return map_; }
  /// Goals sent to the robot, each once, in order.
  const std::vector<base::Vec2>& goals() const { return goals_; }
  std::optional<std::int64_t> firstGoal() const { return firstGoal_; }  // its stamp [ns]
  const std::vector<BagObstacles>& obstacles() const { return obstacles_; }
  bool hasBadSamples() const { return bad_.hasSamples(); }

 private:
  struct Losses {
    std::size_t read = 0, lost = 0;
    std::string first;  // why
  };

  void take(std::size_t channel, std::int64_t time, std::string_view bytes);
  template <class M>
  std::optional<M> decoded(std::size_t channel, std::string_view bytes);
  void takeAgents(std::size_t channel, std::string_view bytes, std::int64_t time);
  void takePeople(std::size_t channel, std::string_view bytes);
  bool isFine(std::size_t channel, const people_msgs::Person& person, bool hasTurning);
  void takeRobot(std::size_t channel, std::int64_t time, std::string_view bytes);
  void takeAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
                 std::map<int, BagBody>& to);
  bool isFine(std::size_t channel, const hunav_msgs::Agent& agent);
  std::vector<base::Vec2> obstaclesOf(std::size_t channel, const hunav_msgs::Agent& agent);
  void fillIn(std::size_t channel, const hunav_msgs::Agent& agent, BagBody& body);
  void takeOdometry(std::size_t channel, const nav_msgs::Odometry& odometry);
  bool takePose(std::size_t channel, const std_msgs::Header& header,
                const geometry_msgs::Pose& pose);
  void takeTransforms(std::size_t channel, std::string_view bytes);
  void takeMap(std::size_t channel, std::string_view bytes);
  void takeGoal(std::size_t channel, std::string_view bytes);
  void takeObstacles(std::size_t channel, std::string_view bytes);
  base::Pose2 toMap(const std::string& frame);
  BagBody& robot();
  void pairRobots();
  base::Diagnostics losses() const;

  Bag& bag_;
  BagChoice choice_;
  std::string path_;
  FrameTree frames_;
  std::map<int, BagBody> people_, robots_;
  std::optional<sim2d::OccupancyGrid> map_;
  std::vector<base::Vec2> goals_;
  std::optional<std::int64_t> firstGoal_;
  std::vector<BagObstacles> obstacles_;
  BadNumbers bad_;
  std::map<std::size_t, Losses> losses_;                       // by channel
  std::map<std::string, std::size_t> strange_;                 // frames without a way to the map's
  std::map<std::string, int> named_;                           // ids of people who have names alone
  std::vector<std::pair<std::int64_t, std::int64_t>> stamps_;  // recorded, stamp of people [ns]
};

template <class M>
std::optional<M> BagBodies::decoded(std::size_t channel, std::string_view bytes) {
  Losses& losses = losses_[channel];
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
