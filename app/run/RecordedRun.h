#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/CutRecord.h"
#include "sim2d/trace/Recording.h"

namespace app {

/// The folder of a run, as it is shown.
struct RecordedRun {
  std::shared_ptr<const sim2d::Recording> recording;  // at least one state
  std::string scenario;  // the file that was run; empty: it is gone or has changed since
  std::optional<sim2d::RecordCut> cut;  // it is not whole
};

enum class CutRecords { Refused, Shown };

/// All problems, with their places; warnings tell when the scenario is not there any more.
/// `mostInMemory` [B]: of the recording's states, once it is read. `cuts`: whether files that end
/// in the midst, and what a killed run has left in the folder, are shown as far as they are whole;
/// a warning says how far.
base::Result<RecordedRun> readRecordedRun(const std::string& folder,
                                          std::size_t mostInMemory = sim2d::Recording::kUsualMemory,
                                          CutRecords cuts = CutRecords::Refused);

/// The scenario of a record: people, robots, walls and doors as far as it tells. With `read`, the
/// scenario that was run: what its options had made different.
sim2d::Scenario scenarioOf(const sim2d::Recording& recording, sim2d::Scenario read = {});

}  // namespace app
