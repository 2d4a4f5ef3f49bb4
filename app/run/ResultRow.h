#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/RunFolder.h"
#include "app/run/SeenFiles.h"

namespace app {

/// The cause of a failed run. `Machine`: its process was killed from outside or ran out of memory;
/// this is no fault of the run, which may succeed the next time. `Run`: everything else.
enum class FailedBy { Run, Machine };

/// What ended the way of a robot whose planner ends goals itself (Nav2). A success counts wherever
/// the robot is; a failure of one of several goals counts as one.
enum class EndedBy { Success, Failure, Contact, Standstill, Time };
/// None: the run has failed or was interrupted, or the robot had no goal.
std::optional<EndedBy> endedBy(const sim2d::RobotResult& robot);

/// A column of the results, True in runs that ended so. Of each run of such a robot one is True.
struct EndColumn {
  const char* key;
  const char* name;
  EndedBy end;
  int sense;  // 1: more of them are better, -1: fewer
};
const std::vector<EndColumn>& endColumns();
/// A column beside them: distance from the robot to the goal that its planner ended last [m].
constexpr char kDistanceLeft[] = "distance_left";

/// What the results keep of one run of a batch.
struct ResultRow {
  bool ok = false;
  FailedBy failedBy = FailedBy::Run;  // unless ok
  std::string reason;                 // why it ended, or failed
  std::string simulated;              // [s]; empty when not known
  /// Columns behind those that every row has, with their fields as CSV has them: metrics of the
  /// first robot by their keys, then those of each other robot, `robot2.path_length`; of robots
  /// with Nav2 also `endColumns` and `kDistanceLeft`.
  std::vector<std::pair<std::string, std::string>> fields;
  std::vector<InputHash> inputs;  // of the run; one that changed meanwhile comes twice
};

/// Metrics that say whether a run succeeded: the first of them that there is counts.
constexpr const char* kSuccessKeys[] = {"success", "completed"};
/// The run failed, or its first robot did: reports list it among the failures.
bool isWithoutSuccess(const ResultRow& row);

/// The row of a run that was simulated. Nothing of it was measured by the wall clock.
ResultRow rowOf(const FinishedRun& run);
/// Of one that could not begin: the first error is the reason.
ResultRow rowOf(const base::Diagnostics& problems);

/// As one line of JSON, and back; what is no row gives a failed one.
std::string rowText(const ResultRow& row);
ResultRow rowOfText(const std::string& text);

}  // namespace app
