#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/BatchFolder.h"

namespace app {

namespace {

/// Reports how many runs failed and the reason of the first, also with --quiet, because it explains
/// the exit code; and runs that do not depend on the seed.
base::Diagnostics problemsOf(const BatchFolder& folder) {
  const ResultStore& store = folder.store();
  base::Diagnostics diagnostics;
  if (const auto& first = store.firstFailure()) {
    diagnostics.push_back(base::error("batch.runs-failed",
                                      {store.failed(), store.finished(), first->run, first->reason},
                                      folder.resultsFile()));
  }
  if (store.failedByMachine() > 0) {
    diagnostics.push_back(
        base::warning("batch.failed-by-machine", {store.failedByMachine()}, folder.resultsFile()));
  }
  if (const std::vector<std::string>& constant = folder.constantCells(); !constant.empty()) {
    diagnostics.push_back(base::warning("batch.seeds-alike", {constant.size(), constant.front()},
                                        folder.resultsFile()));
  }
  return diagnostics;
}

struct MergeOptions {
  std::string output;
  std::vector<std::string> shards;
  bool force = false;
};

int mergeCommand(const MergeOptions& options, const Invocation& given) {
  const base::Result<std::unique_ptr<BatchFolder>> folder =
      mergeShards(options.output, options.shards,
                  options.force ? ExistingBatch::Replace : ExistingBatch::Refuse);
  requireFine(folder.diagnostics());
  return reportBatch(**folder, {}, given);
}

}  // namespace

int reportBatch(const BatchFolder& folder, const base::Diagnostics& problems,
                const Invocation& given) {
  const ResultStore& store = folder.store();
  const std::size_t total = store.study().shard.runCount(store.study().runs);
  const std::size_t enough = store.study().enoughSeeds;
  const std::string count =
      enough > 0 ? std::to_string(store.finished()) + " runs"
                 : std::to_string(store.finished()) + " of " + std::to_string(total) + " runs";
  if (base::hasErrors(problems)) {
    printError("after " + count + ": continue with batch --resume");
    requireFine(problems);
  }
  if (given.json) {
    print(folder.manifest());
  } else if (!given.quiet) {
    printLine(count + " finished, " + std::to_string(store.failed()) +
              " failed: " + folder.resultsFile());
    if (enough > 0) {
      printLine(std::to_string(enough) + " seeds were enough: " + store.study().until);
    }
  }
  printDiagnostics(problemsOf(folder));
  if (!store.isComplete()) {
    printError("interrupted: finished runs are kept; continue with batch --resume");
  }
  return store.isComplete() && store.failed() == 0 ? ExitFine : ExitRunFailed;
}

void addMerge(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("merge", "Merge the results of all shards of a batch", mergeCommand);
  command.add_option("shard", options.shards, "Folders written by batch --shard K/N")->required();
  addOutputFolder(command, options.output, "Output folder").required();
  command.add_flag("--force", options.force,
                   "Restart an interrupted merge from the beginning; overwrite files that hunavsim "
                   "did not create");
  commands.addExamples(command, {{"hunavsim merge -o results part1 part2",
                                  "Join the parts of a study", "the folders of all parts"}});
}

}  // namespace app
