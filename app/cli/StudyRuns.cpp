#include "app/cli/StudyRuns.h"

#include <utility>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"

namespace app {

void addStudyRunOptions(CLI::App& command, StudyRunOptions& options, const std::string& study) {
  addJobs(command, options.jobs);
  addTimeLimit(command, options.timeLimit);
  addAllowCode(command, options.allowCode);
  CLI::Option* const resume =
      command.add_flag("--resume", options.resume,
                       "Use the runs in the journal of an earlier " + study + " in the folder");
  command
      .add_flag("--force", options.force,
                "Start again after an interruption; overwrite files that hunavsim did not create")
      ->excludes(resume);
}

std::unique_ptr<RunPool> openStudyPool(const StudyRunOptions& options, const std::string& journal,
                                       RunProgress& progress, bool keepsTrees) {
  RunPoolOptions pool;
  pool.keepsTrees = keepsTrees;
  pool.jobs = options.jobs;
  pool.timeLimit = options.timeLimit > 0.0 ? options.timeLimit : pool.timeLimit;
  pool.allowCode = options.allowCode;
  pool.loader = loadMapImage;
  pool.journal = journal;
  pool.wantsStop = wasInterrupted;
  pool.showProgress = [&progress](std::size_t finished, std::size_t executed) {
    progress.show(finished, executed);
  };
  base::Result<std::unique_ptr<RunPool>> opened = RunPool::open(std::move(pool));
  requireFine(opened.diagnostics());
  return *std::move(opened);
}

}  // namespace app
