#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/Ros2Options.h"
#include "app/run/Bundle.h"
#include "app/run/Session.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// Live outputs of a run of the window.
struct RunObservers {
  /// Port of the live view, local connections only; another port if it is in use.
  std::optional<std::uint16_t> foxglove;
  bool ros2 = false;  // topics and /cmd_vel; domain from environment variables
  // Called in the run thread or that of the live view.
  std::function<void(const std::string& url)> liveViewOpened;        // the live view is available
  std::function<void(const base::Diagnostics& diagnostics)> report;  // errors of opening, warnings
};

/// Whether this build has ROS 2 support.
bool hasRos2Support();

/// Attaches the outputs that can be opened; run thread. Results do not change, except by inputs
/// from ROS 2, which are recorded with their step.
std::vector<Session::Observer> attachObservers(const RunObservers& guests, Session& session,
                                               sim2d::World& world,
                                               const std::shared_ptr<const Bundle>& bundle);

/// Options of `run` that require --ros2.
struct RunOnRos2Options {
  Ros2Options ros2;
  bool lockstep = false, stamped = false, sendsGoals = false;
};
void addRunOnRos2Options(CLI::App& command, RunOnRos2Options& options);

/// Publishes a run on ROS 2 topics in real time and drives its first robot by /cmd_vel. Received
/// inputs are recorded with their steps.
class RunOnRos2 {
 public:
  /// Null if not requested. Throws CommandEnd on errors. World and session must outlive it.
  static std::unique_ptr<RunOnRos2> open(const RunOnRos2Options& options,
                                         const sim2d::Scenario& scenario, sim2d::World& world,
                                         Session& session);
  virtual ~RunOnRos2() = default;
  virtual void publishState(const sim2d::Frame& frame) = 0;
};

}  // namespace app
