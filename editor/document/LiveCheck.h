#pragma once

#include "app/run/Bundle.h"
#include "editor/document/LatestTask.h"

namespace editor {

/// Checks a scenario with its map and trees beside the GUI thread, as every run of it would: walls
/// of a large map take long to trace. What was said while it was read is not told again.
class LiveCheck {
 public:
  explicit LiveCheck(std::function<void(base::Diagnostics)> deliver) : task_(std::move(deliver)) {}
  void start(app::Bundle bundle);
  void finish() { task_.finish(); }
  void finishWithin(std::chrono::milliseconds patience) { task_.finishWithin(patience); }

 private:
  LatestTask<base::Diagnostics> task_;
};

}  // namespace editor
