#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/trace/SharedLog.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {

using FramePtr = std::shared_ptr<const Frame>;
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
/// changes. One thread writes, others read what is there by then without locks; what was read stays
/// as it is. States are kept packed; what is beyond `mostInMemory` lies in a temporary file.
class Recording final : public FrameSink {
 public:
  static constexpr std::size_t kUsualMemory = std::size_t{256} << 20;  // [B]
  explicit Recording(int recordEvery = 1, std::size_t mostInMemory = kUsualMemory);

  // the writer; steps rise within frames, events and tree changes
  void append(const Frame& frame) override;  // its parts, as far as they are recorded
  void addState(const Frame& frame);
  void addEvent(std::int64_t step, Event event) { events_.append({step, std::move(event)}); }
  void addInput(std::int64_t step, Input input) { inputs_.append({step, std::move(input)}); }
  void addTreeChanges(std::int64_t step, const TreeChanges& changes);
  /// Before the first state with somebody who is not in the header so far.
  void setHeader(TraceHeader header);

  // readers
  std::size_t size() const { return states_.size(); }  // states
  std::int64_t stepOf(std::size_t index) const { return states_[index].step; }
  double timeOf(std::size_t index) const { return states_[index].time; }  // [s]
  /// The last state at or before the step, else the first. There must be one.
  std::size_t indexAt(std::int64_t step) const;
  std::size_t indexAtTime(double time) const;
  /// Without events, inputs and tree changes. Of nobody when the temporary file cannot be read.
  FramePtr frame(std::size_t index) const;
  const SharedLog<StepEvent>& events() const { return events_; }
  const SharedLog<std::pair<std::int64_t, Input>>& inputs() const { return inputs_; }
  std::shared_ptr<const TraceHeader> header() const;  // the newest; never null
  /// What the nodes returned last at that step, recorded or not; of one person, or by id.
  TreeStatuses treeAt(int person, std::int64_t step) const { return treesAt(step, person)[person]; }
  std::map<int, TreeStatuses> treesAt(std::int64_t step, std::optional<int> only = {}) const;

  // all of it
  Trace trace() const { return trace(*header()); }
  Trace trace(TraceHeader header) const;
  std::string treesCsv() const;

 private:
  struct State {
    std::int64_t step = 0;
    double time = 0.0;
    std::string bytes;  // empty: in the file
    base::ScratchFile::Piece piece;
  };
  using TreeStates = std::map<int, TreeStatuses>;
  struct TreeStep {
    std::int64_t step = 0;
    TreeChanges changes;
    std::shared_ptr<const TreeStates> before;  // now and then: where reading may begin
  };
  Frame unpack(std::size_t index, const Frame& key) const;

  const int recordEvery_;
  SharedLog<State> states_;
  SharedLog<StepEvent> events_;
  SharedLog<std::pair<std::int64_t, Input>> inputs_;
  SharedLog<TreeStep> trees_;
  SharedLog<std::shared_ptr<const TraceHeader>> headers_;
  base::ScratchFile file_;
  // of the writer
  std::size_t memoryLeft_;
  Frame key_;
  TreeStates treesNow_;
  std::size_t nodes_ = 0, changesSinceKey_ = 0;
};

/// With what the files of a run tell: no forces, no ways of the planners.
std::shared_ptr<Recording> recordingOf(Trace trace);
/// A run folder, with trees.csv where there is one. All problems, with their places.
base::Result<std::shared_ptr<const Recording>> readRecording(const std::string& directory);

}  // namespace sim2d
