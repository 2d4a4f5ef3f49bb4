#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/base/Types.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
struct Scenario;
}  // namespace sim2d

namespace bridge {

struct Topic {
  std::string name;        // "/human_states"
  std::string_view type;   // a type of the type table: "hunav_msgs/msg/Agents"
  bool isLatched = false;  // published on change; late subscribers get the last one
  int depth = 10;
};

struct RunTopicsOptions {
  bool clock = true;  // publish /clock; false for bags (the player provides it)
  /// Lidar poses in the robots' frames; none: unknown (`lidarsOf`).
  std::vector<std::optional<base::Pose2>> lidarMounts;
  std::vector<double> lidarRates;  // [Hz], same order; missing: 10
};

/// Lidar mounts and rates of a scenario, in the order of a frame's robots.
RunTopicsOptions lidarsOf(const sim2d::Scenario& scenario);

/// A run as messages on topics, frame by frame, for DDS, MCAP and the live view:
///
///   /clock  /tf  /tf_static  /map  /obstacles  /markers  /human_states  /people
/// and for each robot  /robot_states  /odom  /scan  /plan  /goal_pose
///
/// The topics and frames of the second and further robots are prefixed with the robot's name:
/// /robot2/odom, frame robot2/base_link. Frames: map -> odom -> base_footprint -> base_link ->
/// base_scan, map -> name of each person. Scans come from the sensors of a frame
/// (World::enableScans) or from a recording. Believed poses come from the sensors, otherwise they
/// are the true poses. Not thread-safe.
class RunTopics {
 public:
  using Send = std::function<void(std::size_t topic, std::string bytes)>;  // CDR
  using Filter = std::function<bool(std::size_t topic)>;

  explicit RunTopics(sim2d::TraceHeader header, RunTopicsOptions options = {});

  /// All possible topics. The list does not change.
  const std::vector<Topic>& topics() const { return topics_; }
  /// Call after a source spawned an agent, with the new header (World::header, Recording::header).
  void setHeader(sim2d::TraceHeader header);

  /// Publishes a frame in a fixed order of topics. Messages for which `filter` returns false are
  /// not created; without `filter` all are. The first frame also publishes the latched topics.
  void publish(const sim2d::Frame& frame, const Send& send, const Filter& filter = {});
  /// Sends the scans again with the next frame.
  void resendScans();
  /// Call for each frame of the run, published or not, before `publish`: tracks the goals that
  /// robots receive and reach.
  void track(const sim2d::Frame& frame);
  /// The same for single inputs and events, in the order of track(frame): inputs first.
  void track(const sim2d::Input& input);
  void track(const sim2d::Event& event);
  /// Whether the robot's current or last goal is external.
  bool hasExternalGoal(std::size_t robot) const { return robots_[robot].hasExternalGoal; }
  /// The robot's goal in the last published frame; null: none.
  const sim2d::TraceGoal* goalOf(std::size_t robot) const { return robots_[robot].goal; }
  /// The last message of a latched topic; empty: none yet.
  const std::string& latched(std::size_t topic) const { return latched_[topic]; }

 private:
  enum CommonTopic {
    Clock,
    Tf,
    TfStatic,
    Map,
    Obstacles,
    Markers,
    HumanStates,
    People,
    CommonTopicCount
  };
  enum RobotTopic { RobotStates, Odometry, Scan, Plan, GoalPose, RobotTopicCount };
  struct Robot {
    std::string prefix;             // topic prefix: "" or "/robot2"
    std::string frames;             // frame prefix: "" or "robot2/"
    std::optional<double> scanned;  // [s], time of the last published scan
    std::size_t passed = 0;         // number of goals reached
    bool hasExternalGoal = false;   // external goal: the goals of the header are dropped
    std::optional<sim2d::TraceGoal> externalGoal;  // the external goal, until reached
    const sim2d::TraceGoal* goal = nullptr;        // of the header or the external one
  };
  struct PublishContext;
  void addTopics();
  std::size_t topicOf(std::size_t robot, RobotTopic what) const {
    return CommonTopicCount + robot * RobotTopicCount + what;
  }
  void publishSurroundings(const PublishContext& context);
  void setTransforms(const sim2d::Frame& frame, tf2_msgs::TFMessage& to) const;
  void publishStaticTransforms(const PublishContext& context);
  void publishPeople(const PublishContext& context);
  void publishRobot(const PublishContext& context, std::size_t robot);
  void publishNewScan(const PublishContext& context, std::size_t robot);
  void publishScan(const PublishContext& context, std::size_t robot,
                   const sim2d::RobotTelemetry::Scan& scan) const;
  void publishPlan(const PublishContext& context, std::size_t robot);
  /// `make(seconds)` creates the message. It is sent if it differs from the last one in more than
  /// its stamp.
  template <class Make>
  void latch(const PublishContext& context, std::size_t topic, const Make& make);
  struct RobotFrames {
    base::Pose2 inOdom;                    // pose of the robot
    std::optional<base::Pose2> mapToOdom;  // none: not published yet
  };
  static RobotFrames robotFramesOf(const sim2d::Frame& frame, std::size_t robot);
  static const sim2d::RobotTelemetry::Scan* scanIn(const sim2d::Frame& frame, std::size_t robot);
  std::optional<base::Pose2> mountOf(std::size_t robot) const;

  sim2d::TraceHeader header_;
  RunTopicsOptions options_;
  std::vector<Topic> topics_;
  std::vector<std::string> latched_;    // by topic, last message
  std::vector<std::string> unstamped_;  // latched_ with time stamp 0
  std::vector<std::size_t> lengths_;    // [bytes] of the last message, by topic
  // Messages whose size depends on the number of people, reused between frames.
  tf2_msgs::TFMessage transforms_;
  visualization_msgs::MarkerArray markers_;
  hunav_msgs::Agents agents_;
  people_msgs::People people_;
  std::vector<Robot> robots_;
  std::vector<char> doors_;  // as last published
};

/// Context for publishing one frame.
struct RunTopics::PublishContext {
  const sim2d::Frame& frame;
  const Send& send;
  const Filter& filter;
  std::vector<std::size_t>& lengths;  // [bytes], sizes of the last messages

  bool isWanted(std::size_t topic) const { return !filter || filter(topic); }
  template <class M>
  void sendEncoded(std::size_t topic, const M& message) const {
    std::string bytes = encode(message, lengths[topic]);
    lengths[topic] = bytes.size();
    send(topic, std::move(bytes));
  }
  template <class Make>
  void publish(std::size_t topic, const Make& make) const {
    if (isWanted(topic)) {
      sendEncoded(topic, make());
    }
  }
  /// Publishes a message that reuses the memory of the last one.
  template <class M, class Set>
  void publishReused(std::size_t topic, M& message, const Set& set) const {
    if (isWanted(topic)) {
      set(message);
      sendEncoded(topic, message);
    }
  }
};

}  // namespace bridge
