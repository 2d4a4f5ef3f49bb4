#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "app/run/RunFolder.h"

namespace app {

/// The cause of a failed run. `Machine`: the process was killed from outside or ran out of memory,
/// so the run may succeed when repeated. `Run`: everything else.
enum class FailedBy { Run, Machine };

/// How the last goal of a robot ended whose planner ends goals itself (Nav2). A success counts at
/// any robot position; one failed goal of several counts as failure.
enum class EndedBy { Success, Failure, Contact, Standstill, Time };
/// nullopt: the run failed or was interrupted, or the robot had no goal.
std::optional<EndedBy> endedBy(const sim2d::RobotResult& robot);

/// A column of the results, True in runs that ended this way. Exactly one is True per run of such a
/// robot.
struct EndColumn {
  const char* key;
  const char* name;
  EndedBy end;
  int sense;  // 1: more is better, -1: less is better
};
const std::vector<EndColumn>& endColumns();
/// An additional column: distance from the robot to the goal that its planner ended last [m].
constexpr char kDistanceLeft[] = "distance_left";

/// What the nodes of a behaviour tree returned in a run.
struct TreeRow {
  std::string owners;  // names of people and robots, separated by ", "
  std::string paths;   // of the nodes as in trees.csv, separated by line ends
  /// Per node a hexadecimal digit: RUNNING 1, SUCCESS 2, FAILURE 4, SKIPPED 8; or u: it returned
  /// nothing and cannot, as the structure of the tree proves.
  std::string returned;
};

/// The stored result of one batch run.
struct ResultRow {
  bool ok = false;
  FailedBy failedBy = FailedBy::Run;  // unless ok
  std::string reason;                 // of the end or the failure
  std::string simulated;              // [s]; empty if unknown
  /// Columns after those common to all rows, with CSV fields: the metrics of the first robot by
  /// key, then those of other robots as `robot2.path_length`; for Nav2 robots also `endColumns` and
  /// `kDistanceLeft`.
  std::vector<std::pair<std::string, std::string>> fields;
  std::vector<TreeRow> trees;     // if the experiment requests their coverage (TreeCoverage.h)
  std::vector<InputHash> inputs;  // of the run; a file that changed meanwhile occurs twice
};

/// The description of a column.
struct ColumnInfo {
  std::string name, unit;  // display name; empty unit: none
  bool isBoolean = false;
  bool isCount = false;
  int sense = 0;  // 1: higher is better, -1: lower is better, 0: neutral
};
/// The description of a metric of the program or of another column above, also of another robot
/// ("robot2.success"); nullopt for other names, such as metrics of a user's file.
std::optional<ColumnInfo> columnInfo(const std::string& column);
/// The columns of the first robot that columnInfo() knows.
std::vector<std::string> knownColumns();

/// The field of a column; null: the row has none.
const std::string* fieldOf(const ResultRow& row, const std::string& column);

/// The number in a field, 1 for True and 0 for False; nullopt: empty or other text.
std::optional<double> numberIn(const std::string& field);
/// The number in the field of a column; nullopt also if the row has none.
std::optional<double> numberOf(const ResultRow& row, const std::string& column);

/// Metrics for success; the first one that exists applies.
constexpr const char* kSuccessKeys[] = {"success", "completed"};
bool isSuccessKey(const std::string& key);  // whether it is one of them
/// Whether the run failed or its first robot did not succeed; reports list it as a failure.
bool isUnsuccessful(const ResultRow& row);

/// The outcome of a run without success, from its metrics or its reason: "collided with a person".
/// `valueOf`: the number in a column, NaN if there is none.
std::string outcomeText(bool ok, const std::string& reason,
                        const std::function<double(const char* column)>& valueOf);

/// The row of a simulated run. Contains no wall-clock measurements.
ResultRow rowOf(const FinishedRun& run);
/// The row of a run that could not start, with the first error as reason.
ResultRow rowOf(const base::Diagnostics& problems);

/// Serialisation as one line of JSON. Invalid text: nullopt, or with `parseRow` a failed row.
std::string serializeRow(const ResultRow& row);
std::optional<ResultRow> tryParseRow(const std::string& text);
ResultRow parseRow(const std::string& text);

}  // namespace app
