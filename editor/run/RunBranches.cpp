#include "editor/run/RunBranches.h"

#include <algorithm>
#include <utility>

namespace editor {

RunRequest requestOf(app::Bundle bundle, std::vector<app::ForkStage> stages) {
  RunRequest request;
  request.again = [bundle, stages] { return requestOf(bundle, stages); };
  const base::Result<app::Bundle> last = app::goingOnAs(bundle, stages);
  const sim2d::Scenario& scenario = last ? *last->scenario : *bundle.scenario;
  request.rule = sim2d::stopRuleOf(scenario);
  request.recordEvery = scenario.desktop.recordEvery.value_or(1);
  bundle.left = request.left;
  request.bundle = std::make_shared<const app::Bundle>(bundle);
  request.stages = stages;
  const auto made = std::make_shared<std::shared_ptr<app::StagedRun>>();
  if (!stages.empty()) {
    request.change = [made](const sim2d::Frame& frame, sim2d::World& world) {
      (*made)->look(frame, world);
    };
  }
  request.makeWorld = [bundle = std::move(bundle), stages = std::move(stages),
                       made]() -> base::Result<std::unique_ptr<sim2d::World>> {
    base::Result<std::shared_ptr<app::StagedRun>> run = app::StagedRun::make(bundle, stages);
    if (!run) {
      return run.diagnostics();
    }
    *made = *run;
    std::unique_ptr<sim2d::World> world = (*made)->takeWorld();
    world->tellSenses(true);  // to be drawn
    return {std::move(world), run.diagnostics()};
  };
  return request;
}

base::Result<Fork> forkOf(const RunRequest& run, std::int64_t at, const app::RunOptions& changes,
                          const sim2d::TraceHeader& header) {
  Fork fork;
  const bool isChanged = !app::changesText(changes).empty();
  if (run.bundle == nullptr) {
    fork.request = run;
    return isChanged ? base::Result<Fork>(base::error("again.not-told"))
                     : base::Result<Fork>(std::move(fork));
  }
  std::vector<app::ForkStage> stages = run.stages;
  stages.erase(std::remove_if(stages.begin(), stages.end(),
                              [&](const app::ForkStage& each) { return each.step > at; }),
               stages.end());
  base::Diagnostics problems;
  if (isChanged) {
    stages.push_back({at, changes});
    const base::Result<app::Bundle> is = app::goingOnAs(*run.bundle, stages);
    base::append(problems, is.diagnostics());
    if (is) {
      base::append(problems, app::errorsOf(app::check(*is, app::CheckDepth::Meaning).problems));
    }
  }
  for (const app::ForkStage& stage : stages) {
    if (stage.step != at) {
      continue;  // among the inputs of the run
    }
    const base::Result<sim2d::StepInputs> puts = app::inputsOfMoves(stage.options.moves, header);
    base::append(problems, puts.diagnostics());
    if (puts) {
      fork.moves.insert(fork.moves.end(), puts->begin(), puts->end());
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  fork.request = requestOf(*run.bundle, std::move(stages));
  return {std::move(fork), std::move(problems)};
}

}  // namespace editor
