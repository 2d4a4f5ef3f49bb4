#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/studies/Search.h"

namespace app {

/// A failure with the scenario file that repeats it.
struct SavedFailure {
  FailureKind kind;
  std::size_t run = 0;  // of the search, in which it was found
  ShrunkFailure shrunk;
  bool isShrunk = true;
  std::string file, text;   // relative name and content of its scenario file
  bool isRepeated = false;  // the file gives the same end and metrics, bit for bit
};

/// A finished search. Experiment and space must outlive it.
struct SearchStudy {
  const Experiment* experiment = nullptr;
  const SearchSpace* space = nullptr;
  SearchPlan plan;
  SearchResult result;
  std::vector<SavedFailure> failures;
  std::optional<SavedFailure> worst;  // not shrunk
};

struct SearchStudyOptions {
  SearchPlan plan;
  std::string folder;  // of the results; scenario files refer to their maps and trees from there
  sim2d::ImageLoader loader;
  std::function<void(const std::string& phase)> showPhase;  // "searching", "shrinking 1 of 3"
};

/// Searches, shrinks each failure, and makes the scenario files. Creates the folder `failures` in
/// the results. Errors: those of `run`.
base::Result<SearchStudy> runSearchStudy(const Experiment& experiment, const SearchSpace& space,
                                         const SearchStudyOptions& options, const RunMany& run);

/// Judges contacts by their last avoidable action (AvoidableContact.h). Contacts that cannot be
/// analysed, for example of external planner programs, count against the robot. No other thread
/// and no world may exist in this process.
ContactJudge avoidabilityJudge(const sim2d::ImageLoader& loader, std::function<bool()> wantsStop);

/// What a command does with a run: show it in the window, or execute it without the window.
enum class RunUse { Play, Run };
/// The command line that repeats a run of the search, with its number in SearchResult::runs.
std::string searchedRunCommand(const SearchStudy& study, std::size_t run, RunUse use);

/// archive.json with SearchPlan::covers: trees with what was never reached, and the runs that
/// reached a node first (FORMAT.md).
std::string coverageJson(const SearchStudy& study);
/// coverage.csv: a row per node of each tree with the first run that reached it.
std::string coverageCsv(const SearchStudy& study);

/// archive.json: the cells of the archive, the failures and the worst run (FORMAT.md).
std::string searchJson(const SearchStudy& study);
/// runs.csv: all runs of the search in their order.
std::string searchCsv(const SearchStudy& study);

}  // namespace app
