#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/trace/FrameHistory.h"
#include "sim2d/trace/SharedLog.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

using StepEvent = std::pair<std::int64_t, Event>;  // with its step

/// Takes a run while it goes on: every step once, in rising order.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void append(const Frame& frame) = 0;
};

/// What the nodes of a person's tree returned last.
struct TreeStatuses {
  TreeChanges::Paths paths;                // of the nodes; null: nothing is known
  std::vector<base::NodeStatus> statuses;  // by number of the node
};

/// A run with access to any step: every `recordEvery`-th state, all events, inputs and tree
/// changes. One thread writes, others read what is there by then; what was read stays as it is. Of
/// states at most `mostInMemory` [B] are in memory and older ones in a temporary file; when the
/// disk takes no more, the oldest are dropped (`FrameHistory`). All else stays in memory, with 16
/// bytes per state to find it.
class Recording final : public FrameSink {
 public:
  static constexpr std::size_t kUsualMemory = std::size_t{256} << 20;  // [B]
  /// `folder`: of the temporary file; empty: the system's.
  explicit Recording(int recordEvery = 1, std::size_t mostInMemory = kUsualMemory,
                     std::string folder = {});
  ~Recording() override;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  // the writer; steps rise within frames, events and tree changes
  void append(const Frame& frame) override;  // its parts, as far as they are recorded
  void addState(const Frame& frame);
  void addEvent(std::int64_t step, Event event);
  void addInput(std::int64_t step, Input input);
  void addTreeChanges(std::int64_t step, const TreeChanges& changes);
  /// Before the first state with somebody who is not in the header so far.
  void setHeader(TraceHeader header);

  // readers
  std::size_t size() const { return states_.size(); }  // states, dropped ones too
  std::size_t first() const;                           // the oldest that is kept
  std::int64_t stepOf(std::size_t index) const { return states_[index].step; }
  double timeOf(std::size_t index) const { return states_[index].time; }  // [s]
  /// The last state at or before the step, else the first. There must be one.
  std::size_t indexAt(std::int64_t step) const;
  std::size_t indexAtTime(double time) const;
  /// Without events, inputs and tree changes. Of nobody when it was dropped, or the temporary file
  /// cannot be read.
  FramePtr frame(std::size_t index) const;
  /// The same, but null then.
  FramePtr frameIfKept(std::size_t index) const { return history_.frame(index); }
  const FrameHistory& history() const { return history_; }
  const SharedLog<StepEvent>& events() const { return events_; }
  const SharedLog<std::pair<std::int64_t, Input>>& inputs() const { return inputs_; }
  RecordedInputs inputsUntil(std::int64_t step) const;  // those that led to it too
  std::shared_ptr<const TraceHeader> header() const;    // the newest; never null
  /// What the nodes returned last at that step, recorded or not; of one person, or by id.
  TreeStatuses treeAt(int person, std::int64_t step) const;
  std::map<int, TreeStatuses> treesAt(std::int64_t step, std::optional<int> only = {}) const;

  // all of it; of states those that are kept
  Trace trace() const { return trace(*header()); }
  Trace trace(TraceHeader header) const;
  std::string treesCsv() const;

 private:
  struct State {
    std::int64_t step = 0;
    double time = 0.0;
  };
  using TreeStates = std::map<int, TreeStatuses>;
  struct TreeStep {
    std::int64_t step = 0;
    TreeChanges changes;
    std::shared_ptr<const TreeStates> before;  // now and then: where reading may begin
  };

  const int recordEvery_;
  SharedLog<State> states_;
  SharedLog<StepEvent> events_;
  SharedLog<std::pair<std::int64_t, Input>> inputs_;
  SharedLog<TreeStep> trees_;
  SharedLog<std::shared_ptr<const TraceHeader>> headers_;
  FrameHistory history_;
  // of the writer
  TreeStates treesNow_;
  std::size_t nodes_ = 0, changesSinceKey_ = 0;
};

/// With what the files of a run tell: no forces, no ways of the planners.
std::shared_ptr<Recording> recordingOf(Trace trace,
                                       std::size_t mostInMemory = Recording::kUsualMemory);
struct RecordCut;
/// A run folder, with trees.csv where there is one. All problems, with their places. `cut`: of a
/// record that is cut what is whole; null: it is refused.
base::Result<std::shared_ptr<const Recording>> readRecording(
    const std::string& directory, std::size_t mostInMemory = Recording::kUsualMemory,
    RecordCut* cut = nullptr);

}  // namespace sim2d
