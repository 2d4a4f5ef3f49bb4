#include "app/cli/RunObservers.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/bridge/live/FoxglovePublisher.h"
#include "app/bridge/nodes/RunNode.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "sim2d/base/Text.h"

#ifdef HUNAV_ROS2
#endif

namespace app {

namespace {

constexpr const char* kAtMost = "max";
constexpr int kMostPort = 65535;
constexpr std::chrono::seconds kNoViewerAfter(5);

std::string wrongSpeed(const std::string& word) {
  const std::optional<double> speed = base::parseDouble(word);
  const bool isFine =
      word == kAtMost || (speed && *speed >= live::kSlowest && *speed <= live::kFastest);
  return isFine ? std::string()
                : "'" + word + "' is not a number from " + base::formatDouble(live::kSlowest) +
                      " to " + base::formatDouble(live::kFastest) + " or max";
}

std::string wrongPort(const std::string& word) {
  const std::optional<long long> port = base::parseInt(word);
  return port && *port >= 0 && *port <= kMostPort ? std::string()
                                                  : "'" + word + "' is not a port (0 to 65535)";
}

bool isOfThisMachine(const std::string& address) {
  return address.rfind("127.", 0) == 0 || address == "::1";
}

std::string urlOf(const std::string& address, std::uint16_t port) {
  const bool isVersion6 = address.find(':') != std::string::npos;
  return "ws://" + (isVersion6 ? "[" + address + "]" : address) + ":" + std::to_string(port);
}

bool isShown(const LiveOptions& options) {
  return options.port || options.grootPort;
}

/// As fast as possible, unless a program may watch.
double speedOf(const LiveOptions& options) {
  if (options.speed.empty()) {
    return isShown(options) ? 1.0 : std::numeric_limits<double>::infinity();
  }
  return options.speed == kAtMost ? std::numeric_limits<double>::infinity()
                                  : base::parseDouble(options.speed).value_or(1.0);
}

}  // namespace

void addLiveOptions(CLI::App& command, LiveOptions& options) {
  command
      .add_option(
          "--speed", options.speed,
          "Speed as a multiple of real time, or max (default: 1 with --foxglove, --groot2 or "
          "--ros2, otherwise max)")
      ->check(wrongSpeed);
  CLI::Option* const port =
      command
          .add_option("--foxglove", options.port,
                      "Publish the run to Foxglove and PlotJuggler on this port; 0 = any free port")
          ->check(wrongPort);
  command
      .add_option("--foxglove-address", options.address,
                  "Address to listen on (default: 127.0.0.1, accessible from this machine only)")
      ->needs(port);
  command
      .add_option("--foxglove-origin", options.origins,
                  "Origin of an additional web page that is allowed to connect (https://…)")
      ->allow_extra_args(false)
      ->needs(port);
  CLI::Option* const groot =
      command
          .add_option(
              "--groot2", options.grootPort,
              "Publish a behaviour tree to Groot2 on this port and the next one (default in "
              "Groot2: 1667)")
          ->check(wrongPort);
  command
      .add_option("--groot2-of", options.grootPerson,
                  "Agent whose tree is published (default: the first)")
      ->needs(groot);
}

namespace {

/// Sets the pace of the session and opens the live view if it is requested. Ends the command when
/// the port is not available.
std::unique_ptr<live::FoxglovePublisher> openLive(const LiveOptions& options, const Bundle& bundle,
                                                  const MetricsSetup& metrics, bool canDrive,
                                                  Session& session, sim2d::World& world) {
  if (!options.speed.empty() || isShown(options)) {  // else it stays as it is
    session.setSpeed(speedOf(options));
  }
  if (!options.port) {
    return nullptr;
  }
  live::FoxglovePublisherSettings settings;
  settings.address = options.address;
  settings.port = static_cast<std::uint16_t>(*options.port);
  settings.origins = options.origins;
  settings.canDrive = canDrive;
  settings.wantsStop = [] { return wasInterrupted(); };
  settings.warn = [](const base::Diagnostic& warning) { printDiagnostics({warning}); };
  auto opened =
      live::FoxglovePublisher::open(settings, session, world, *bundle.scenario,
                                    std::filesystem::path(bundle.path).stem().string(), metrics);
  requireFine(opened.diagnostics());
  if (!isOfThisMachine(settings.address)) {
    printDiagnostics({base::warning("live.not-local", {settings.address})});
  }
  printError("live view at " + urlOf(settings.address, (*opened)->port()) +
             " (Foxglove: Open connection, Foxglove WebSocket)");
  return *std::move(opened);
}

/// The same for Groot2. Also ends the command when no agent has that name, or the agent has no
/// tree.
std::unique_ptr<groot::GrootPublisher> openGroot(const LiveOptions& options, const Bundle& bundle,
                                                 sim2d::World& world) {
  if (!options.grootPort) {
    return nullptr;
  }
  const std::vector<sim2d::Human>& people = bundle.scenario->humans;
  const std::string& wanted = options.grootPerson;
  const auto person = std::find_if(people.begin(), people.end(), [&](const sim2d::Human& human) {
    return human.listed && (wanted.empty() || human.name == wanted);
  });
  if (person == people.end()) {
    std::vector<std::string> names;
    names.reserve(people.size());
    for (const sim2d::Human& human : people) {
      names.push_back(human.name);
    }
    requireFine({base::error("groot.no-person", {wanted, base::nearestName(wanted, names)})});
  }
  const auto tree =
      bt::treeOf(*person, bundle.trees, *bundle.scenario, bundle.settings.compatibility);
  requireFine(errorsOf(tree.diagnostics()));
  auto opened = groot::GrootPublisher::open(static_cast<std::uint16_t>(*options.grootPort), world,
                                            world.view().indexOf(person->id), *tree);
  requireFine(opened.diagnostics());
  printError("tree of " + person->name + " at 127.0.0.1:" + std::to_string((*opened)->port()) +
             " (Groot2: Monitor, Connect)");
  return *std::move(opened);
}

/// Warns once, after the first seconds, of each port that no client has connected to.
ShowFrame noViewerCheck(const std::string& address,
                        const std::shared_ptr<live::FoxglovePublisher>& live,
                        const std::shared_ptr<groot::GrootPublisher>& groot) {
  return [=, begin = std::chrono::steady_clock::now(),
          isOver = false](const sim2d::Frame& /*frame*/) mutable {
    if (isOver || std::chrono::steady_clock::now() - begin < kNoViewerAfter) {
      return;
    }
    isOver = true;
    const auto seconds = kNoViewerAfter.count();
    if (live != nullptr && !live->hadClient()) {
      printDiagnostics(
          {isOfThisMachine(address)
               ? base::warning("live.no-client-here", {live->port(), seconds})
               : base::warning("live.no-client", {urlOf(address, live->port()), seconds})});
    }
    if (groot != nullptr && !groot->hadClient()) {
      const int port = groot->port();
      printDiagnostics({base::warning("groot.no-client", {port, seconds, port + 1})});
    }
  };
}

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

namespace {

/// Drives the first robot by /cmd_vel and returns the function that publishes a state.
ShowFrame publishOnRos2(const RunOnRos2Options& options,
                        [[maybe_unused]] const sim2d::Scenario& scenario,
                        [[maybe_unused]] sim2d::World& world, [[maybe_unused]] Session& session) {
#ifdef HUNAV_ROS2
  auto node =
      createNode(options, scenario, world, wasInterrupted,
                 [](const base::Diagnostic& diagnostic) { printDiagnostics({diagnostic}); });
  requireFine(node.diagnostics());
  session.setSpeed(1.0);
  session.steer([&to = **node](const sim2d::Frame& frame) { return to.inputs(frame); });
  const std::shared_ptr<bridge::RunNode> run = *std::move(node);
  return [run, &world](const sim2d::Frame& frame) {
    run->reportRejected(world.refused());
    run->publishState(frame);
  };
#else
  requireFine(domainSettingsOf(options.ros2).diagnostics());
  return {};
#endif
}

}  // namespace

RunOutputs openRunOutputs(const LiveOptions& liveOptions, const RunOnRos2Options& ros2,
                          const Bundle& bundle, const MetricsSetup& metrics, bool isReplay,
                          const RunInProgress& run) {
  RunOutputs outputs;
  if (ros2.ros2.ros2) {
    outputs.show.push_back(publishOnRos2(ros2, *bundle.scenario, run.world, run.session));
  }
  const std::shared_ptr<live::FoxglovePublisher> live =
      openLive(liveOptions, bundle, metrics, !ros2.ros2.ros2 && !isReplay, run.session, run.world);
  const std::shared_ptr<groot::GrootPublisher> groot = openGroot(liveOptions, bundle, run.world);
  if (live != nullptr) {
    outputs.show.emplace_back([live](const sim2d::Frame& frame) { live->show(frame); });
    outputs.finish = [live](const sim2d::Frame& last, const std::string& reason) {
      live->finish(last, "the run has ended: " + reason);
    };
  }
  if (groot != nullptr) {
    outputs.show.emplace_back([groot](const sim2d::Frame& frame) { groot->show(frame); });
  }
  outputs.show.push_back(noViewerCheck(liveOptions.address, live, groot));
  return outputs;
}

}  // namespace app
