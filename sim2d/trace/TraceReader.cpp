#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Recording.h"

namespace sim2d {

namespace {

constexpr std::int64_t kMaxEmpty = 1000000;  // states without rows

struct Row {
  std::int64_t step = 0;
  double time = 0.0;
  int id = 0;
  bool isRobot = false;
  base::Pose2 pose;
  Vec2 velocity = Vec2::Zero();
  double omega = 0.0;
  int group = -1;
  std::uint8_t state = 0;
  int goal = kNoGoal;
};

void addInstant(Trace& trace, std::int64_t step) {
  Frame& frame = trace.frames.emplace_back();
  frame.step = step;
  frame.time = static_cast<double>(step) * trace.header.dt;
}

class TrajectoryReader {
 public:
  /// `cut` null: the trajectory must be complete.
  TrajectoryReader(CsvTable& table, Trace& trace, const Truncation* cut)
      : table_(table),
        trace_(trace),
        mayBeTruncated_(cut != nullptr),
        addsUnknownPeople_(cut != nullptr && cut->isUnfinished) {
    for (const TraceHuman& human : trace.header.humans) {
      humanIds_.insert(human.id);
    }
    for (const TraceRobot& robot : trace.header.robots) {
      robotIds_.insert(robot.id);
    }
  }

  void read() {
    if (!table_.readColumns(kTrajectoryColumns)) {
      return;
    }
    Row row;
    while (table_.next()) {
      if (parse(row) && isPlaced(row)) {
        append(row);
      }
      last_ = table_[0];
    }
    if (!mayBeTruncated_) {
      checkRobots(last_);
    }
  }
  bool lacksRobot() const {
    return !trace_.frames.empty() && trace_.frames.back().robots.size() < robotIds_.size();
  }

 private:
  bool parse(Row& row) {
    bool good = table_.read(0, row.step, row.time, row.id);
    row.isRobot = table_[3].text == "robot";
    if (!row.isRobot && table_[3].text != "human") {
      table_.error(3, "trace.bad-kind", {table_[3].text});
      good = false;
    }
    Vec2& place = row.pose.position;
    good = table_.read(4, place.x(), place.y(), row.pose.heading, row.velocity.x(),
                       row.velocity.y(), row.omega, row.group, row.state) &&
           good;
    row.goal = kNoGoal;
    return (table_[12].text.empty() || table_.read(12, row.goal)) && good;
  }

  /// Checks a row against the previous rows and the header.
  bool isPlaced(const Row& row) {
    const TraceHeader& header = trace_.header;
    const std::int64_t before = trace_.frames.empty() ? -1 : trace_.frames.back().step;
    const double time = static_cast<double>(row.step) * header.dt;
    if (row.step < std::max<std::int64_t>(before, 0)) {
      table_.error(0, "trace.backwards");
    } else if (row.step % header.recordEvery != 0) {
      table_.error(0, "trace.off-step");
    } else if (std::fabs(row.time - time) > 1e-9 * std::max(1.0, time)) {
      table_.error(1, "trace.time-off-step");
    } else if (const auto& ids = row.isRobot ? robotIds_ : humanIds_;
               ids.count(row.id) == 0 &&
               !(addsUnknownPeople_ && !row.isRobot && addUnknownPerson(row.id))) {
      table_.error(2, "trace.unknown-id", {row.id});
    } else if (row.step == before && !isInOrder(row)) {
      table_.error(2, "trace.bad-order");
    } else {
      return fillGap(row.step, before);
    }
    return false;
  }

  /// Adds an agent that was spawned after the header was written.
  bool addUnknownPerson(int id) {
    TraceHuman& human = trace_.header.humans.emplace_back();
    human.id = id;
    human.name = "person " + std::to_string(id);
    humanIds_.insert(id);
    return true;
  }

  bool isInOrder(const Row& row) const {
    const Frame& frame = trace_.frames.back();
    if (row.isRobot) {
      return frame.robots.id.empty() || row.id < frame.robots.id.back();
    }
    return frame.robots.id.empty() && (frame.humans.id.empty() || row.id > frame.humans.id.back());
  }

  /// States without bodies have no rows; this cannot occur with a robot.
  bool fillGap(std::int64_t step, std::int64_t before) {
    const std::int64_t expected = before < 0 ? 0 : before + trace_.header.recordEvery;
    if (step == before) {
      return true;
    }
    checkRobots(last_);
    if (step > expected && !robotIds_.empty()) {
      table_.error(0, "trace.rows-missing", {expected});
    } else {
      empty_ += (step - expected) / trace_.header.recordEvery;
    }
    if (empty_ > kMaxEmpty) {
      table_.error(0, "trace.gap");
      empty_ = 0;
      return false;
    }
    for (std::int64_t k = robotIds_.empty() ? expected : step; k <= step;
         k += trace_.header.recordEvery) {
      addInstant(trace_, k);
    }
    return true;
  }

  void checkRobots(const CsvField& place) {
    if (lacksRobot()) {
      table_.error(place, "trace.no-robot", {trace_.frames.back().step});
    }
  }

  void append(const Row& row) {
    Frame& frame = trace_.frames.back();
    frame.time = row.time;
    BodyColumns& bodies = row.isRobot ? frame.robots : static_cast<BodyColumns&>(frame.humans);
    bodies.add(row.id, row.pose, row.velocity, row.omega, row.goal);
    if (!row.isRobot) {
      frame.humans.group.push_back(row.group);
      frame.humans.state.push_back(row.state);
    }
  }

  CsvTable& table_;
  Trace& trace_;
  const bool mayBeTruncated_, addsUnknownPeople_;
  std::set<int> humanIds_, robotIds_;
  CsvField last_;
  std::int64_t empty_ = 0;  // states without rows since the last error
};

void readEvents(CsvTable& table, Trace& trace) {
  if (!table.readColumns(kEventColumns)) {
    return;
  }
  while (table.next()) {
    std::int64_t step = 0;
    double time = 0.0;
    Event event;
    bool good = table.read(0, step, time);
    const std::optional<EventKind> kind = eventKindOf(table[2].text);
    if (!kind) {
      table.error(2, "trace.unknown-event", {table[2].text});
      continue;
    }
    event.kind = *kind;
    event.hasId = !table[3].text.empty();
    good = (!event.hasId || table.read(3, event.id)) && good;
    event.hasOther = !table[4].text.empty();
    good = (!event.hasOther || table.read(4, event.other)) && good;
    event.text = table[5].text;
    if (good && step < (trace.events.empty() ? 0 : trace.events.back().first)) {
      table.error(0, "trace.backwards");
    } else if (good) {
      trace.events.emplace_back(step, std::move(event));
    }
  }
}

/// Compares the end of the trajectory with the event `stop`; restores trailing states without
/// bodies.
void checkEnd(Trace& trace, const std::string& file, base::Diagnostics& problems) {
  if (trace.events.empty() || trace.events.back().second.kind != EventKind::Stop) {
    return;
  }
  const std::int64_t every = trace.header.recordEvery;
  const std::int64_t end = trace.events.back().first / every * every;
  std::int64_t step = trace.frames.empty() ? 0 : trace.frames.back().step + every;
  if (step <= end && (!trace.header.robots.empty() || (end - step) / every > kMaxEmpty)) {
    problems.push_back(base::error("trace.ends-early", {end}, file));
    return;
  }
  for (; step <= end; step += every) {
    addInstant(trace, step);
  }
}

/// Content of a file of the run; problems are added.
std::string textOf(const std::string& file, base::Diagnostics& problems) {
  base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  base::append(problems, text.diagnostics());
  return text ? *std::move(text) : std::string();
}

/// With `cut`, only the complete lines: a file with an incomplete line, or an empty one that was
/// never written, is noted.
std::string completeTextOf(const std::string& file, const std::string& name, Truncation* cut,
                           base::Diagnostics& problems) {
  std::string text = textOf(file, problems);
  const std::size_t whole = cut == nullptr ? text.size() : completeLinesSize(text);
  if (cut != nullptr && (whole < text.size() || text.empty())) {
    cut->note(name);
    text.resize(whole);
  }
  return text;
}

constexpr std::array<base::NodeStatus, 5> kStatuses = {
    base::NodeStatus::Idle, base::NodeStatus::Running, base::NodeStatus::Success,
    base::NodeStatus::Failure, base::NodeStatus::Skipped};

/// Reads trees.csv. Nodes are numbered in order of appearance.
class TreesReader {
 public:
  TreesReader(const std::string& text, const std::string& file, base::Diagnostics& problems)
      : table_(text, file, problems) {}

  void read(Recording& recording) {
    if (!table_.readColumns(kTreeColumns)) {
      return;
    }
    while (table_.next()) {
      readRow();
    }
    std::map<int, TreeChanges::Paths> paths;
    for (auto& [id, tree] : trees_) {
      paths[id] = std::make_shared<const std::vector<std::string>>(std::move(tree.paths));
    }
    TreeChanges changes;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      changes.add(rows_[k].id, paths[rows_[k].id], rows_[k].node, rows_[k].status);
      if (k + 1 == rows_.size() || rows_[k + 1].step != rows_[k].step) {
        recording.addTreeChanges(rows_[k].step, changes);
        changes.clear();
      }
    }
  }

 private:
  struct Change {
    std::int64_t step = 0;
    int id = 0, node = 0;
    base::NodeStatus status = base::NodeStatus::Idle;
  };
  struct Tree {
    std::map<std::string, int> numbers;
    std::vector<std::string> paths;
  };

  void readRow() {
    Change row;
    const bool isGood = table_.read(0, row.step, row.id);
    const auto* const status = std::find_if(
        kStatuses.begin(), kStatuses.end(),
        [&](base::NodeStatus each) { return table_[3].text == base::nodeStatusName(each); });
    if (status == kStatuses.end()) {
      table_.error(3, "trace.unknown-status", {table_[3].text});
    } else if (isGood && row.step < (rows_.empty() ? 0 : rows_.back().step)) {
      table_.error(0, "trace.step-backwards");
    } else if (isGood) {
      Tree& tree = trees_[row.id];
      const auto [node, isNew] =
          tree.numbers.emplace(table_[2].text, static_cast<int>(tree.paths.size()));
      if (isNew) {
        tree.paths.push_back(table_[2].text);
      }
      row.node = node->second;
      row.status = *status;
      rows_.push_back(row);
    }
  }

  CsvTable table_;
  std::map<int, Tree> trees_;
  std::vector<Change> rows_;
};

/// `cut` null: truncation is an error.
base::Result<Trace> traceOf(const TraceTexts& texts, Truncation* cut) {
  base::Diagnostics problems;
  Trace trace;
  base::Result<TraceHeader> header = parseTraceJson(texts.header.content, texts.header.path);
  base::append(problems, header.diagnostics());
  if (!header) {
    return problems;  // rows cannot be interpreted without it
  }
  trace.header = *std::move(header);
  CsvTable rows(texts.trajectory.content, texts.trajectory.path, problems);
  TrajectoryReader reader(rows, trace, cut);
  if (cut == nullptr || !texts.trajectory.content.empty()) {
    reader.read();
  }
  CsvTable eventRows(texts.events.content, texts.events.path, problems);
  if (cut == nullptr || !texts.events.content.empty()) {
    readEvents(eventRows, trace);
  }
  if (cut != nullptr && !base::hasErrors(problems)) {
    dropIncompletePart(trace, reader.lacksRobot(), *cut);
  }
  if (!base::hasErrors(problems) && !(cut != nullptr && cut->isTruncated())) {
    checkEnd(trace, texts.trajectory.path, problems);
  }
  return base::resultOf(std::move(trace), std::move(problems));
}

base::Result<Trace> readAnyTrace(const std::string& directory, Truncation* cut) {
  std::error_code none;
  if (std::filesystem::is_regular_file(directory, none)) {
    return base::error("trace.file-for-run", {}, directory);
  }
  base::Diagnostics problems;
  const std::string folder = directory + (directory.empty() || directory.back() == '/' ? "" : "/");
  const auto fileOf = [&](const char* name) {
    return cut == nullptr ? folder + name : finalOrTemporaryPath(folder, name);
  };
  TraceTexts texts{
      {fileOf("trajectory.csv"), {}}, {fileOf("events.csv"), {}}, {folder + "trace.json", {}}};
  texts.trajectory.content = completeTextOf(texts.trajectory.path, "trajectory.csv", cut, problems);
  texts.events.content = completeTextOf(texts.events.path, "events.csv", cut, problems);
  texts.header.content = textOf(texts.header.path, problems);
  return base::hasErrors(problems) ? base::Result<Trace>(problems) : traceOf(texts, cut);
}

}  // namespace

base::Result<Trace> parseTrace(const TraceTexts& texts) {
  return traceOf(texts, nullptr);
}

base::Result<Trace> readTrace(const std::string& directory) {
  return readAnyTrace(directory, nullptr);
}

base::Result<Trace> readTruncatedTrace(const std::string& directory, Truncation& cut) {
  return readAnyTrace(directory, &cut);
}

std::shared_ptr<Recording> recordingOf(Trace trace, std::size_t mostInMemory) {
  auto recording = std::make_shared<Recording>(trace.header.recordEvery, mostInMemory);
  recording->setHeader(trace.header);
  std::vector<std::string> doors;
  std::vector<char> isOpen;  // state of each door so far
  for (const TraceObstacle& obstacle : trace.header.obstacles) {
    if (obstacle.isDoor) {
      doors.push_back(obstacle.name);
      isOpen.push_back(obstacle.open ? 1 : 0);
    }
  }
  auto event = trace.events.begin();
  for (Frame& frame : trace.frames) {
    for (; event != trace.events.end() && event->first <= frame.step; ++event) {
      const std::string& text = event->second.text;
      for (std::size_t k = 0; event->second.kind == EventKind::Door && k < doors.size(); ++k) {
        const bool opens = text == doors[k] + " open";
        isOpen[k] = opens || text == doors[k] + " closed" ? static_cast<char>(opens) : isOpen[k];
      }
    }
    frame.doorOpen = isOpen;
    recording->addState(frame);
    frame = Frame();  // releases memory of long runs
  }
  for (auto& [step, each] : trace.events) {
    recording->addEvent(step, std::move(each));
  }
  return recording;
}

base::Result<std::shared_ptr<const Recording>> readRecording(const std::string& directory,
                                                             std::size_t mostInMemory,
                                                             Truncation* cut) {
  base::Result<Trace> trace = readAnyTrace(directory, cut);
  if (!trace) {
    return trace.diagnostics();
  }
  base::Diagnostics problems = trace.diagnostics();
  const std::shared_ptr<Recording> recording = recordingOf(*std::move(trace), mostInMemory);
  const auto readIfThere = [&](const char* name, auto read) {
    const std::string file = cut == nullptr ? (std::filesystem::path(directory) / name).string()
                                            : finalOrTemporaryPath(directory, name);
    std::error_code none;  // optional: third-party recordings, or no inputs
    if (std::filesystem::exists(file, none)) {
      const std::string text = completeTextOf(file, name, cut, problems);
      if (!text.empty()) {
        read(text, file);
      }
    }
  };
  readIfThere("trees.csv", [&](const std::string& text, const std::string& file) {
    TreesReader(text, file, problems).read(*recording);
  });
  readIfThere("inputs.csv", [&](const std::string& text, const std::string& file) {
    const base::Result<RecordedInputs> inputs = parseInputs(text, file);
    base::append(problems, inputs.diagnostics());
    for (std::size_t k = 0; inputs && k < inputs->size(); ++k) {
      recording->addInput((*inputs)[k].first, (*inputs)[k].second);
    }
  });
  return base::resultOf(std::shared_ptr<const Recording>(recording), std::move(problems));
}

}  // namespace sim2d
