#include "sim2d/trace/Recording.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace sim2d {
namespace {

constexpr char kEqual = 0, kOther = 1;

class Packer {
 public:
  template <class T>
  void value(const T& value) {
    bytes(&value, sizeof(T));
  }
  template <class T>
  void column(const std::vector<T>& column, const std::vector<T>& key) {
    const std::size_t size = column.size() * sizeof(T);
    if (column.size() == key.size() &&
        (size == 0 ||
         std::memcmp(static_cast<const void*>(column.data()), key.data(), size) == 0)) {
      value(kEqual);
      return;
    }
    value(kOther);
    value(column.size());
    bytes(column.data(), size);
  }
  std::size_t sizeOf(const std::vector<std::vector<Vec2>>& paths) {
    value(paths.size());
    return paths.size();
  }
  std::string take() { return std::move(bytes_); }

 private:
  void bytes(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  void value(T& value) {
    bytes(&value, sizeof(T));
  }
  template <class T>
  void column(std::vector<T>& column, const std::vector<T>& key) {
    char kind = kEqual;
    value(kind);
    if (kind == kEqual) {
      column = key;
      return;
    }
    std::size_t size = 0;
    value(size);
    column.resize(size);
    bytes(column.data(), size * sizeof(T));
  }
  std::size_t sizeOf(std::vector<std::vector<Vec2>>& paths) {
    std::size_t size = 0;
    value(size);
    paths.resize(size);
    return size;
  }

 private:
  void bytes(void* to, std::size_t size) {
    if (size > 0) {
      std::memcpy(to, bytes_.data(), size);
      bytes_.remove_prefix(size);
    }
  }
  std::string_view bytes_;
};

/// The state of a frame (no events, inputs and tree changes) to or from bytes: its columns, those
/// left out that equal the key's bit by bit. For this process only: no format of files.
template <class AnyPacker, class AnyFrame>
void pass(AnyPacker& packer, AnyFrame& frame, const Frame& key) {
  packer.value(frame.step);
  packer.value(frame.time);
  const auto body = [&packer](auto& columns, const BodyColumns& keys) {
    packer.column(columns.id, keys.id);
    packer.column(columns.x, keys.x);
    packer.column(columns.y, keys.y);
    packer.column(columns.heading, keys.heading);
    packer.column(columns.vx, keys.vx);
    packer.column(columns.vy, keys.vy);
    packer.column(columns.omega, keys.omega);
    packer.column(columns.goal, keys.goal);
  };
  body(frame.humans, key.humans);
  body(frame.robots, key.robots);
  packer.column(frame.humans.group, key.humans.group);
  packer.column(frame.humans.state, key.humans.state);
  packer.column(frame.forces.goal, key.forces.goal);
  packer.column(frame.forces.social, key.forces.social);
  packer.column(frame.forces.obstacle, key.forces.obstacle);
  packer.column(frame.forces.group, key.forces.group);
  packer.column(frame.doorOpen, key.doorOpen);
  static const std::vector<Vec2> kNoPath;
  const std::size_t paths = packer.sizeOf(frame.robotPaths);
  for (std::size_t k = 0; k < paths; ++k) {
    packer.column(frame.robotPaths[k], k < key.robotPaths.size() ? key.robotPaths[k] : kNoPath);
  }
}

std::string packFrame(const Frame& frame, const Frame& key) {
  Packer packer;
  pass(packer, frame, key);
  return packer.take();
}

Frame unpackFrame(std::string_view bytes, const Frame& key) {
  Frame frame;
  Unpacker unpacker(bytes);
  pass(unpacker, frame, key);
  return frame;
}

constexpr std::size_t kKeyEvery = 64;         // states
constexpr std::size_t kChangesPerNode = 4;    // between two keys of the trees
constexpr std::size_t kFewestChanges = 1000;  // idem

/// To all trees, or to that of one person.
void apply(const TreeChanges& changes, std::map<int, TreeState>& trees,
           std::optional<int> only = std::nullopt) {
  int last = 0;
  TreeState* tree = nullptr;
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

Recording::Recording(int recordEvery, std::size_t mostInMemory)
    : recordEvery_(recordEvery), memoryLeft_(mostInMemory) {}

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
  if (frame.step % recordEvery_ == 0) {  // last: who reads it finds what belongs to it
    addState(frame);
  }
}

void Recording::addState(const Frame& frame) {
  const bool isKey = states_.size() % kKeyEvery == 0;
  State state{frame.step, frame.time, packFrame(frame, isKey ? Frame() : key_), {}};
  if (isKey) {
    key_ = frame;
  }
  if (state.bytes.size() > memoryLeft_) {
    if (const auto piece = file_.append(state.bytes)) {
      state.piece = *piece;
      state.bytes = std::string();
    }
  }
  memoryLeft_ -= std::min(memoryLeft_, state.bytes.size());
  states_.append(std::move(state));
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
  constexpr double kLimit = 1e-9;  // times are reached this much early
  const std::size_t upTo =
      states_.count([time](const State& state) { return state.time <= time + kLimit; });
  return upTo == 0 ? 0 : upTo - 1;
}

Frame Recording::unpack(std::size_t index, const Frame& key) const {
  const State& state = states_[index];
  if (!state.bytes.empty()) {
    return unpackFrame(state.bytes, key);
  }
  if (const std::optional<std::string> bytes = file_.read(state.piece)) {
    return unpackFrame(*bytes, key);
  }
  Frame nobody;
  nobody.step = state.step;
  nobody.time = state.time;
  return nobody;
}

FramePtr Recording::frame(std::size_t index) const {
  const std::size_t keyIndex = index - index % kKeyEvery;
  Frame key = unpack(keyIndex, Frame());
  return std::make_shared<const Frame>(index == keyIndex ? std::move(key) : unpack(index, key));
}

std::shared_ptr<const TraceHeader> Recording::header() const {
  const std::size_t count = headers_.size();
  return count > 0 ? headers_[count - 1] : std::make_shared<const TraceHeader>();
}

TreeState Recording::treeAt(int person, std::int64_t step) const {
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
  if (const auto found = before.find(person); found != before.end()) {
    trees.insert(*found);
  }
  for (; from < end; ++from) {
    apply(trees_[from].changes, trees, person);
  }
  return trees[person];
}

Trace Recording::trace(TraceHeader header) const {
  Trace trace;
  trace.header = std::move(header);
  trace.header.recordEvery = recordEvery_;
  const std::size_t states = size();
  Frame key;
  for (std::size_t k = 0; k < states; ++k) {
    const bool isKey = k % kKeyEvery == 0;
    trace.frames.push_back(unpack(k, isKey ? Frame() : key));
    key = isKey ? trace.frames.back() : std::move(key);
  }
  const std::size_t events = events_.size();
  for (std::size_t k = 0; k < events; ++k) {
    trace.events.push_back(events_[k]);
  }
  return trace;
}

std::string Recording::treesCsv() const {
  std::string rows = headLine(kTreeColumns);
  const std::size_t steps = trees_.size();
  for (std::size_t k = 0; k < steps; ++k) {
    appendTreeRows(rows, trees_[k].step, trees_[k].changes);
  }
  return rows;
}

}  // namespace sim2d
