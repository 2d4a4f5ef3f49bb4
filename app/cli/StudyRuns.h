#pragma once

#include <memory>
#include <string>

#include "app/cli/RunProgress.h"
#include "app/run/Batch.h"
#include "app/studies/RunPool.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
}  // namespace CLI

namespace app {

/// How the commands that request runs from a RunPool (`tune`, `gate`, `search`) execute them.
struct StudyRunOptions {
  int jobs = processorCount();
  double timeLimit = 0.0;  // of a run [s], wall-clock time; 0: none
  bool allowCode = false, resume = false, force = false;
};
/// Adds --jobs, --time-limit, --allow-code, --resume and --force. `study`: what the help calls the
/// study of --resume: "search".
void addStudyRunOptions(CLI::App& command, StudyRunOptions& options, const std::string& study);

/// The pool of a command. `journal`: its file; empty: none. The command ends if the journal cannot
/// be used. `progress` must outlive the pool. `keepsTrees`: RunPoolOptions::keepsTrees.
std::unique_ptr<RunPool> openStudyPool(const StudyRunOptions& options, const std::string& journal,
                                       RunProgress& progress, bool keepsTrees = false);

}  // namespace app
