#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/trace/TraceRows.h"

namespace sim2d {

namespace {

constexpr std::array<base::NodeStatus, 5> kStatuses = {
    base::NodeStatus::Idle, base::NodeStatus::Running, base::NodeStatus::Success,
    base::NodeStatus::Failure, base::NodeStatus::Skipped};

/// Rows of trees.csv. Nodes are numbered in the order in which the rows name them.
class TreesReader {
 public:
  TreesReader(const std::string& text, const std::string& file, base::Diagnostics& problems)
      : table_(text, file, problems) {}

  void read(Recording& recording) {
    if (!table_.readColumns(kTreeColumns)) {
      return;
    }
    CsvRow fields;
    while (table_.next(fields)) {
      readRow(fields);
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
  struct Row {
    std::int64_t step = 0;
    int id = 0, node = 0;
    base::NodeStatus status = base::NodeStatus::Idle;
  };
  struct Tree {
    std::map<std::string, int> numbers;
    std::vector<std::string> paths;
  };

  void readRow(const CsvRow& fields) {
    Row row;
    bool isGood = table_.readInt(fields[0], "step", row.step);
    isGood = table_.readInt(fields[1], "id", row.id) && isGood;
    const auto* const status = std::find_if(
        kStatuses.begin(), kStatuses.end(),
        [&](base::NodeStatus each) { return fields[3].text == base::nodeStatusName(each); });
    if (status == kStatuses.end()) {
      table_.error(fields[3], "trace.unknown-status", {fields[3].text});
    } else if (isGood && row.step < (rows_.empty() ? 0 : rows_.back().step)) {
      table_.error(fields[0], "trace.step-backwards");
    } else if (isGood) {
      Tree& tree = trees_[row.id];
      const auto [node, isNew] =
          tree.numbers.emplace(fields[2].text, static_cast<int>(tree.paths.size()));
      if (isNew) {
        tree.paths.push_back(fields[2].text);
      }
      row.node = node->second;
      row.status = *status;
      rows_.push_back(row);
    }
  }

  CsvTable table_;
  std::map<int, Tree> trees_;
  std::vector<Row> rows_;
};

/// Which doors are open after the events so far.
class Doors {
 public:
  explicit Doors(const TraceHeader& header) {
    for (const TraceObstacle& obstacle : header.obstacles) {
      if (obstacle.isDoor) {
        names_.push_back(obstacle.name);
        open_.push_back(obstacle.open ? 1 : 0);
      }
    }
  }
  void take(const Event& event) {
    for (std::size_t k = 0; event.kind == EventKind::Door && k < names_.size(); ++k) {
      if (event.text == names_[k] + " open" || event.text == names_[k] + " closed") {
        open_[k] = event.text == names_[k] + " open" ? 1 : 0;
      }
    }
  }
  const std::vector<char>& open() const { return open_; }

 private:
  std::vector<std::string> names_;
  std::vector<char> open_;
};

}  // namespace

std::shared_ptr<Recording> recordingOf(Trace trace) {
  auto recording = std::make_shared<Recording>(trace.header.recordEvery);
  recording->setHeader(trace.header);
  Doors doors(trace.header);
  auto event = trace.events.begin();
  for (Frame& frame : trace.frames) {
    for (; event != trace.events.end() && event->first <= frame.step; ++event) {
      doors.take(event->second);
    }
    frame.doorOpen = doors.open();
    recording->addState(frame);
    frame = Frame();  // long runs need not be there twice
  }
  for (auto& [step, each] : trace.events) {
    recording->addEvent(step, std::move(each));
  }
  return recording;
}

base::Result<std::shared_ptr<const Recording>> readRecording(const std::string& directory) {
  base::Result<Trace> trace = readTrace(directory);
  if (!trace) {
    return trace.diagnostics();
  }
  base::Diagnostics problems = trace.diagnostics();
  const std::shared_ptr<Recording> recording = recordingOf(*std::move(trace));
  const auto readIfThere = [&](const char* name, auto read) {
    const std::filesystem::path file = std::filesystem::path(directory) / name;
    std::error_code none;  // no such file: a record of others, or nothing came from outside
    if (std::filesystem::exists(file, none)) {
      const base::Result<std::string> text = base::readTextFile(file.string());
      base::append(problems, text.diagnostics());
      if (text) {
        read(*text, file.string());
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
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::shared_ptr<const Recording>(recording), std::move(problems)};
}

}  // namespace sim2d
