#include "sim2d/trace/Recorder.h"

#include <algorithm>
#include <utility>

#include "sim2d/trace/TraceRows.h"

namespace sim2d {

Recorder::Recorder(int recordEvery, RecordSink* sink)
    : recordEvery_(recordEvery), sink_(sink), treesCsv_(treesHead()) {}

void Recorder::append(const Frame& frame) {
  if (finished_) {
    treesCsv_ = treesHead();
    finished_ = false;
  }
  RecordedStep step;
  step.step = frame.step;
  step.frame = frame.step % recordEvery_ == 0 ? &frame : nullptr;
  step.events = frame.events;
  std::stable_sort(step.events.begin(), step.events.end(), [](const Event& a, const Event& b) {
    return std::tie(a.kind, a.id) < std::tie(b.kind, b.id);
  });
  frame.treeChanges.forEach([&](int id, const TreeChanges::Paths& paths, int node,
                                base::NodeStatus status) {
    appendTreeRow(step.treeRows, frame.step, id, paths->at(static_cast<std::size_t>(node)), status);
  });
  if (sink_ != nullptr) {
    sink_->take(step);
  } else {
    keep(std::move(step));
  }
}

void Recorder::keep(RecordedStep step) {
  treesCsv_ += step.treeRows;
  for (Event& event : step.events) {
    trace_.events.emplace_back(step.step, std::move(event));
  }
  if (step.frame != nullptr) {
    trace_.frames.push_back(*step.frame);
    trace_.frames.back().events.clear();
    trace_.frames.back().treeChanges.clear();
  }
}

Trace Recorder::finish(TraceHeader header) {
  trace_.header = std::move(header);
  trace_.header.recordEvery = recordEvery_;
  finished_ = true;
  return std::exchange(trace_, Trace{});
}

}  // namespace sim2d
