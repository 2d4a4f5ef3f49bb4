#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/studies/FailureKind.h"
#include "app/studies/RunPool.h"

namespace app {

/// Executes runs, as RunPool::run() does.
using RunMany = std::function<base::Result<std::vector<ResultRow>>(const std::vector<RunRequest>&)>;

/// A judge of contacts: false if no admissible command of the robot could have avoided it from the
/// first sight on, so that it is no failure of the robot.
using ContactJudge = std::function<base::Result<bool>(const RunRequest& request)>;

/// Whether a failure of this kind counts. The judge, which may be empty, decides about contacts
/// with people.
base::Result<bool> countsAsFailure(const FailureKind& kind, const RunRequest& request,
                                   const ContactJudge& judge);

/// The smallest run found that fails in the same way.
struct ShrunkFailure {
  RunRequest request;
  ResultRow row;
  std::vector<std::string> removed;  // names of people, obstacles, doors, areas and robots
  std::vector<std::string> reset;    // paths of values that are again those of the scenario
  std::size_t peopleBefore = 0, people = 0;
  std::size_t runs = 0;    // tried, equal ones included
  bool isMinimal = false;  // false: `mostRuns` was reached
};

/// Whether a setting of a shrunk run ("agents=[anna]") is a list of the people, obstacles, doors,
/// areas or robots that remain, and not a change of a value.
bool isEntityList(const std::string& setting);

/// Shrinks a run that fails with this kind by delta debugging (DeltaDebugging.h). Removed are, if
/// possible: people, obstacles, doors, areas and all robots but the first; the changes of values
/// (`--set`) except planners and their programs, which the failure belongs to; the variation of
/// people. Then the duration is cut at the end of the run, unless the failure is its time limit.
/// Each of these is accepted only if the kind of the failure stays the same. `mostRuns`: limit for
/// the runs.
base::Result<ShrunkFailure> shrunkFailure(const RunRequest& failing, const ResultRow& row,
                                          const FailureKind& kind, std::size_t mostRuns,
                                          const RunMany& run, const ContactJudge& judge = {});

}  // namespace app
