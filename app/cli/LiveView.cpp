#include "app/cli/LiveView.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "sim2d/base/Text.h"

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

void NoViewerCheck::update() {
  if (isOver_ || std::chrono::steady_clock::now() - begin_ < kNoViewerAfter) {
    return;
  }
  isOver_ = true;
  const auto seconds = kNoViewerAfter.count();
  if (live_ != nullptr && !live_->hadClient()) {
    const std::string& address = options_.address;
    printDiagnostics(
        {isOfThisMachine(address)
             ? base::warning("live.no-client-here", {live_->port(), seconds})
             : base::warning("live.no-client", {urlOf(address, live_->port()), seconds})});
  }
  if (groot_ != nullptr && !groot_->hadClient()) {
    const int port = groot_->port();
    printDiagnostics({base::warning("groot.no-client", {port, seconds, port + 1})});
  }
}

}  // namespace app
