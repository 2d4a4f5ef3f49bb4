#pragma once

#include <functional>

#include "app/run/RunFolder.h"
#include "app/run/Session.h"

namespace app {

/// Removes from the selection what is not written: series per sample without files, results per
/// behaviour type unless they are shown.
void skipUnwrittenMetrics(bool hasFiles, bool showsBehaviors, metrics::Selection& selection);

enum class PlanningClock : bool { Off, On };

/// Runs a world to its end, for `run` and `batch`: feeds the writer, measures planning time if
/// `clock` is On, and computes the metrics. `wantsStop` receives each state; the run also stops
/// when the writer fails. `setup`: metrics of the scenario, for the header of the recording.
FinishedRun simulate(Session& session, sim2d::World& world, const MetricsSetup& setup,
                     RunWriter& writer, const std::function<bool(const sim2d::Frame&)>& wantsStop,
                     PlanningClock clock = PlanningClock::On);

}  // namespace app
