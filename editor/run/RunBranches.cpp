#include "editor/run/SimulationRunner.h"

namespace editor {

namespace {

/// A re-run that diverges from the original from a step on.
struct BranchRequest {
  RunRequest request;
  sim2d::StepInputs moves;  // Inputs of the following step.
};

/// `run`: a new, unstarted request. Changes after `at` and inputs from then on are not repeated.
/// Errors: changes that are impossible during a run; changes of a run whose inputs are unknown.
base::Result<BranchRequest> branchRequestFor(const RunRequest& run, std::int64_t at,
                                             const app::RunSpec& changes,
                                             const sim2d::TraceHeader& header) {
  BranchRequest fork;
  const bool isChanged = !app::changesText(changes).empty();
  if (run.bundle == nullptr) {
    fork.request = run;
    return isChanged ? base::Result<BranchRequest>(base::error("again.not-told"))
                     : base::Result<BranchRequest>(std::move(fork));
  }
  std::vector<app::RunBranch> branches = app::branchesUntil(run.branches, at);
  base::Diagnostics problems;
  if (isChanged) {
    branches.push_back({at, changes});
    const base::Result<app::Bundle> is = app::continueWith(*run.bundle, branches);
    base::append(problems, is.diagnostics());
    if (is) {
      base::append(problems, app::errorsOf(app::check(*is, app::CheckDepth::Meaning).problems));
    }
  }
  for (const app::RunBranch& branch : branches) {
    if (branch.step != at) {
      continue;  // Included in the inputs of the run.
    }
    const base::Result<sim2d::StepInputs> puts = app::inputsOfMoves(branch.changes.moves, header);
    base::append(problems, puts.diagnostics());
    if (puts) {
      fork.moves.insert(fork.moves.end(), puts->begin(), puts->end());
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  fork.request = requestFor(*run.bundle, std::move(branches));
  return {std::move(fork), std::move(problems)};
}

/// The scenario with the seed of the draws after the last branch.
std::shared_ptr<const sim2d::Scenario> withSeed(std::shared_ptr<const sim2d::Scenario> scenario,
                                                const std::vector<app::RunBranch>& branches) {
  for (const app::RunBranch& branch : branches) {
    if (branch.changes.seed) {
      auto reseeded = std::make_shared<sim2d::Scenario>(*scenario);
      reseeded->desktop.seed = branch.changes.seed;
      scenario = std::move(reseeded);
    }
  }
  return scenario;
}

}  // namespace

RunRequest requestFor(app::Bundle bundle, std::vector<app::RunBranch> branches) {
  RunRequest request;
  request.again = [bundle, branches] { return requestFor(bundle, branches); };
  const base::Result<app::Bundle> last = app::continueWith(bundle, branches);
  request.scenarios = {bundle.scenario,
                       withSeed(last ? last->scenario : bundle.scenario, branches)};
  const sim2d::Scenario& scenario = *request.scenarios.now;
  request.rule = sim2d::stopRuleOf(scenario);
  request.recordEvery = scenario.desktop.recordEvery.value_or(1);
  bundle.stopOfRun = request.left;
  request.bundle = std::make_shared<const app::Bundle>(bundle);
  request.branches = branches;
  const auto run = std::make_shared<std::unique_ptr<app::BranchedRun>>();
  if (!branches.empty()) {
    request.change = [run](const sim2d::Frame& frame, sim2d::World& world) {
      (*run)->apply(frame, world);
    };
  }
  request.makeWorld = [bundle = std::move(bundle), branches = std::move(branches),
                       run]() -> base::Result<std::unique_ptr<sim2d::World>> {
    *run = std::make_unique<app::BranchedRun>(bundle, branches);
    app::Verdict& verdict = (*run)->verdict();
    if (verdict.world == nullptr) {
      base::Diagnostics problems = verdict.wrongOptions;
      base::append(problems, verdict.problems);
      return problems;
    }
    verdict.world->publishSensors(true);  // to be drawn
    return {std::move(verdict.world), verdict.worldRemarks};
  };
  return request;
}

RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings) {
  app::Bundle bundle = document.bundle();
  bundle.settings = settings;
  if (settings.code == sim2d::ExternalCodePolicy::Skipped) {  // Otherwise there would be no world.
    bundle.settings.code = sim2d::ExternalCodePolicy::Refused;
  }
  return requestFor(std::move(bundle));
}

QString runEndText(const sim2d::Scenario& scenario) {
  const sim2d::StopRule rule = sim2d::stopRuleOf(scenario);
  const double dt = scenario.desktop.dt.value_or(0.05);
  return rule.stopOnArrival ? QObject::tr("until the robot arrives, at most %1 s")
                                  .arg(qRound(static_cast<double>(rule.maximumSteps) * dt))
                            : QString();
}

// Loop playback and branches of SimulationRunner.

void SimulationRunner::setLoop(std::optional<LoopRange> loop) {
  Q_ASSERT(!loop || loop->from < loop->to);
  if (loop == loop_) {
    return;
  }
  if (!loop && isLooping_) {
    pause();
  }
  loop_ = loop;
  Q_EMIT loopChanged();
}

RunnerBranch* SimulationRunner::branchOf(int number) {
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const RunnerBranch& each) { return each.number == number; });
  return found == branches_.end() ? nullptr : &*found;
}

RecordingPtr SimulationRunner::recordingOf(int branch) const {
  if (branch == branch_) {
    return recording_;
  }
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const RunnerBranch& each) { return each.number == branch; });
  return found == branches_.end() ? nullptr : found->recording;
}

/// Stores what is needed to show this run again.
void SimulationRunner::storeShownBranch() {
  RunnerBranch& kept = *branchOf(branch_);
  kept.recording = recording_;
  kept.newest = newest_;
  kept.isFinished = finished_;
  kept.isRecorded = isRecorded_;
  kept.result = result_;
  kept.again = recreate_;
  kept.scenarios = scenarios_;
}

base::Diagnostics SimulationRunner::branchProblems(const app::RunSpec& changes) const {
  if (!canBranchFromShown()) {
    return {};
  }
  const base::Result<BranchRequest> fork =
      branchRequestFor(recreate_(), shown_->step, changes, *recording_->header());
  return fork ? base::Diagnostics() : fork.diagnostics();
}

bool SimulationRunner::branchFromShown(const app::RunSpec& changes, const QString& name) {
  if (!canBranchFromShown()) {
    return false;
  }
  const std::int64_t until = shown_->step;
  base::Result<BranchRequest> fork =
      branchRequestFor(recreate_(), until, changes, *recording_->header());
  if (!fork) {
    Q_EMIT warned(fork.diagnostics());
    return false;
  }
  RunnerBranch branch;
  branch.number = nextBranch_++;
  branch.name = name.isEmpty() ? tr("Branch %1").arg(branch.number) : name;
  branch.from = branch_;
  branch.branchTime = shown_->time;
  branch.changed = QString::fromStdString(app::changesText(changes));
  sim2d::RecordedInputs inputs = recording_->inputsUntil(until);
  Expected expected{until, {}};
  sim2d::appendTrajectoryRows(expected.rows, *shown_);
  pause();
  storeShownBranch();
  clearRun();
  branch_ = branch.number;
  branches_.push_back(std::move(branch));
  begin(std::move(fork->request), true, std::move(inputs), until, std::move(fork->moves));
  expected_ = std::move(expected);
  Q_EMIT branchesChanged();
  return true;
}

/// A re-run may diverge, for example with another program version or changed files.
void SimulationRunner::checkReplayDivergence() {
  if (!expected_ || newest_->step < expected_->step) {
    return;
  }
  const Expected expected = *std::exchange(expected_, std::nullopt);
  const FramePtr state = stateAt(recording_->indexAt(expected.step));
  std::string rows;
  if (state != nullptr && state->step == expected.step) {
    sim2d::appendTrajectoryRows(rows, *state);
    if (rows != expected.rows) {
      Q_EMIT warned({base::warning("again.branch-elsewhere", {state->time})});
    }
  }
}

void SimulationRunner::showBranch(int number) {
  const RunnerBranch* wanted = branchOf(number);
  if (wanted == nullptr || number == branch_) {
    return;
  }
  const double time = shown_ != nullptr ? shown_->time : 0.0;
  pause();
  storeShownBranch();
  const RunnerBranch kept = *wanted;
  clearRun();
  branch_ = number;
  showStoredBranch(kept, time);
  Q_EMIT branchesChanged();
}

void SimulationRunner::showStoredBranch(const RunnerBranch& kept, double time) {
  if (!kept.isFinished && kept.again) {
    const std::int64_t until = kept.newest != nullptr ? kept.newest->step : 0;
    begin(kept.again(), true,
          kept.recording != nullptr ? kept.recording->inputsUntil(until) : sim2d::RecordedInputs(),
          until);
    return;
  }
  recreate_ = kept.again;
  setScenarios(kept.scenarios);
  recording_ = kept.recording;
  newest_ = kept.newest;
  result_ = kept.result;
  isRecorded_ = kept.isRecorded;
  finished_ = true;
  setState(State::Paused);
  const FramePtr state = stateAt(recording_->indexAtTime(time));
  const bool isEnd = state == nullptr || time >= newest_->time;
  show(isEnd ? newest_ : state, !isEnd && !isRecorded_);
  checkHistoryLimit();
}

void SimulationRunner::renameBranch(int number, const QString& name) {
  RunnerBranch* const branch = branchOf(number);
  if (branch != nullptr && !name.trimmed().isEmpty() && branch->name != name.trimmed()) {
    branch->name = name.trimmed();
    Q_EMIT branchesChanged();
  }
}

void SimulationRunner::removeBranch(int number) {
  const RunnerBranch* const gone = branchOf(number);
  if (number == branch_ || gone == nullptr) {
    return;
  }
  const int parent = gone->from;
  for (RunnerBranch& each : branches_) {
    each.from = each.from == number ? parent : each.from;
  }
  branches_.erase(std::find_if(branches_.begin(), branches_.end(),
                               [&](const RunnerBranch& each) { return each.number == number; }));
  Q_EMIT branchesChanged();
}

}  // namespace editor
