#include "app/studies/RunStepper.h"

#include <limits>
#include <utility>

#include "app/run/PlannerFiles.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunReplay.h"

namespace app {

namespace {

/// An error if a robot is driven by code that is not part of this program.
base::Diagnostics copyProblems(const Bundle& bundle) {
  return externalCodeOf(*bundle.scenario).empty()
             ? base::Diagnostics()
             : base::Diagnostics{base::error("contacts.external-code", {}, bundle.path)};
}

/// Processes are copied, so they must have one thread. The results do not depend on it.
void useOneThread(Bundle& bundle) {
  bundle.settings.threads = 1;
}

}  // namespace

base::Result<RepeatableRun> repeatableRunOf(const std::string& folder,
                                            const sim2d::ImageLoader& loader) {
  const base::Result<RecordedRun> recorded = readRecordedRun(folder);
  if (!recorded) {
    return recorded.diagnostics();
  }
  base::Result<RunProvenance> made = provenanceOf(folder, loader);
  if (!made) {
    return made.diagnostics();
  }
  base::Diagnostics problems = copyProblems(made->bundle);
  if (!problems.empty()) {
    return problems;
  }
  useOneThread(made->bundle);
  return RepeatableRun{std::move(made->bundle), std::move(made->branches), recorded->recording};
}

base::Result<RepeatableRun> repeatableRunOf(const Bundle& bundle,
                                            const std::function<bool()>& wantsStop) {
  RepeatableRun run;
  run.bundle = bundle;
  useOneThread(run.bundle);
  base::Diagnostics problems = copyProblems(bundle);
  if (!problems.empty()) {
    return problems;
  }
  const Verdict verdict = check(run.bundle);
  if (verdict.world == nullptr) {
    problems = verdict.wrongOptions;
    base::append(problems, verdict.problems);
    return problems;
  }
  Session session(sim2d::stopRuleOf(*run.bundle.scenario));
  session.enableHistory(1);
  session.run(*verdict.world, nullptr, [&](const sim2d::Frame&) {
    if (wantsStop && wantsStop()) {
      session.stop();
    }
  });
  auto recording = session.history();
  run.recording = std::move(recording);
  return run;
}

base::Result<std::unique_ptr<RunStepper>> RunStepper::open(const RepeatableRun& run) {
  std::unique_ptr<RunStepper> stepper(new RunStepper());
  stepper->recording_ = run.recording;
  stepper->inputs_ = run.recording->inputsUntil(std::numeric_limits<std::int64_t>::max());
  stepper->run_ = std::make_unique<BranchedRun>(run.bundle, run.branches);
  Verdict& verdict = stepper->run_->verdict();
  if (verdict.world == nullptr) {
    base::Diagnostics problems = verdict.wrongOptions;
    base::append(problems, verdict.problems);
    return problems;
  }
  stepper->world_ = std::move(verdict.world);
  return stepper;
}

bool RunStepper::advance(const sim2d::StepInputs& more) {
  run_->apply(frame(), *world_);
  sim2d::StepInputs inputs = sim2d::inputsOf(inputs_, step() + 1);
  inputs.insert(inputs.end(), more.begin(), more.end());
  return world_->step(inputs);
}

bool RunStepper::isAsRecorded() const {
  const std::size_t index = recording_->indexAt(step());
  if (recording_->stepOf(index) != step()) {
    return true;  // not every step is recorded
  }
  std::string now, then;
  sim2d::appendTrajectoryRows(now, frame());
  sim2d::appendTrajectoryRows(then, *recording_->frame(index));
  return now == then;
}

}  // namespace app
