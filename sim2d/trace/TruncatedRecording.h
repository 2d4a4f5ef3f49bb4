#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Describes an incomplete recording: the run was killed, a copy was interrupted, or the disk was
/// full.
struct Truncation {
  std::vector<std::string> files;  // names of the truncated files; none: complete
  double time = 0.0;               // of the last complete state [s]
  std::optional<double> end;       // end of the run, if an event states it [s]

  /// Set by the caller for a killed run: its header was written at the start and lacks agents that
  /// were spawned later; they are added when their rows are read.
  bool isUnfinished = false;

  bool isTruncated() const { return !files.empty(); }
  bool has(std::string_view name) const;
  void note(const std::string& name);
};

/// Length of the complete lines of a CSV text [bytes]; line ends inside quotes do not count.
std::size_t completeLinesSize(std::string_view text);

/// The path of a file of a recording, or of the temporary file of a killed process
/// (`base::AtomicFileWriter`); the regular path if neither exists.
std::string finalOrTemporaryPath(const std::string& folder, const std::string& name);

/// Removes incomplete data: the last state if the trajectory is truncated inside it, and events
/// after the last state. `lacksRobot`: a robot is missing in the last state.
void dropIncompletePart(Trace& trace, bool lacksRobot, Truncation& cut);

/// Reads the complete part of trajectory.csv, events.csv and trace.json in a folder.
base::Result<Trace> readTruncatedTrace(const std::string& directory, Truncation& cut);

}  // namespace sim2d
