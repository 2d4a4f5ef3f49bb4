#include "app/cli/RunWords.h"

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/LiveWords.h"
#include "app/cli/RunOnRos2.h"
#include "app/run/DataPaths.h"

namespace app {

void addRunWords(CLI::App& command, RunOptions& options) {
  command.add_option("scenario", options.scenario, "Scenario: a file, or a name of list scenarios")
      ->transform(scenarioFile);
  addOutputFolder(command, options.output, "Folder for the files of the run");
  addRunOptions(command, options);
  command.add_option("--from", options.from,
                     "RUN@SECONDS: a recorded run again up to there, then on with these options");
  command
      .add_option("--move", options.moves,
                  "\"NAME X Y HEADING\": with --from, where a person is put then (m, m, rad)")
      ->allow_extra_args(false);
  command.add_flag("--counterfactual", options.counterfactual,
                   "The same seed again without robots: what they did to people");
  command
      .add_option("--record", options.record,
                  "mcap: also a folder bag/ for ROS 2, Foxglove and PlotJuggler")
      ->check(oneOf({"mcap"}));
  addForce(command, options.force);
  addStrict(command, options.strict);
  addLiveWords(command, options);
  command.add_flag("--totals", options.totals,
                   "Only manifest.json and the totals of metrics.json, for many long runs");
}

base::Result<RunOptions> readRunWords(const std::vector<std::string>& words) {
  RunOptions options;
  bool ignored = false;
  CLI::App root;
  root.add_flag("-q,--quiet", ignored);
  CLI::App& command = *root.add_subcommand("run");
  root.require_subcommand(1);
  command.add_flag("-q,--quiet", ignored);
  command.add_flag("--json", ignored);
  addRunWords(command, options);
  RunOnRos2Words ignoredWords;  // what came over ROS 2 is recorded
  addRunOnRos2Options(command, ignoredWords);
  try {
    root.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error&) {
    return base::error("again.not-told");
  }
  return options;
}

}  // namespace app
