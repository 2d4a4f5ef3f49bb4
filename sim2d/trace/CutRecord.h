#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// What is whole of a record whose files end in the midst: a run that was killed, a copy that was
/// not finished, a full disk.
struct RecordCut {
  std::vector<std::string> files;  // names of those that are cut; none: the record is whole
  double time = 0.0;               // of the last state that is whole [s]
  std::optional<double> end;       // of the run, where its events tell it [s]

  /// Set by who reads: of a run that was killed. Its header was written when the run began and does
  /// not know who came later; they are met when they are read.
  bool isUnfinished = false;

  bool isCut() const { return !files.empty(); }
  bool has(std::string_view name) const;
  void note(const std::string& name);
};

/// Length of the whole lines of a CSV text [bytes]; a line end between quotes ends none.
std::size_t wholeLines(std::string_view text);

/// A file of a record, or what a process that was killed left of it (`base::GrowingFile`); its
/// usual path when there is neither.
std::string wholeOrUnfinished(const std::string& folder, const std::string& name);

/// Takes out of a trace what its cut has spoilt: the last state, when the trajectory ends in the
/// midst of it, and events after the last state. `lacksRobot`: the last state does.
void takeWholePart(Trace& trace, bool lacksRobot, RecordCut& cut);

/// Reads trajectory.csv, events.csv and trace.json of a folder; where they are cut, what is whole.
base::Result<Trace> readTraceAsFarAsWhole(const std::string& directory, RecordCut& cut);

}  // namespace sim2d
