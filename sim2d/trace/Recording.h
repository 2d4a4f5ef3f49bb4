#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/trace/FrameHistory.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

/// Append-only list for one writer and any number of readers, without locks: entries never move or
/// change.
template <class T>
class AppendOnlyLog {
 public:
  void append(T entry) {
    const std::size_t index = size_.load(std::memory_order_relaxed);
    const auto [block, place] = placeOf(index);
    if (!blocks_[block]) {
      blocks_[block] = std::make_unique<T[]>(kFirstBlock << block);
    }
    blocks_[block][place] = std::move(entry);
    size_.store(index + 1, std::memory_order_release);
  }
  std::size_t size() const { return size_.load(std::memory_order_acquire); }
  /// `index` must be below a size() that this thread has read.
  const T& operator[](std::size_t index) const {
    const auto [block, place] = placeOf(index);
    return blocks_[block][place];
  }
  /// Number of leading entries that satisfy `isBefore`; it must hold for a prefix of the list only.
  template <class IsBefore>
  std::size_t count(IsBefore isBefore) const {
    std::size_t from = 0, to = size();
    while (from < to) {
      const std::size_t middle = from + (to - from) / 2;
      (isBefore((*this)[middle]) ? from : to) = isBefore((*this)[middle]) ? middle + 1 : middle;
    }
    return from;
  }

 private:
  static constexpr std::size_t kFirstBlock = 64, kBlocks = 48;  // block sizes double
  static std::pair<std::size_t, std::size_t> placeOf(std::size_t index) {
    std::size_t block = 0;
    for (; index >= kFirstBlock << block; ++block) {
      index -= kFirstBlock << block;
    }
    return {block, index};
  }

  std::array<std::unique_ptr<T[]>, kBlocks> blocks_;
  std::atomic<std::size_t> size_{0};
};

using StepEvent = std::pair<std::int64_t, Event>;  // step and event

/// Receives the frames of a run: each step once, in order.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  virtual void append(const Frame& frame) = 0;
};

/// The latest status of each node of a person's tree.
struct TreeStatuses {
  TreeChanges::Paths paths;                // node paths; null: no data
  std::vector<base::NodeStatus> statuses;  // by node number
};

/// A run with random access: every `recordEvery`-th state, all events, inputs and tree changes. One
/// thread writes, others read what is complete; data that was read never changes. At most
/// `mostInMemory` [B] of states are in memory, older ones in a temporary file; when the disk is
/// full, the oldest are dropped (`FrameHistory`). All other data stays in memory, with 16 bytes per
/// state as index.
class Recording final : public FrameSink {
 public:
  static constexpr std::size_t kDefaultMemory = std::size_t{256} << 20;  // [B]
  /// `folder`: of the temporary file; empty: the system's default.
  explicit Recording(int recordEvery = 1, std::size_t mostInMemory = kDefaultMemory,
                     std::string folder = {});
  ~Recording() override;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;

  // for the writer; steps increase for states, events and tree changes
  void append(const Frame& frame) override;  // records the parts of a frame
  void addState(const Frame& frame);
  void addEvent(std::int64_t step, Event event);
  void addInput(std::int64_t step, Input input);
  void addTreeChanges(std::int64_t step, const TreeChanges& changes);
  /// Call before the first state with an agent that the previous header lacks.
  void setHeader(TraceHeader header);

  // for readers
  std::size_t size() const { return states_.size(); }  // including dropped ones
  std::size_t first() const;                           // oldest state kept
  std::int64_t stepOf(std::size_t index) const { return states_[index].step; }
  double timeOf(std::size_t index) const { return states_[index].time; }  // [s]
  /// The last state at or before the step, else the first. The recording must not be empty.
  std::size_t indexAt(std::int64_t step) const;
  std::size_t indexAtTime(double time) const;
  /// Without events, inputs and tree changes. An empty state if it was dropped or cannot be read.
  FramePtr frame(std::size_t index) const;
  /// The same, but null instead of an empty state.
  FramePtr frameIfKept(std::size_t index) const { return history_.frame(index); }
  const FrameHistory& history() const { return history_; }
  const AppendOnlyLog<StepEvent>& events() const { return events_; }
  const AppendOnlyLog<std::pair<std::int64_t, Input>>& inputs() const { return inputs_; }
  RecordedInputs inputsUntil(std::int64_t step) const;  // including those of `step`
  std::shared_ptr<const TraceHeader> header() const;    // the latest; never null
  /// Node statuses at a step, which need not be recorded; of one person, or by id.
  TreeStatuses treeAt(int person, std::int64_t step) const;
  std::map<int, TreeStatuses> treesAt(std::int64_t step, std::optional<int> only = {}) const;

  // Complete data; states as far as they are kept.
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
    std::shared_ptr<const TreeStates> before;  // key frame: reading may start here
  };

  const int recordEvery_;
  AppendOnlyLog<State> states_;
  AppendOnlyLog<StepEvent> events_;
  AppendOnlyLog<std::pair<std::int64_t, Input>> inputs_;
  AppendOnlyLog<TreeStep> trees_;
  AppendOnlyLog<std::shared_ptr<const TraceHeader>> headers_;
  FrameHistory history_;
  // used by the writer only
  TreeStates treesNow_;
  std::size_t nodes_ = 0, changesSinceKey_ = 0;
};

/// Data of the run's files: no forces, no planner paths.
std::shared_ptr<Recording> recordingOf(Trace trace,
                                       std::size_t mostInMemory = Recording::kDefaultMemory);
/// Describes an incomplete recording: the run was killed, a copy was interrupted, or the disk was
/// full.
struct Truncation {
  std::vector<std::string> files;  // names of the truncated files; none: complete
  double time = 0.0;               // of the last complete state [s]
  std::optional<double> end;       // end of the run, if an event states it [s]

  /// Set by the caller for a killed run: its header was written at the start and lacks agents that
  /// were spawned later; they are added when their rows are read.
  bool isUnfinished = false;

  bool isTruncated() const { return !files.empty(); }
  bool has(std::string_view name) const;
  void note(const std::string& name);
};

/// Length of the complete lines of a CSV text [bytes]; line ends inside quotes do not count.
std::size_t completeLinesSize(std::string_view text);

/// The path of a file of a recording, or of the temporary file of a killed process
/// (`base::AtomicFileWriter`); the regular path if neither exists.
std::string finalOrTemporaryPath(const std::string& folder, const std::string& name);

/// Removes incomplete data: the last state if the trajectory is truncated inside it, and events
/// after the last state. `lacksRobot`: a robot is missing in the last state.
void dropIncompletePart(Trace& trace, bool lacksRobot, Truncation& cut);

/// Reads the complete part of trajectory.csv, events.csv and trace.json in a folder.
base::Result<Trace> readTruncatedTrace(const std::string& directory, Truncation& cut);

/// Reads a run folder, with trees.csv and inputs.csv if they exist; reports all problems with their
/// places. `cut`: reads the complete part of a truncated recording; null: truncation is an error.
base::Result<std::shared_ptr<const Recording>> readRecording(
    const std::string& directory, std::size_t mostInMemory = Recording::kDefaultMemory,
    Truncation* cut = nullptr);

}  // namespace sim2d
