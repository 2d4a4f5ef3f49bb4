#include "app/cli/RunObservers.h"

#include <filesystem>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/bridge/live/FoxglovePublisher.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/Ros2Options.h"

#ifdef HUNAV_ROS2
#include "app/bridge/nodes/RunNode.h"
#endif

namespace app {

namespace {

void reportAny(const RunObservers& guests, const base::Diagnostics& diagnostics) {
  if (!diagnostics.empty()) {
    guests.report(diagnostics);
  }
}

std::optional<Session::Observer> liveView(const RunObservers& guests, Session& session,
                                          sim2d::World& world, const Bundle& bundle) {
  const base::Result<MetricsSetup> metrics = metricsSetupOf(*bundle.scenario, bundle.path);
  reportAny(guests, metrics.diagnostics());
  if (!metrics) {
    return std::nullopt;
  }
  live::FoxglovePublisherSettings settings;
  settings.port = *guests.foxglove;
  settings.canDrive = false;  // the window provides keys for that
  settings.warn = [report = guests.report](const base::Diagnostic& warning) { report({warning}); };
  const std::string name = std::filesystem::path(bundle.path).stem().string();
  auto opened =
      live::FoxglovePublisher::open(settings, session, world, *bundle.scenario, name, *metrics);
  if (!opened) {
    settings.port = 0;
    opened =
        live::FoxglovePublisher::open(settings, session, world, *bundle.scenario, name, *metrics);
  }
  reportAny(guests, opened.diagnostics());
  if (!opened) {
    return std::nullopt;
  }
  const std::shared_ptr<live::FoxglovePublisher> run = *std::move(opened);
  guests.liveViewOpened("ws://localhost:" + std::to_string(run->port()));
  return Session::Observer{[run](const sim2d::Frame& frame) { run->show(frame); }, {}};
}

#ifdef HUNAV_ROS2
using Report = std::function<void(const base::Diagnostic&)>;

/// The node of a run, whose robots then scan.
base::Result<std::unique_ptr<bridge::RunNode>> createNode(const RunOnRos2Options& options,
                                                          const sim2d::Scenario& scenario,
                                                          sim2d::World& world,
                                                          const std::function<bool()>& wantsStop,
                                                          const Report& report) {
  const base::Result<bridge::DomainSettings> domain = domainSettingsOf(options.ros2);
  if (!domain) {
    return domain.diagnostics();
  }
  auto node = bridge::RunNode::create(
      world.header(), bridge::lidarsOf(scenario),
      {*domain, options.stamped, options.lockstep, options.sendsGoals, wantsStop}, report);
  if (node) {
    world.enableScans(true);
  }
  return node;
}

std::optional<Session::Observer> topics(const RunObservers& guests, sim2d::World& world,
                                        const Bundle& bundle) {
  auto made = createNode(
      {}, *bundle.scenario, world, {},
      [report = guests.report](const base::Diagnostic& diagnostics) { report({diagnostics}); });
  reportAny(guests, made.diagnostics());
  if (!made) {
    return std::nullopt;
  }
  const std::shared_ptr<bridge::RunNode> node = *std::move(made);
  return Session::Observer{[node](const sim2d::Frame& frame) { node->publishState(frame); },
                           [node](const sim2d::Frame& frame) { return node->inputs(frame); }};
}
#endif

}  // namespace

bool hasRos2Support() {
#ifdef HUNAV_ROS2
  return true;
#else
  return false;
#endif
}

std::vector<Session::Observer> attachObservers(const RunObservers& guests, Session& session,
                                               sim2d::World& world,
                                               const std::shared_ptr<const Bundle>& bundle) {
  std::vector<Session::Observer> there;
  const auto add = [&there](std::optional<Session::Observer> guest) {
    if (guest) {
      there.push_back(*std::move(guest));
    }
  };
  if (bundle != nullptr && guests.foxglove) {
    add(liveView(guests, session, world, *bundle));
  }
#ifdef HUNAV_ROS2
  if (bundle != nullptr && guests.ros2) {
    add(topics(guests, world, *bundle));
  }
#endif
  return there;
}

void addRunOnRos2Options(CLI::App& command, RunOnRos2Options& options) {
  addRos2Options(command, options.ros2,
                 "Publish the run on ROS 2 topics in real time; /cmd_vel drives the first robot");
  CLI::Option* const ros2 = command.get_option("--ros2");
  const auto flag = [&](const char* name, bool& given, const char* help) {
    command.add_flag(name, given, help)->needs(ros2);
  };
  flag("--ros2-send-goals", options.sendsGoals,
       "With --ros2: send the goals of the first robot to Nav2 (action navigate_to_pose)");
  flag("--lockstep", options.lockstep,
       "With --ros2: wait after each step for the next /cmd_vel, at most 2 s");
  flag("--stamped", options.stamped,
       "With --ros2: /cmd_vel has type TwistStamped, as in Kilted and later");
}

#ifdef HUNAV_ROS2
namespace {

class Ros2RunPublisher final : public RunOnRos2 {
 public:
  Ros2RunPublisher(std::unique_ptr<bridge::RunNode> node, const sim2d::World& world)
      : node_(std::move(node)), world_(world) {}
  void publishState(const sim2d::Frame& frame) override {
    node_->reportRejected(world_.refused());
    node_->publishState(frame);
  }

 private:
  std::unique_ptr<bridge::RunNode> node_;
  const sim2d::World& world_;
};

}  // namespace

std::unique_ptr<RunOnRos2> RunOnRos2::open(const RunOnRos2Options& options,
                                           const sim2d::Scenario& scenario, sim2d::World& world,
                                           Session& session) {
  if (!options.ros2.ros2) {
    return nullptr;
  }
  auto node =
      createNode(options, scenario, world, wasInterrupted,
                 [](const base::Diagnostic& diagnostic) { printDiagnostics({diagnostic}); });
  requireFine(node.diagnostics());
  session.setSpeed(1.0);
  session.steer([&to = **node](const sim2d::Frame& frame) { return to.inputs(frame); });
  return std::make_unique<Ros2RunPublisher>(*std::move(node), world);
}
#else
std::unique_ptr<RunOnRos2> RunOnRos2::open(const RunOnRos2Options& options,
                                           const sim2d::Scenario& /*scenario*/,
                                           sim2d::World& /*world*/, Session& /*session*/) {
  if (options.ros2.ros2) {
    requireFine(domainSettingsOf(options.ros2).diagnostics());
  }
  return nullptr;
}
#endif

}  // namespace app
