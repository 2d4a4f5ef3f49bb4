#include "app/cli/BatchReport.h"

#include "app/cli/Console.h"

namespace app {

namespace {

/// Reports how many runs failed and the reason of the first, also with --quiet, because it explains
/// the exit code.
base::Diagnostics failuresOf(const BatchFolder& folder) {
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
  return diagnostics;
}

}  // namespace

int reportBatch(const BatchFolder& folder, const base::Diagnostics& problems,
                const Invocation& given) {
  const ResultStore& store = folder.store();
  const std::size_t total = store.study().shard.runCount(store.study().runs);
  const std::string count =
      std::to_string(store.finished()) + " of " + std::to_string(total) + " runs";
  if (base::hasErrors(problems)) {
    printError("after " + count + ": continue with batch --resume");
    requireFine(problems);
  }
  if (given.json) {
    print(folder.manifest());
  } else if (!given.quiet) {
    printLine(count + " finished, " + std::to_string(store.failed()) +
              " failed: " + folder.resultsFile());
  }
  printDiagnostics(failuresOf(folder));
  if (!store.isComplete()) {
    printError("interrupted: finished runs are kept; continue with batch --resume");
  }
  return store.isComplete() && store.failed() == 0 ? ExitFine : ExitRunFailed;
}

}  // namespace app
