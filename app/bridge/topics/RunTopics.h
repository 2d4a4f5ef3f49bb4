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

#include "app/bridge/messages/GeometryMessages.h"
#include "app/bridge/messages/HunavMessages.h"
#include "app/bridge/messages/MarkerMessages.h"
#include "sim2d/base/Types.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
struct Scenario;
}  // namespace sim2d

namespace bridge {

struct Topic {
  std::string name;        // "/human_states"
  std::string_view type;   // a name of the table of types: "hunav_msgs/msg/Agents"
  bool isLatched = false;  // told when it changes; who comes later is told the last again
  int depth = 10;
};

struct RunTopicsOptions {
  bool clock = true;  // /clock; a bag has none, its player makes it
  /// Where the lidars of the robots sit in the robots' frames, none: unknown (`lidarMountsOf`).
  std::vector<std::optional<base::Pose2>> lidarMounts;
  std::vector<double> lidarRates;  // [Hz] beside them; missing: 10
};

/// Mounts and rates of the lidars of a scenario, in the order of a frame's robots.
RunTopicsOptions lidarsOf(const sim2d::Scenario& scenario);

/// A run told on topics, frame by frame, as DDS, MCAP and the live view carry it:
///
///   /clock  /tf  /tf_static  /map  /obstacles  /markers  /human_states  /people
/// and of each robot  /robot_states  /odom  /scan  /plan  /goal_pose
///
/// The second robot and further ones have their names in front: /robot2/odom, frame
/// robot2/base_link. Frames: map -> odom -> base_footprint -> base_link -> base_scan, map -> name
/// of each person. Scans come from the senses of a frame (World::tellScans) or from recorded ones;
/// what robots believe comes from the senses, else it is the truth. One thread at a time.
class RunTopics {
 public:
  using Send = std::function<void(std::size_t topic, std::string bytes)>;  // CDR
  using Wants = std::function<bool(std::size_t topic)>;

  explicit RunTopics(sim2d::TraceHeader header, RunTopicsOptions options = {});

  /// All that there may be, from the beginning; they stay as they are.
  const std::vector<Topic>& topics() const { return topics_; }
  /// Somebody came from a source: the newest header (World::header, Recording::header).
  void setHeader(sim2d::TraceHeader header);

  /// Sends what the frame tells, in a fixed order of topics. What `wants` denies is not made;
  /// empty: all is wanted. The first frame brings what is latched too.
  void tell(const sim2d::Frame& frame, const Send& send, const Wants& wants = {});
  /// Scans are sent again with the next frame.
  void repeatScans();
  /// Each frame of the run, told or not, before it is told: robots get goals and pass them.
  void note(const sim2d::Frame& frame);
  /// One by one: those of a step by the order of note(frame), inputs first.
  void note(const sim2d::Input& input);
  void note(const sim2d::Event& event);
  /// It drives, or has driven, to a place that came from outside.
  bool isOrdered(std::size_t robot) const { return robots_[robot].isOrdered; }
  /// Where the robot drives to in the frame that was told last; null: nowhere.
  const sim2d::TraceGoal* goalOf(std::size_t robot) const { return robots_[robot].goal; }
  /// What this latched topic says now; empty: nothing so far.
  const std::string& latched(std::size_t topic) const { return latched_[topic]; }

 private:
  enum Common { Clock, Tf, TfStatic, Map, Obstacles, Markers, HumanStates, People, CommonCount };
  enum OfRobot { RobotStates, Odometry, Scan, Plan, GoalPose, OfRobotCount };
  struct Robot {
    std::string prefix;                      // of topics: "" or "/robot2"
    std::string frames;                      // of frames: "" or "robot2/"
    std::optional<double> scanned;           // [s], time of the last scan that was told
    std::size_t passed = 0;                  // goals so far
    bool isOrdered = false;                  // from outside: it has given up those of the header
    std::optional<sim2d::TraceGoal> order;   // until it arrives
    const sim2d::TraceGoal* goal = nullptr;  // of the header, or the order
  };
  struct Telling;
  /// Messages of the last state that grow with its people.
  struct OfPeople {
    tf2_msgs::TFMessage transforms;
    visualization_msgs::MarkerArray markers;
    hunav_msgs::Agents agents;
    people_msgs::People people;
  };

  void addTopics();
  std::size_t topicOf(std::size_t robot, OfRobot what) const {
    return CommonCount + robot * OfRobotCount + what;
  }
  void tellSurroundings(const Telling& telling);
  void tellTransforms(const Telling& telling);
  void setTransforms(const sim2d::Frame& frame, tf2_msgs::TFMessage& to) const;
  void tellFixedTransforms(const Telling& telling);
  void tellPeople(const Telling& telling);
  void tellRobot(const Telling& telling, std::size_t robot);
  void tellNewScan(const Telling& telling, std::size_t robot);
  void tellScan(const Telling& telling, std::size_t robot,
                const sim2d::RobotSenses::Scan& scan) const;
  void tellWay(const Telling& telling, std::size_t robot);
  /// `make(seconds)` makes the message; it is sent when it differs from the last but for its stamp.
  template <class Make>
  void latch(const Telling& telling, std::size_t topic, const Make& make);
  struct Placed {
    base::Pose2 inOdom;                    // the robot
    std::optional<base::Pose2> mapToOdom;  // none: not published yet
  };
  static Placed placedBy(const sim2d::Frame& frame, std::size_t robot);
  static const sim2d::RobotSenses::Scan* scanIn(const sim2d::Frame& frame, std::size_t robot);
  std::optional<base::Pose2> mountOf(std::size_t robot) const;

  sim2d::TraceHeader header_;
  RunTopicsOptions options_;
  std::vector<Topic> topics_;
  std::vector<std::string> latched_;    // by topic
  std::vector<std::string> unstamped_;  // the same at the time 0
  std::vector<std::size_t> lengths_;    // of the last message, by topic
  OfPeople ofPeople_;                   // its memory is used again
  std::vector<Robot> robots_;
  std::vector<char> doors_;  // as they were told
};

}  // namespace bridge
