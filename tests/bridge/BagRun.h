#pragma once

#include <memory>
#include <string>

#include "app/bridge/bag/RunBagWriter.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "metrics/Report.h"

inline std::string codesOf(const base::Diagnostics& problems) {
  std::string codes;
  for (const base::Diagnostic& each : problems) {
    codes += (codes.empty() ? "" : " ") + std::string(each.code);
  }
  return codes;
}

inline std::string textsOf(const base::Diagnostics& problems) {
  std::string texts;
  for (const base::Diagnostic& each : problems) {
    texts += each.text() + "\n";
  }
  return texts;
}

/// Runs the café for some seconds into a folder, with a bag beside the other files. `steering`:
/// what somebody outside does.
inline base::Diagnostics runCafeInto(const std::string& folder, double seconds,
                                     app::RunSpec options = {},
                                     app::Session::Steering steering = {}) {
  options.scenario = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
  options.duration = seconds;
  const app::Bundle bundle = app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
  app::Verdict verdict = app::check(bundle);
  if (!verdict.world) {
    return verdict.problems;
  }
  base::Result<std::unique_ptr<app::OutputFolder>> output = app::OutputFolder::open(folder, false);
  if (!output) {
    return output.diagnostics();
  }
  metrics::Selection selection = verdict.metrics.selection;
  selection.everyRobot = true;
  app::RunWriter writer((*output)->staging(), *verdict.world, verdict.world->header(), selection,
                        verdict.metrics.parameters);
  verdict.world->enableScans(true);
  bridge::BagFolderWriter bag((*output)->staging(), *bundle.scenario, *verdict.world);
  writer.setAdditionalWriter(&bag);
  app::Session session(sim2d::stopRuleOf(*bundle.scenario));
  session.steer(std::move(steering));
  const app::FinishedRun run =
      app::simulate(session, *verdict.world, verdict.scenarioMetrics, writer,
                    [](const sim2d::Frame& /*frame*/) { return false; });
  return app::errorsOf(app::writeRunFolder(**output, run, writer, bundle, {"hunavsim"}));
}
