#include "app/run/RunReplay.h"

#include <cmath>
#include <limits>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/RecordedRun.h"

namespace app {

base::Result<std::unique_ptr<RunReplay>> RunReplay::prepare(const RunSpec& spec,
                                                            const sim2d::ImageLoader& loader,
                                                            const base::StopFlagPtr& stop) {
  std::unique_ptr<RunReplay> replay(new RunReplay());
  replay->moment_ = *runMomentOf(spec.from);
  const base::Diagnostics wrong = replay->readRecord();
  if (base::hasErrors(wrong)) {
    return wrong;
  }
  base::Result<RunProvenance> made = provenanceOf(replay->moment_.folder, loader);
  if (!made) {
    return made.diagnostics();
  }
  replay->version_ = made->version;
  replay->folders_ = made->folders;
  made->bundle.stopOfRun = stop;
  made->bundle.settings.threads = spec.threads;
  made->bundle.settings.code =
      spec.allowCode ? sim2d::ExternalCodePolicy::Allowed : sim2d::ExternalCodePolicy::Refused;
  made->branches.push_back({replay->from_, spec});
  replay->run_ = std::make_unique<BranchedRun>(std::move(made->bundle), made->branches);
  if (replay->verdict().ok()) {
    base::Result<sim2d::StepInputs> moves =
        inputsOfMoves(spec.moves, replay->header(), replay->moment_.folder);
    if (!moves) {
      return moves.diagnostics();
    }
    replay->moves_ = *std::move(moves);
  }
  return replay;
}

base::Diagnostics RunReplay::readRecord() {
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
  from_ = std::llround(moment_.time / dt);
  inputs_ = recording_->inputsUntil(std::numeric_limits<std::int64_t>::max());
  return {};
}

/// Compares what the files of a run contain of a state.
bool RunReplay::isAsRecorded(const sim2d::Frame& frame) const {
  const std::size_t index = recording_->indexAt(frame.step);
  if (recording_->stepOf(index) != frame.step) {
    return true;  // not every step is recorded
  }
  std::string now, then;
  sim2d::appendTrajectoryRows(now, frame);
  sim2d::appendTrajectoryRows(then, *recording_->frame(index));
  return now == then;
}

void RunReplay::observe(const sim2d::Frame& frame, sim2d::World& world, Session& session) {
  if (frame.step <= from_ && !divergedAt_ && !isAsRecorded(frame)) {
    divergedAt_ = frame.time;
    session.stop();
    return;
  }
  run_->apply(frame, world);
  for (sim2d::Input& input : inputsOf(inputs_, frame.step + 1)) {
    session.add(std::move(input));
  }
  if (frame.step == from_) {
    for (const sim2d::Input& move : moves_) {
      session.add(move);
    }
  }
}

base::Diagnostics RunReplay::problems(const sim2d::RunResult& result) const {
  if (divergedAt_) {
    return {base::error("again.goes-elsewhere", {*divergedAt_, version_, programVersion()},
                        moment_.folder)};
  }
  if (result.steps < from_ && result.status != sim2d::RunStatus::Interrupted) {
    return {base::error("again.ends-before",
                        {static_cast<double>(result.steps) * run_->header().dt, moment_.time},
                        moment_.folder)};
  }
  return {};
}

}  // namespace app
