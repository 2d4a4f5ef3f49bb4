#include "app/run/RunAgain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/RecordedRun.h"
#include "app/run/Sha256.h"

namespace app {

namespace {

std::int64_t stepAt(double time, double dt) {
  return std::llround(time / dt);
}

/// Those --set of the last stage that change what stays as it is; `was`: the stage before.
base::Diagnostics fixedWords(const RunOptions& was, const RunOptions& is, const Bundle& before,
                             const RunSettings& settings, KnownFiles& files) {
  base::Diagnostics problems;
  for (const std::string& word : is.then.back().set) {
    RunOptions one = was;
    one.then.emplace_back().set = {word};
    const Bundle bundle = readBundle(one, settings, files);
    if (!base::hasErrors(bundle.wrongWords) && !canGoOnAs(*before.scenario, *bundle.scenario)) {
      problems.push_back(base::error("again.fixed", {word}, before.path));
    }
  }
  if (problems.empty()) {  // none by itself
    problems.push_back(base::error("again.fixed-things", {}, before.path));
  }
  return problems;
}

}  // namespace

base::Diagnostics changedInputs(const Bundle& bundle, const std::vector<std::string>& hashes,
                                const std::string& folder) {
  const std::vector<std::string> paths = inputsOf(bundle);
  base::Diagnostics problems;
  for (std::size_t k = 0; k < std::min(paths.size(), hashes.size()); ++k) {
    if (sha256OfFile(paths[k]) != hashes[k]) {
      problems.push_back(base::error("again.input-changed", {}, paths[k]));
    }
  }
  if (problems.empty() && paths.size() != hashes.size()) {
    problems.push_back(base::error("again.other-inputs", {hashes.size(), paths.size()}, folder));
  }
  return problems;
}

base::Result<std::unique_ptr<RunAgain>> RunAgain::prepare(const RunOptions& options,
                                                          const RunWordsReader& readWords,
                                                          const sim2d::ImageLoader& loader,
                                                          const base::StopFlagPtr& left) {
  std::unique_ptr<RunAgain> again(new RunAgain());
  again->moment_ = *runMomentOf(options.from);
  base::Diagnostics problems = again->readRecord();
  if (base::hasErrors(problems)) {
    return problems;
  }
  const base::Result<std::vector<RunStage>> stages = stagesOf(options, readWords);
  if (!stages) {
    return stages.diagnostics();
  }
  again->madeBy_ = (*stages)[stages->size() - 2].version;
  for (std::size_t k = 0; k + 1 < stages->size(); ++k) {
    again->folders_.push_back((*stages)[k].folder);
  }
  base::append(problems, again->makeWorlds(*stages, loader, left));
  if (!base::hasErrors(problems) && again->verdict_.ok()) {
    base::append(problems, again->addMoves(options.moves));
  }
  return base::hasErrors(problems)
             ? base::Result<std::unique_ptr<RunAgain>>(std::move(problems))
             : base::Result<std::unique_ptr<RunAgain>>(std::move(again), std::move(problems));
}

base::Diagnostics RunAgain::readRecord() {
  const base::Result<RecordedRun> run = readRecordedRun(moment_.folder);
  if (!run) {
    return run.diagnostics();
  }
  recording_ = run->recording;
  const double dt = recording_->header()->dt;
  const double end = recording_->timeOf(recording_->size() - 1);
  if (moment_.time > end + 0.5 * dt) {
    return {base::error("again.no-such-time", {end, moment_.time}, moment_.folder)};
  }
  from_ = stepAt(moment_.time, dt);
  inputs_ = recording_->inputsUntil(std::numeric_limits<std::int64_t>::max());
  return {};
}

base::Diagnostics RunAgain::makeWorlds(const std::vector<RunStage>& stages,
                                       const sim2d::ImageLoader& loader,
                                       const base::StopFlagPtr& left) {
  KnownFiles files(loader);
  std::unique_ptr<sim2d::World> first;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const RunStage& stage = stages[k];
    const base::Result<RunSettings> settings = runSettingsOf(stage.options);
    if (!settings) {
      return settings.diagnostics();
    }
    const Bundle before = std::exchange(bundle_, readBundle(stage.options, *settings, files));
    bundle_.left = left;
    base::Diagnostics problems;
    if (!stage.inputs.empty()) {
      problems = changedInputs(bundle_, stage.inputs, moment_.folder);
    }
    const bool isRead = problems.empty() && !base::hasErrors(bundle_.wrongWords);
    if (isRead && k > 0 && !canGoOnAs(*before.scenario, *bundle_.scenario)) {
      problems = fixedWords(stages[k - 1].options, stage.options, before, *settings, files);
    }
    verdict_ = problems.empty() ? check(bundle_) : Verdict();
    if (!problems.empty() || !verdict_.ok()) {
      return problems;
    }
    header_ = verdict_.world->header();
    if (k == 0) {
      seed_ = static_cast<std::uint64_t>(header_.seed);
      first = std::move(verdict_.world);
    } else {
      seed_ = static_cast<std::uint64_t>(stage.drawSeed.value_or(static_cast<long long>(seed_)));
      changes_.push_back(
          {stepAt(stage.moment->time, header_.dt), std::move(verdict_.world), seed_});
    }
  }
  verdict_.world = std::move(first);
  return {};
}

base::Diagnostics RunAgain::addMoves(const std::vector<std::string>& words) {
  base::Diagnostics problems;
  for (const std::string& word : words) {
    const PersonMove move = *personMoveOf(word);
    const auto person =
        std::find_if(header_.humans.begin(), header_.humans.end(),
                     [&](const sim2d::TraceHuman& human) { return human.name == move.name; });
    if (person == header_.humans.end()) {
      problems.push_back(base::error("again.move-of-nobody", {move.name}, moment_.folder));
      continue;
    }
    sim2d::Input input;
    input.kind = sim2d::InputKind::Move;
    input.id = person->id;
    input.pose = move.pose;
    moves_.push_back(std::move(input));
  }
  return problems;
}

/// By what the files tell of a state.
bool RunAgain::isAsRecorded(const sim2d::Frame& frame) const {
  const std::size_t index = recording_->indexAt(frame.step);
  if (recording_->stepOf(index) != frame.step) {
    return true;  // not every step is recorded
  }
  std::string now, then;
  sim2d::appendTrajectoryRows(now, frame);
  sim2d::appendTrajectoryRows(then, *recording_->frame(index));
  return now == then;
}

void RunAgain::look(const sim2d::Frame& frame, sim2d::World& world, Session& session) {
  if (frame.step <= from_ && !goesElsewhere_ && !isAsRecorded(frame)) {
    goesElsewhere_ = frame.time;
    session.stop();
    return;
  }
  for (Change& change : changes_) {
    if (change.step == frame.step) {
      world.goOnAs(*change.as, change.seed);
    }
  }
  for (sim2d::Input& input : inputsOf(inputs_, frame.step + 1)) {
    session.add(std::move(input));
  }
  if (frame.step == from_) {
    for (const sim2d::Input& move : moves_) {
      session.add(move);
    }
  }
}

base::Diagnostics RunAgain::trouble(const sim2d::RunResult& result) const {
  if (goesElsewhere_) {
    return {base::error("again.goes-elsewhere", {*goesElsewhere_, madeBy_, programVersion()},
                        moment_.folder)};
  }
  if (result.steps < from_ && result.status != sim2d::RunStatus::Interrupted) {
    return {base::error("again.ends-before",
                        {static_cast<double>(result.steps) * header_.dt, moment_.time},
                        moment_.folder)};
  }
  return {};
}

}  // namespace app
