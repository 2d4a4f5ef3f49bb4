#pragma once

#include <functional>

#include "app/run/RunFolder.h"
#include "app/run/Session.h"

namespace app {

/// Of the metrics what nobody will read is not worked out: per sample only for the files, per
/// behaviour type only where they are shown.
void wantNoMore(bool hasFiles, bool showsBehaviors, metrics::Selection& selection);

enum class PlanningClock : bool { Off, On };

/// A world run to its end, as `run` and `batch` do it: the writer is fed, planning is timed where
/// somebody will read it, the metrics are worked out. `wantsStop` sees each state; a writer that
/// cannot write ends the run too. `setup`: the metrics of the scenario, for the header of the
/// record.
FinishedRun simulate(Session& session, sim2d::World& world, const MetricsSetup& setup,
                     RunWriter& writer, const std::function<bool(const sim2d::Frame&)>& wantsStop,
                     PlanningClock clock = PlanningClock::On);

}  // namespace app
