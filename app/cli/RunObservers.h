#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/groot/GrootPublisher.h"
#include "app/bridge/live/FoxglovePublisher.h"
#include "app/cli/CommandRegistry.h"
#include "app/run/Bundle.h"
#include "app/run/Session.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// Options of the pace of a run and of the programs that may watch it.
struct LiveOptions {
  std::string speed;        // simulated seconds per second, or "max"; empty: the usual one
  std::optional<int> port;  // of the live view; none: there is none; 0: any free port
  std::string address = "127.0.0.1";
  std::vector<std::string> origins;  // further web pages that may connect
  std::optional<int> grootPort;      // none: Groot2 cannot connect; 0: any free port
  std::string grootPerson;           // whose tree Groot2 shows; empty: the first person's
};
/// --speed, --foxglove, --groot2 and the options that need them.
void addLiveOptions(CLI::App& command, LiveOptions& options);

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

/// A world that a session is about to run; both must outlive its outputs.
struct RunInProgress {
  Session& session;
  sim2d::World& world;
};

using ShowFrame = std::function<void(const sim2d::Frame&)>;

/// The live outputs of the command `run`. Inputs received from them are recorded with their steps.
struct RunOutputs {
  std::vector<ShowFrame> show;  // to be called with each state, in this order
  std::function<void(const sim2d::Frame& last, const std::string& reason)> finish;  // may be null
};
/// Sets the pace of the session and opens what the options request: ROS 2 topics, of which /cmd_vel
/// drives the first robot, the live view and Groot2. Messages go to standard error. Throws
/// CommandEnd on errors.
RunOutputs openRunOutputs(const LiveOptions& live, const RunOnRos2Options& ros2,
                          const Bundle& bundle, const MetricsSetup& metrics, bool isReplay,
                          const RunInProgress& run);

}  // namespace app
