#pragma once

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

}  // namespace app
