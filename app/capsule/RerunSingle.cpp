#include <memory>
#include <utility>

#include "app/capsule/Rerun.h"
#include "app/capsule/Unpacked.h"
#include "app/capsule/UnpackedInputs.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OutputFolder.h"
#include "app/run/RunFolder.h"
#include "app/run/RunReplay.h"
#include "app/run/Session.h"
#include "sim2d/world/World.h"

namespace capsule {

namespace {

/// A run that is ready to be simulated.
struct PreparedRun {
  app::Bundle bundle;
  app::Verdict verdict;
  std::unique_ptr<app::RunReplay> replay;  // null: the run has no recording
};

/// With a recording, its inputs (people who were dragged, a robot driven by hand) are repeated.
base::Result<PreparedRun> prepareRun(const UnpackedCapsule& capsule, const app::RunSpec& of,
                                     const RerunOptions& options) {
  const std::string study = app::pathIn(capsule.root, "study");
  const auto stop = options.stop ? options.stop : std::make_shared<const base::StopFlag>();
  PreparedRun run;
  if (app::entryExists(app::pathIn(study, "trajectory.csv"))) {
    app::RunSpec spec;
    spec.from = study + "@0";
    spec.allowCode = options.allowCode;
    base::Result<std::unique_ptr<app::RunReplay>> replay =
        app::RunReplay::prepare(spec, options.loader, stop);
    if (!replay) {
      return replay.diagnostics();
    }
    run.replay = *std::move(replay);
    run.bundle = run.replay->bundle();
    run.verdict = std::move(run.replay->verdict());
    return run;
  }
  app::RunSpec spec = of;
  spec.allowCode = options.allowCode;
  const base::Result<app::RunSettings> settings = app::runSettingsOf(spec);
  if (!settings) {
    return settings.diagnostics();
  }
  run.bundle = app::readBundle(spec, *settings, options.loader);
  run.bundle.stopOfRun = stop;
  run.verdict = app::check(run.bundle);
  return run;
}

/// Simulates it and writes its folder.
base::Diagnostics simulateInto(const std::string& folder, const UnpackedCapsule& capsule,
                               PreparedRun& prepared, const RerunOptions& options) {
  const bool hasFiles = prepared.replay != nullptr;
  base::Result<std::unique_ptr<app::OutputFolder>> output = app::OutputFolder::open(folder, false);
  if (!output) {
    return output.diagnostics();
  }
  sim2d::World& world = *prepared.verdict.world;
  world.enableScans(app::entryExists(app::pathIn(capsule.root, "study/scans.csv")));
  app::skipUnwrittenMetrics(hasFiles, hasFiles, prepared.verdict.metrics.selection);
  app::RunWriter writer(hasFiles ? (*output)->staging() : std::string(), world,
                        hasFiles ? prepared.replay->header() : world.header(),
                        prepared.verdict.metrics.selection, prepared.verdict.metrics.parameters);
  app::Session session(sim2d::stopRuleOf(*prepared.bundle.scenario));
  app::FinishedRun run = app::simulate(session, world, prepared.verdict.scenarioMetrics, writer,
                                       [&](const sim2d::Frame& frame) {
                                         if (prepared.replay) {
                                           prepared.replay->observe(frame, world, session);
                                         }
                                         return options.stop && options.stop->isStopRequested();
                                       });
  run.totalsOnly = !hasFiles;
  return app::writeRunFolder(**output, run, writer, prepared.bundle, {});
}

}  // namespace

base::Result<Rerun> rerunSingle(const UnpackedCapsule& capsule, const RerunOptions& options) {
  const app::DataFolderOverride shipped(app::pathIn(capsule.root, kSharedFolder));
  Rerun rerun;
  const auto differ = [&](const base::Diagnostics& problems) {
    base::append(rerun.differences, atMembers(problems, capsule.root, capsule.file));
  };
  const base::Result<app::RunSpec> spec = specOfUnpackedRun(capsule.manifest, capsule.root);
  if (!spec) {
    differ(spec.diagnostics());
    return rerun;
  }
  base::Result<PreparedRun> prepared = prepareRun(capsule, *spec, options);
  if (!prepared) {
    differ(prepared.diagnostics());
    return rerun;
  }
  base::Diagnostics errors = app::errorsOf(prepared->verdict.problems);
  base::append(errors, app::errorsOf(prepared->verdict.wrongOptions));
  for (const base::Diagnostic& problem : errors) {
    if (problem.code == "code.not-allowed") {
      return atMembers({problem}, capsule.root, capsule.file);
    }
  }
  if (!errors.empty() || prepared->verdict.world == nullptr) {
    differ(errors);
    return rerun;
  }
  const std::string folder = app::pathIn(capsule.root, "rerun");
  const base::Diagnostics unwritten =
      app::errorsOf(simulateInto(folder, capsule, *prepared, options));
  if (!unwritten.empty()) {
    return unwritten;
  }
  if (options.stop && options.stop->isStopRequested()) {
    return rerun;
  }
  rerun.finished = {0};
  differ(runFolderDifferences(capsule, kStudyFolder, folder, !spec->counterfactual));
  return rerun;
}

}  // namespace capsule
