#include "app/run/Simulation.h"

#include <utility>

namespace app {

void skipUnwrittenMetrics(bool hasFiles, bool showsBehaviors, metrics::Selection& selection) {
  selection.everyRobot = true;
  selection.series = selection.seriesOnDisk = hasFiles;
  selection.behaviors = showsBehaviors;
  selection.behaviorSeries = false;  // in no file
}

FinishedRun simulate(Session& session, sim2d::World& world, const MetricsSetup& setup,
                     RunWriter& writer, const std::function<bool(const sim2d::Frame&)>& wantsStop,
                     PlanningClock clock) {
  sim2d::StepTimes times;
  metrics::PlanningTime planning;
  double planned = 0.0;  // [s] up to the previous step
  if (clock == PlanningClock::On && !world.frame().robots.id.empty()) {
    world.measure(&times);
  }
  sim2d::RunResult result = session.run(world, &writer, [&](const sim2d::Frame& frame) {
    const double now = times.seconds[static_cast<std::size_t>(sim2d::StepPhase::Robots)];
    if (times.steps > planning.steps()) {
      planning.add(now - planned);
      planned = now;
    }
    if (wantsStop(frame) || writer.hasFailed()) {
      session.stop();
    }
  });
  world.measure(nullptr);
  sim2d::TraceHeader header = world.header();
  storeMetricsSelection(setup, header);
  if (writer.additionalWriter() != nullptr) {
    writer.additionalWriter()->conclude(header);
  }
  return {std::move(header),     std::move(result), planning, writer.evaluation(), {}, false, {},
          world.plannerReports()};
}

}  // namespace app
