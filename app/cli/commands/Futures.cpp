#include "app/run/Futures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Batch.h"
#include "app/run/RunReplay.h"
#include "app/run/Session.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct FuturesCommandOptions {
  std::string moment;  // RUN@SECONDS, or "-": a request on the standard input
  FuturesOptions futures;
  std::vector<std::string> set;
  std::string planner;
};

constexpr const char* kStandardInputRequest = "-";

base::Diagnostics checkFuturesOptions(const FuturesCommandOptions& options) {
  base::Diagnostics wrong;
  const FuturesOptions& futures = options.futures;
  if (futures.count < 1 || futures.count > kMaxFutures) {
    wrong.push_back(base::error("futures.count", {kMaxFutures, futures.count}));
  }
  if (!(futures.horizon >= 0.1 && futures.horizon <= kLongestFuture)) {
    wrong.push_back(base::error("futures.horizon", {kLongestFuture, futures.horizon}));
  }
  if (!(futures.spread >= 0.0 && futures.spread <= 1.0)) {
    wrong.push_back(base::error("futures.spread", {futures.spread}));
  }
  if (!runMomentOf(options.moment)) {
    wrong.push_back(base::error("again.no-moment", {options.moment}));
  }
  return wrong;
}

/// Handles a request of the window: prints a line per future as it ends.
int serveFuturesRequest() {
  catchInterrupts();
  constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;  // of a request
  std::string bytes;
  std::array<char, 65536> part;
  while (bytes.size() <= kMaxBytes &&
         (std::cin.read(part.data(), part.size()), std::cin.gcount()) > 0) {
    bytes.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
  }
  if (bytes.size() > kMaxBytes) {
    bytes.clear();  // no request is so long
  }
  const base::Result<FuturesRequest> request = decodeFuturesRequest(bytes);
  requireFine(request.diagnostics());
  const auto onFuture = [](const Future& future) {
    printLine(futureText(future));
    std::cout.flush();
  };
  requireFine(runFuturesRequest(*request, onFuture, wasInterrupted));
  return wasInterrupted() ? ExitRunFailed : ExitFine;
}

std::vector<Future> futuresOf(RunReplay& replay, std::int64_t at,
                              const FuturesCommandOptions& options, const Invocation& given) {
  std::vector<Future> futures;
  base::Diagnostics problems;
  Progress progress(given.quiet);
  Session session({at + 1, false});
  sim2d::World& world = *replay.verdict().world;
  const auto onFuture = [&](const Future& future) {
    futures.push_back(future);
    progress.show(std::to_string(futures.size()) + " / " + std::to_string(options.futures.count) +
                  " futures");
  };
  bool isThere = false;
  const sim2d::RunResult result = session.run(world, nullptr, [&](const sim2d::Frame& frame) {
    replay.observe(frame, world, session);
    if (wasInterrupted()) {
      session.stop();
    } else if (frame.step == at) {
      isThere = true;
      problems = simulateFutures(world, replay.bundle(), options.futures, onFuture, wasInterrupted);
      session.stop();
    }
  });
  base::Diagnostics trouble = isThere ? base::Diagnostics() : replay.problems(result);
  base::append(problems, trouble);
  progress.clear();
  requireFine(problems);
  std::sort(futures.begin(), futures.end(),
            [](const Future& a, const Future& b) { return a.number < b.number; });
  return futures;
}

std::string percentText(double share) {
  return base::formatDecimals(std::round(100.0 * share), 0) + " %";
}

/// Once a second.
void showChances(const std::vector<Future>& futures, double from, double horizon) {
  std::vector<std::vector<std::string>> rows = {{"time", "contacts", "probability", "95 % CI"}};
  for (const ContactChance& each : contactChances(futures, from, horizon, 1.0)) {
    rows.push_back({base::formatDecimals(each.time, 1) + " s",
                    std::to_string(each.contacts) + " / " + std::to_string(each.futures),
                    percentText(each.chance),
                    percentText(each.interval.low) + " to " + percentText(each.interval.high)});
  }
  printTable(rows);
  if (const std::optional<double> moment = medianContactTime(futures)) {
    printLine("median time of contacts: " + base::formatDecimals(*moment, 1) + " s");
  }
}

void printFutures(const std::vector<Future>& futures) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Future& future : futures) {
    all.push_back(nlohmann::ordered_json::parse(futureText(future)));
  }
  printLine(base::jsonText(all));
}

int futuresCommand(const FuturesCommandOptions& options, const Invocation& given) {
  if (options.moment == kStandardInputRequest) {
    return serveFuturesRequest();
  }
  requireFine(checkFuturesOptions(options), ExitWrongCommandLine);
  RunSpec spec;
  spec.from = options.moment;
  spec.set = options.set;
  if (!options.planner.empty()) {
    spec.planner = options.planner;
  }
  base::Result<std::unique_ptr<RunReplay>> replay =
      RunReplay::prepare(spec, loadMapImage, interruptStop());
  requireFine(replay.diagnostics());
  requireFine((*replay)->verdict().wrongOptions, ExitWrongCommandLine);
  requireFine((*replay)->verdict().problems, ExitBadInput, base::Severity::Warning);
  catchInterrupts();
  const RunOrigin origin = (*replay)->origin();
  const std::vector<Future> futures = futuresOf(**replay, origin.step, options, given);
  if (given.json) {
    printFutures(futures);
  } else if (!given.quiet) {
    const double from = static_cast<double>(origin.step) * (*replay)->header().dt;
    showChances(futures, from, options.futures.horizon);
  }
  if (wasInterrupted()) {
    printError("interrupted after " + std::to_string(futures.size()) + " futures");
  }
  return wasInterrupted() ? ExitRunFailed : ExitFine;
}

}  // namespace

void addFutures(CommandRegistry& commands) {
  const auto added = commands.add(
      "futures", "Estimate the probability of a contact after a moment of a recorded run",
      futuresCommand);
  CLI::App& command = added.first;
  FuturesCommandOptions& options = added.second;
  options.futures.jobs = processorCount();
  command.add_option("moment", options.moment, "RUN@SECONDS: a recorded run and a time in it")
      ->required();
  command.add_option("--seeds", options.futures.count, "Number of simulated futures (default: 20)");
  command.add_option(
      "--seed", options.futures.seed,
      "Seed of the first future; each further future uses the next seed (default: 1)");
  command.add_option("--horizon", options.futures.horizon,
                     "Duration of each future [s] (default: 10)");
  command.add_option(
      "--spread", options.futures.spread,
      "Velocity uncertainty: standard deviation of a random velocity added to each walking person "
      "once per second, per axis [m/s] (default: 0.2)");
  command.add_option("--planner", options.planner, "Planner of the first robot after that time");
  command.add_option("--set", options.set, "PATH=VALUE: value after that time, as in run --from")
      ->allow_extra_args(false);
  addJobs(command, options.futures.jobs);
  commands.addExamples(command, {{"hunavsim futures out@2 --seeds 10 --horizon 3",
                                  "Simulate ten futures of 3 s after the first 2 s"}});
}

}  // namespace app
