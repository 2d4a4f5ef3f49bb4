#pragma once

#include <functional>
#include <memory>

#include "app/bridge/nodes/Node.h"
#include "app/bridge/topics/RunTopics.h"
#include "sim2d/trace/Inputs.h"

namespace bridge {

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
class RunNode {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;

  static base::Result<std::unique_ptr<RunNode>> create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings,
                                                       ReportCallback report);
  virtual ~RunNode() = default;
  /// Publishes a state. Call for each state before the next step.
  virtual void publishState(const sim2d::Frame& frame) = 0;
  /// The newest command since the last call, as an input of the step; empty: no command. With
  /// lockstep it waits up to 2 s for a command sent after the state was published (a TwistStamped
  /// must carry its stamp), as long as commands arrive at all; a timeout is reported once. Before
  /// the first step it waits up to 3 s for a publisher of commands, then up to 20 s for the first
  /// command, and republishes the state meanwhile.
  virtual sim2d::StepInputs inputs(const sim2d::Frame& frame) = 0;
  /// Reports inputs that the world rejected (World::refused), each once.
  virtual void reportRejected(const base::Diagnostics& refused) = 0;
  virtual std::uint64_t commands() const = 0;  // number of commands received
};

}  // namespace bridge
