#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"

/// Recorded velocity commands of one robot.
namespace sim2d {

struct TimedTwist {
  double time = 0.0;  // start [s]
  BodyTwist twist;
};

struct VelocityRecording {
  std::vector<TimedTwist> rows;  // sorted by time; each holds until the next
  double end = 0.0;              // end of the last row [s]

  /// Zero-order hold; zero before the first row and from the end on.
  BodyTwist at(double time) const;
};

/// Two kinds of CSV, distinguished by their first line:
/// - `time,linear,angular` and optionally `lateral`, in any order [s, m/s, rad/s, m/s]; the last
///   row holds as long as the one before it, a single row holds forever;
/// - the `trajectory.csv` of a run: the velocity in each row of `robot` (-1: the robot of the first
///   row) is the one of the step that ended there, so it holds from the previous row. It is rotated
///   into the robot frame by the heading halfway.
/// Each problem is reported with file, line and column.
base::Result<VelocityRecording> parseVelocities(const std::string& text, const std::string& file,
                                                int robot);
base::Result<VelocityRecording> readVelocities(const std::string& path, int robot);

}  // namespace sim2d
