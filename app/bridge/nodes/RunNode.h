#pragma once

#include <functional>
#include <memory>

#include "app/bridge/nodes/Node.h"
#include "app/bridge/topics/RunTopics.h"
#include "sim2d/trace/Inputs.h"

namespace bridge {

struct RunNodeSettings {
  DomainSettings domain;
  bool stampedCommands = false;       // /cmd_vel is TwistStamped: the default from Kilted on
  bool lockstep = false;              // a step waits for the command that follows on its state
  bool sendsGoals = false;            // of the first robot, to Nav2's action
  std::function<bool()> wantsStop{};  // asked while it waits for the first command
};

/// A run as the node `hunavsim`: it publishes what `RunTopics` tells, and for its first robot takes
/// /cmd_vel, /initialpose (it is put there) and /goal_pose (it drives there). One thread: the one
/// that runs.
class RunNode {
 public:
  using Tell = std::function<void(const base::Diagnostic&)>;

  static base::Result<std::unique_ptr<RunNode>> create(const sim2d::TraceHeader& header,
                                                       const RunTopicsOptions& options,
                                                       const RunNodeSettings& settings, Tell tell);
  virtual ~RunNode() = default;
  /// Each state, before the next step.
  virtual void tell(const sim2d::Frame& frame) = 0;
  /// Then: the newest command since the last call, as an input of the step; none: no input. With
  /// lockstep it waits for one that was sent after the state was told (TwistStamped: that has its
  /// stamp), 2 s at most, while commands come at all; what is late is told once. Before the first
  /// step it waits until somebody who drives has been met (3 s at most), then for the first command
  /// (20 s), and tells the state again and again.
  virtual sim2d::StepInputs inputs(const sim2d::Frame& frame) = 0;
  /// Inputs that the world did not take (World::refused), each once.
  virtual void tellRefused(const base::Diagnostics& refused) = 0;
  virtual std::uint64_t commands() const = 0;  // so far
};

}  // namespace bridge
