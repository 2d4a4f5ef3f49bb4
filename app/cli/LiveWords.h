#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/bridge/groot/GrootRun.h"
#include "app/bridge/live/LiveRun.h"
#include "app/run/Bundle.h"
#include "app/run/RunOptions.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
}  // namespace CLI

namespace app {

/// --speed, --foxglove, --groot2 and what belongs to them.
void addLiveWords(CLI::App& command, RunOptions& options);

/// Paces the session as the options say and, if they ask for it, opens the live view; null
/// otherwise. `canDrive`: nobody else gives inputs, so who watches may. What it says goes to
/// standard error. Ends the command when the port is not to be had.
std::unique_ptr<live::LiveRun> openLive(const RunOptions& options, const Bundle& bundle,
                                        const MetricsSetup& metrics, bool canDrive,
                                        Session& session, sim2d::World& world);

/// The same for Groot2. Ends the command also when nobody has that name, or no tree.
std::unique_ptr<groot::GrootRun> openGroot(const RunOptions& options, const Bundle& bundle,
                                           sim2d::World& world);

/// Warns once, after the first seconds, of each port that no client has connected to.
class NoViewerCheck {
 public:
  /// Null: the port is not open. Both must outlive this object.
  NoViewerCheck(const RunOptions& options, const live::LiveRun* live, const groot::GrootRun* groot)
      : options_(options), live_(live), groot_(groot) {}
  /// To be called with each state; writes the warnings that are due to standard error.
  void look();

 private:
  const RunOptions& options_;
  const live::LiveRun* live_;
  const groot::GrootRun* groot_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  bool isOver_ = false;
};

}  // namespace app
