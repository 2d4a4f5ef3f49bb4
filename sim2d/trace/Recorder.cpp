#include "sim2d/trace/Recorder.h"

#include <algorithm>
#include <utility>

#include "sim2d/trace/Csv.h"

namespace sim2d {

namespace {

const char kTreesHeader[] = "step,id,node,status\n";

void appendTreeChange(std::string& to, std::int64_t step, const TreeChange& change) {
  to += std::to_string(step);
  to += ',';
  to += std::to_string(change.id);
  to += ',';
  appendCsvField(to, change.paths->at(static_cast<std::size_t>(change.node)));
  to += ',';
  to += base::nodeStatusName(change.status);
  to += '\n';
}

}  // namespace

Recorder::Recorder(int recordEvery) : recordEvery_(recordEvery), treesCsv_(kTreesHeader) {}

void Recorder::append(const Frame& frame) {
  if (finished_) {
    treesCsv_ = kTreesHeader;
    finished_ = false;
  }
  const std::size_t first = trace_.events.size();
  for (const Event& event : frame.events) {
    trace_.events.emplace_back(frame.step, event);
  }
  std::stable_sort(trace_.events.begin() + static_cast<std::ptrdiff_t>(first), trace_.events.end(),
                   [](const auto& a, const auto& b) {
                     return std::tie(a.second.kind, a.second.id) <
                            std::tie(b.second.kind, b.second.id);
                   });
  for (const TreeChange& change : frame.treeChanges) {
    appendTreeChange(treesCsv_, frame.step, change);
  }
  if (frame.step % recordEvery_ != 0) {
    return;
  }
  trace_.frames.push_back(frame);
  trace_.frames.back().events.clear();
  trace_.frames.back().treeChanges.clear();
}

Trace Recorder::finish(TraceHeader header) {
  trace_.header = std::move(header);
  trace_.header.recordEvery = recordEvery_;
  finished_ = true;
  return std::exchange(trace_, Trace{});
}

}  // namespace sim2d
