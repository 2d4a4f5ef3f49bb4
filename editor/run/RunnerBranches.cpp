#include <algorithm>
#include <utility>

#include "editor/run/SimulationRunner.h"

// The part of SimulationRunner that plays parts and keeps branches.
namespace editor {

void SimulationRunner::setLoop(std::optional<Part> loop) {
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

bool SimulationRunner::canLoop() const {
  return loop_ && recording_ != nullptr && newest_ != nullptr && shown_ != nullptr &&
         loop_->from < newest_->time;
}

bool SimulationRunner::canGoOnFromShown() const {
  return again_ && shown_ != nullptr && (lookingBack_ || isRecorded_) &&
         branches_.size() < kMostBranches;
}

/// Of the runs beside the first each has a part of its memory, all of them together as much.
std::size_t SimulationRunner::historyOfNext() const {
  return branch_ <= 0 ? historyMemory_ : historyMemory_ / (kMostBranches - 1);
}

RunBranch* SimulationRunner::branchOf(int number) {
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const RunBranch& each) { return each.number == number; });
  return found == branches_.end() ? nullptr : &*found;
}

RecordingPtr SimulationRunner::recordingOf(int branch) const {
  if (branch == branch_) {
    return recording_;
  }
  const auto found = std::find_if(branches_.begin(), branches_.end(),
                                  [&](const RunBranch& each) { return each.number == branch; });
  return found == branches_.end() ? nullptr : found->recording;
}

/// What it takes to show this run again.
void SimulationRunner::keepShown() {
  RunBranch& kept = *branchOf(branch_);
  kept.recording = recording_;
  kept.newest = newest_;
  kept.isFinished = finished_;
  kept.isRecorded = isRecorded_;
  kept.result = result_;
  kept.again = again_;
}

bool SimulationRunner::goOnFromShown(const app::RunOptions& changes, const QString& name) {
  if (!canGoOnFromShown()) {
    return false;
  }
  const std::int64_t until = shown_->step;
  base::Result<Fork> fork = forkOf(again_(), until, changes, *recording_->header());
  if (!fork) {
    Q_EMIT warned(fork.diagnostics());
    return false;
  }
  RunBranch branch;
  branch.number = nextBranch_++;
  branch.name = name.isEmpty() ? tr("Branch %1").arg(branch.number) : name;
  branch.from = branch_;
  branch.leftAt = shown_->time;
  branch.changed = QString::fromStdString(app::changesText(changes));
  sim2d::RecordedInputs inputs = recording_->inputsUntil(until);
  Expected expected{until, {}};
  sim2d::appendTrajectoryRows(expected.rows, *shown_);
  pause();
  keepShown();
  leaveRun();
  branch_ = branch.number;
  branches_.push_back(std::move(branch));
  begin(std::move(fork->request), true, std::move(inputs), until, std::move(fork->moves));
  expected_ = std::move(expected);
  Q_EMIT branchesChanged();
  return true;
}

/// Another program, or files that have changed since, may make another run of it.
void SimulationRunner::watchRepeated() {
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
  const RunBranch* wanted = branchOf(number);
  if (wanted == nullptr || number == branch_) {
    return;
  }
  const double time = shown_ != nullptr ? shown_->time : 0.0;
  pause();
  keepShown();
  const RunBranch kept = *wanted;
  leaveRun();
  branch_ = number;
  showKept(kept, time);
  Q_EMIT branchesChanged();
}

void SimulationRunner::showKept(const RunBranch& kept, double time) {
  if (!kept.isFinished && kept.again) {
    const std::int64_t until = kept.newest != nullptr ? kept.newest->step : 0;
    begin(kept.again(), true,
          kept.recording != nullptr ? kept.recording->inputsUntil(until) : sim2d::RecordedInputs(),
          until);
    return;
  }
  again_ = kept.again;
  recording_ = kept.recording;
  newest_ = kept.newest;
  result_ = kept.result;
  isRecorded_ = kept.isRecorded;
  finished_ = true;
  setState(State::Paused);
  const FramePtr state = stateAt(recording_->indexAtTime(time));
  const bool isEnd = state == nullptr || time >= newest_->time;
  show(isEnd ? newest_ : state, !isEnd && !isRecorded_);
  watchHistory();
}

void SimulationRunner::renameBranch(int number, const QString& name) {
  RunBranch* const branch = branchOf(number);
  if (branch != nullptr && !name.trimmed().isEmpty() && branch->name != name.trimmed()) {
    branch->name = name.trimmed();
    Q_EMIT branchesChanged();
  }
}

void SimulationRunner::removeBranch(int number) {
  const RunBranch* const gone = branchOf(number);
  if (number == branch_ || gone == nullptr) {
    return;
  }
  const int parent = gone->from;
  for (RunBranch& each : branches_) {
    each.from = each.from == number ? parent : each.from;
  }
  branches_.erase(std::find_if(branches_.begin(), branches_.end(),
                               [&](const RunBranch& each) { return each.number == number; }));
  Q_EMIT branchesChanged();
}

}  // namespace editor
