#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Recording.h"

namespace app {

/// A recorded run, read from its folder for display.
struct RecordedRun {
  std::shared_ptr<const sim2d::Recording> recording;  // at least one state
  std::string scenario;  // the scenario file of the run; empty: missing or changed since
  std::optional<sim2d::Truncation> cut;  // set: the recording is incomplete
};

enum class IncompleteRecordings { Refused, Shown };

/// Reports all problems with their locations; a warning if the scenario file is missing.
/// `mostInMemory` [B]: for the states of the recording. `cuts`: whether truncated files, and the
/// staging folder of a killed run, are shown up to their last complete state, which a warning
/// reports.
base::Result<RecordedRun> readRecordedRun(
    const std::string& folder, std::size_t mostInMemory = sim2d::Recording::kDefaultMemory,
    IncompleteRecordings cuts = IncompleteRecordings::Refused);

/// The scenario of a recording: agents, robots, walls and doors as far as it contains them. With
/// `read`, the scenario file of the run, with the changes made by options of the run.
sim2d::Scenario scenarioOf(const sim2d::Recording& recording, sim2d::Scenario read = {});

}  // namespace app
