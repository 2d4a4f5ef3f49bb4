#pragma once

#include <map>
#include <memory>

#include <QString>

#include "editor/document/LatestTask.h"
#include "editor/document/TreeIssues.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// What trees the check looks at, and where their files are.
struct LiveTrees {
  std::vector<WrittenTree> trees;
  sim2d::FilePlaces places;  // with the scenario's own path
};

/// Checks the meaning of a scenario and its trees beside the GUI thread, because walls of a large
/// map take long to trace. `lines`: where entities stand in the file.
class LiveCheck {
 public:
  explicit LiveCheck(std::function<void(base::Diagnostics)> deliver) : task_(std::move(deliver)) {}
  void start(const sim2d::Scenario& scenario, std::shared_ptr<const sim2d::OccupancyGrid> map,
             LiveTrees trees, const std::map<base::EntityId, int>& lines);
  void finish() { task_.finish(); }
  void finishWithin(std::chrono::milliseconds patience) { task_.finishWithin(patience); }

 private:
  LatestTask<base::Diagnostics> task_;
};

}  // namespace editor
