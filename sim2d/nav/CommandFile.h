#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"

/// Recorded velocities of one robot.
namespace sim2d {

struct TimedTwist {
  double time = 0.0;  // [s], from when on
  BodyTwist twist;
};

struct CommandRecord {
  std::vector<TimedTwist> rows;  // by time, each until the next
  double end = 0.0;              // of the last one [s]

  /// Zero-order hold; standing before the first row and from the end on.
  BodyTwist at(double time) const;
};

/// Two kinds of CSV, told apart by their first line:
/// - `time,linear,angular` and perhaps `lateral`, in any order [s, m/s, rad/s, m/s]; the last row
///   holds as long as the one before it, one row alone for good;
/// - the `trajectory.csv` of a run: of `robot` (-1: the first), each row's velocity is the one with
///   which it came there, so that it counts from the row before. In the robot's frame by the
///   heading halfway.
/// Every problem with file, line and column.
base::Result<CommandRecord> parseCommands(const std::string& text, const std::string& file,
                                          int robot);
base::Result<CommandRecord> readCommands(const std::string& path, int robot);

}  // namespace sim2d
