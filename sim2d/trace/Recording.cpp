#include "sim2d/trace/Recording.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr std::size_t kChangesPerNode = 4;    // between key frames of the trees
constexpr std::size_t kFewestChanges = 1000;  // minimum

/// Applies the changes to all trees, or to that of one person.
void apply(const TreeChanges& changes, std::map<int, TreeStatuses>& trees,
           std::optional<int> only = std::nullopt) {
  int last = 0;
  TreeStatuses* tree = nullptr;
  changes.forEach([&](int id, const TreeChanges::Paths& paths, int node, base::NodeStatus status) {
    if (only && id != *only) {
      return;
    }
    if (tree == nullptr || id != last) {
      tree = &trees[id];
      last = id;
    }
    if (tree->paths != paths) {
      tree->paths = paths;
      tree->statuses.resize(paths->size(), base::NodeStatus::Idle);
    }
    tree->statuses[static_cast<std::size_t>(node)] = status;
  });
}

}  // namespace

Recording::Recording(int recordEvery, std::size_t mostInMemory, std::string folder)
    : recordEvery_(recordEvery), history_(mostInMemory, std::move(folder)) {}

Recording::~Recording() = default;

void Recording::append(const Frame& frame) {
  if (frame.treeChanges.size() > 0) {
    addTreeChanges(frame.step, frame.treeChanges);
  }
  for (const Input& input : frame.inputs) {
    addInput(frame.step, input);
  }
  std::vector<Event> events = frame.events;
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return std::tie(a.kind, a.id) < std::tie(b.kind, b.id);
  });
  for (Event& event : events) {
    addEvent(frame.step, std::move(event));
  }
  if (frame.step % recordEvery_ == 0) {  // last, so that readers find all data of the state
    addState(frame);
  }
}

void Recording::addState(const Frame& frame) {
  history_.append(frame);
  states_.append({frame.step, frame.time});
}

void Recording::addEvent(std::int64_t step, Event event) {
  events_.append({step, std::move(event)});
}

void Recording::addInput(std::int64_t step, Input input) {
  inputs_.append({step, std::move(input)});
}

void Recording::addTreeChanges(std::int64_t step, const TreeChanges& changes) {
  TreeStep entry{step, changes, nullptr};
  const std::size_t most = kFewestChanges + kChangesPerNode * nodes_;
  if (trees_.size() % kFewestChanges == 0 || changesSinceKey_ > most) {
    entry.before = std::make_shared<const TreeStates>(treesNow_);
    changesSinceKey_ = 0;
    nodes_ = 0;
    for (const auto& [id, tree] : treesNow_) {
      nodes_ += tree.statuses.size();
    }
  }
  changesSinceKey_ += changes.size();
  trees_.append(std::move(entry));
  apply(changes, treesNow_);
}

void Recording::setHeader(TraceHeader header) {
  header.recordEvery = recordEvery_;
  headers_.append(std::make_shared<const TraceHeader>(std::move(header)));
}

std::size_t Recording::indexAt(std::int64_t step) const {
  const std::size_t upTo = states_.count([step](const State& state) { return state.step <= step; });
  return upTo == 0 ? 0 : upTo - 1;
}

std::size_t Recording::indexAtTime(double time) const {
  constexpr double kLimit = 1e-9;  // tolerance of time comparisons
  const std::size_t upTo =
      states_.count([time](const State& state) { return state.time <= time + kLimit; });
  return upTo == 0 ? 0 : upTo - 1;
}

std::size_t Recording::first() const {
  const std::size_t states = size();  // one may be in progress
  return std::min(history_.first(), states == 0 ? 0 : states - 1);
}

FramePtr Recording::frame(std::size_t index) const {
  if (FramePtr frame = history_.frame(index)) {
    return frame;
  }
  auto emptyFrame = std::make_shared<Frame>();
  emptyFrame->step = states_[index].step;
  emptyFrame->time = states_[index].time;
  return emptyFrame;
}

RecordedInputs Recording::inputsUntil(std::int64_t step) const {
  RecordedInputs inputs;
  const std::size_t count = inputs_.size();  // one may be in progress
  for (std::size_t k = 0; k < count && inputs_[k].first <= step; ++k) {
    inputs.push_back(inputs_[k]);
  }
  return inputs;
}

std::shared_ptr<const TraceHeader> Recording::header() const {
  const std::size_t count = headers_.size();
  return count > 0 ? headers_[count - 1] : std::make_shared<const TraceHeader>();
}

TreeStatuses Recording::treeAt(int person, std::int64_t step) const {
  return treesAt(step, person)[person];
}

std::map<int, TreeStatuses> Recording::treesAt(std::int64_t step, std::optional<int> only) const {
  const std::size_t end = trees_.count([step](const TreeStep& each) { return each.step <= step; });
  if (end == 0) {
    return {};
  }
  std::size_t from = end - 1;
  while (!trees_[from].before) {
    --from;
  }
  TreeStates trees;
  const TreeStates& before = *trees_[from].before;
  if (!only) {
    trees = before;
  } else if (const auto found = before.find(*only); found != before.end()) {
    trees.insert(*found);
  }
  for (; from < end; ++from) {
    apply(trees_[from].changes, trees, only);
  }
  return trees;
}

Trace Recording::trace(TraceHeader header) const {
  Trace trace;
  trace.header = std::move(header);
  trace.header.recordEvery = recordEvery_;
  const std::size_t states = size();
  trace.frames.reserve(states);
  for (std::size_t k = first(); k < states; ++k) {
    trace.frames.push_back(*frame(k));
  }
  const std::size_t events = events_.size();
  for (std::size_t k = 0; k < events; ++k) {
    trace.events.push_back(events_[k]);
  }
  return trace;
}

std::string Recording::treesCsv() const {
  std::string rows = headerLine(kTreeColumns);
  const std::size_t steps = trees_.size();
  for (std::size_t k = 0; k < steps; ++k) {
    appendTreeRows(rows, trees_[k].step, trees_[k].changes);
  }
  return rows;
}

namespace fs = std::filesystem;

bool Truncation::has(std::string_view name) const {
  return std::find(files.begin(), files.end(), name) != files.end();
}

void Truncation::note(const std::string& name) {
  if (!has(name)) {
    files.push_back(name);
  }
}

std::size_t completeLinesSize(std::string_view text) {
  std::size_t whole = 0;
  bool isQuoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '"') {
      isQuoted = !isQuoted;
    } else if (text[k] == '\n' && !isQuoted) {
      whole = k + 1;
    }
  }
  return whole;
}

std::string finalOrTemporaryPath(const std::string& folder, const std::string& name) {
  const fs::path usual = fs::path(folder) / name;
  std::error_code error;
  if (fs::exists(usual, error)) {
    return usual.string();
  }
  const std::string stem = name + ".new-";
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (base::startsWith(at->path().filename().string(), stem)) {
      return at->path().string();
    }
  }
  return usual.string();
}

void dropIncompletePart(Trace& trace, bool lacksRobot, Truncation& cut) {
  constexpr const char* kTrajectory = "trajectory.csv";
  const bool hasStop = !trace.events.empty() && trace.events.back().second.kind == EventKind::Stop;
  const std::int64_t last = trace.frames.empty() ? -1 : trace.frames.back().step;
  if (hasStop) {
    const std::int64_t every = trace.header.recordEvery;
    const std::int64_t end = trace.events.back().first;
    cut.end = static_cast<double>(end) * trace.header.dt;
    if (!trace.header.robots.empty() && end / every * every > last) {
      cut.note(kTrajectory);
    }
  }
  if (lacksRobot) {
    cut.note(kTrajectory);
  }
  if (!cut.isTruncated()) {
    return;
  }
  if (cut.has(kTrajectory) && !trace.frames.empty()) {
    trace.frames.pop_back();  // bodies may be missing in it
  }
  cut.time = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const std::int64_t kept = trace.frames.empty() ? -1 : trace.frames.back().step;
  trace.events.erase(std::find_if(trace.events.begin(), trace.events.end(),
                                  [kept](const auto& each) { return each.first > kept; }),
                     trace.events.end());
}

}  // namespace sim2d
