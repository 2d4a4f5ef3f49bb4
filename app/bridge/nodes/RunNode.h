#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/bridge/messages/geometry_msgs.h"
#include "app/bridge/nodes/Node.h"
#include "app/bridge/topics/RunTopics.h"
#include "sim2d/trace/Frame.h"

namespace bridge {

class GoalSender;

struct RunNodeSettings {
  DomainSettings domain;
  bool stampedCommands = false;       // /cmd_vel is TwistStamped, the default since Kilted
  bool lockstep = false;              // a step waits for the command that answers its state
  bool sendsGoals = false;            // sends the first robot's goals to Nav2's action
  std::function<bool()> wantsStop{};  // polled while waiting for the first command
};

/// A run as the ROS 2 node `hunavsim`. It publishes the topics of `RunTopics`. For its first robot
/// it subscribes to /cmd_vel, /initialpose (moves the robot there) and /goal_pose (the robot drives
/// there). Single-threaded: call from the thread of the run.
class RunNode : public NodeProgram {
 public:
  static base::Result<std::unique_ptr<RunNode>> create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings,
                                                       ReportCallback report);
  /// Publishes a state. Call for each state before the next step.
  void publishState(const sim2d::Frame& frame);
  /// The newest command since the last call, as an input of the step; empty: no command. With
  /// lockstep it waits up to 2 s for a command sent after the state was published (a TwistStamped
  /// must carry its stamp), as long as commands arrive at all; a timeout is reported once. Before
  /// the first step it waits up to 3 s for a publisher of commands, then up to 20 s for the first
  /// command, and republishes the state meanwhile.
  sim2d::StepInputs inputs(const sim2d::Frame& frame);
  /// Reports inputs that the world rejected (World::refused), each once.
  void reportRejected(const base::Diagnostics& refused);
  std::uint64_t commands() const { return commands_; }  // number of commands received

 private:
  RunNode(std::unique_ptr<Participant> participant, const sim2d::TraceHeader& header,
          const RunTopicsOptions& options, const RunNodeSettings& settings, ReportCallback report);
  base::Diagnostics start(bool hasRobot);
  void subscribeCommands();
  void readAll();
  void publish(const sim2d::Frame& frame);
  void updateGoal(const sim2d::Frame& frame);
  void waitForCommander(const sim2d::Frame& frame);
  void waitForCommand();
  void takeCommand(const geometry_msgs::Twist& twist);
  void takeStamped(const geometry_msgs::TwistStamped& command);
  void takePose(const char* topic, sim2d::InputKind kind, const std_msgs::Header& header,
                const geometry_msgs::Pose& pose);
  void warnOfMessage(const char* topic, const char* reason);

  RunNodeSettings settings_;
  RunTopics topics_;
  std::unique_ptr<Node> node_;
  std::vector<std::unique_ptr<Publisher>> publishers_;  // one per topic
  std::optional<geometry_msgs::Twist> command_;         // not passed to a step yet
  std::optional<sim2d::Input> moved_, ordered_;         // as command_
  std::uint64_t commands_ = 0;
  const Subscription* driver_ = nullptr;
  std::shared_ptr<GoalSender> goals_;
  std::int64_t publishedTime_ = 0;  // [ns], time of the last published state
  bool isDriven_ = false;           // commands are being received
  bool hasWaited_ = false;          // for the first command
};

}  // namespace bridge
