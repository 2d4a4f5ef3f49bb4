#include "app/cli/LiveWords.h"

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
                : "'" + word + "' is neither a number from " + base::formatDouble(live::kSlowest) +
                      " to " + base::formatDouble(live::kFastest) + " nor max";
}

std::string wrongPort(const std::string& word) {
  const std::optional<long long> port = base::parseInt(word);
  return port && *port >= 0 && *port <= kMostPort ? std::string()
                                                  : "'" + word + "' is no port (0 to 65535)";
}

bool isOfThisMachine(const std::string& address) {
  return address.rfind("127.", 0) == 0 || address == "::1";
}

std::string urlOf(const std::string& address, std::uint16_t port) {
  const bool isVersion6 = address.find(':') != std::string::npos;
  return "ws://" + (isVersion6 ? "[" + address + "]" : address) + ":" + std::to_string(port);
}

bool isShown(const RunOptions& options) {
  return options.live.port || options.groot.port;
}

/// As fast as it goes, unless somebody watches.
double speedOf(const RunOptions& options) {
  if (options.speed.empty()) {
    return isShown(options) ? 1.0 : std::numeric_limits<double>::infinity();
  }
  return options.speed == kAtMost ? std::numeric_limits<double>::infinity()
                                  : base::parseDouble(options.speed).value_or(1.0);
}

}  // namespace

void addLiveWords(CLI::App& command, RunOptions& options) {
  command
      .add_option(
          "--speed", options.speed,
          "Simulated seconds per second, or max; 1 with --foxglove, --groot2 or --ros2, else max")
      ->check(wrongSpeed);
  CLI::Option* const port =
      command
          .add_option("--foxglove", options.live.port,
                      "Port where Foxglove and PlotJuggler can watch the run; 0 = a free one")
          ->check(wrongPort);
  command
      .add_option("--foxglove-address", options.live.address,
                  "Where it listens; other machines reach this one only if told so")
      ->needs(port);
  command
      .add_option("--foxglove-origin", options.live.origins,
                  "Origin of a web page that may connect too (https://…)")
      ->allow_extra_args(false)
      ->needs(port);
  CLI::Option* const groot =
      command
          .add_option(
              "--groot2", options.groot.port,
              "Port where Groot2 can watch a tree (it looks at 1667), and the one behind it")
          ->check(wrongPort);
  command
      .add_option("--groot2-of", options.groot.person, "Whose tree; else that of the first person")
      ->needs(groot);
}

std::unique_ptr<live::LiveRun> openLive(const RunOptions& options, const Bundle& bundle,
                                        const MetricsSetup& metrics, bool canDrive,
                                        Session& session, sim2d::World& world) {
  if (!options.speed.empty() || isShown(options)) {  // else it stays as it is
    session.setSpeed(speedOf(options));
  }
  if (!options.live.port) {
    return nullptr;
  }
  live::LiveRunSettings settings;
  settings.address = options.live.address;
  settings.port = static_cast<std::uint16_t>(*options.live.port);
  settings.origins = options.live.origins;
  settings.canDrive = canDrive && options.from.empty();  // what is repeated is not to be disturbed
  settings.wantsStop = [] { return wasInterrupted(); };
  settings.warn = [](const base::Diagnostic& warning) { printDiagnostics({warning}); };
  auto opened = live::LiveRun::open(settings, session, world, *bundle.scenario,
                                    std::filesystem::path(bundle.path).stem().string(), metrics);
  requireFine(opened.diagnostics());
  if (!isOfThisMachine(settings.address)) {
    printDiagnostics({base::warning("live.not-local", {settings.address})});
  }
  printError("live view at " + urlOf(settings.address, (*opened)->port()) +
             " (Foxglove: Open connection, Foxglove WebSocket)");
  return *std::move(opened);
}

std::unique_ptr<groot::GrootRun> openGroot(const RunOptions& options, const Bundle& bundle,
                                           sim2d::World& world) {
  if (!options.groot.port) {
    return nullptr;
  }
  const std::vector<sim2d::Human>& people = bundle.scenario->humans;
  const std::string& wanted = options.groot.person;
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
  auto opened = groot::GrootRun::open(static_cast<std::uint16_t>(*options.groot.port), world,
                                      world.view().indexOf(person->id), *tree);
  requireFine(opened.diagnostics());
  printError("tree of " + person->name + " at 127.0.0.1:" + std::to_string((*opened)->port()) +
             " (Groot2: Monitor, Connect)");
  return *std::move(opened);
}

void NoViewerCheck::look() {
  if (isOver_ || std::chrono::steady_clock::now() - begin_ < kNoViewerAfter) {
    return;
  }
  isOver_ = true;
  const auto seconds = kNoViewerAfter.count();
  if (live_ != nullptr && !live_->wasWatched()) {
    const std::string& address = options_.live.address;
    printDiagnostics(
        {isOfThisMachine(address)
             ? base::warning("live.no-client-here", {live_->port(), seconds})
             : base::warning("live.no-client", {urlOf(address, live_->port()), seconds})});
  }
  if (groot_ != nullptr && !groot_->wasWatched()) {
    const int port = groot_->port();
    printDiagnostics({base::warning("groot.no-client", {port, seconds, port + 1})});
  }
}

}  // namespace app
