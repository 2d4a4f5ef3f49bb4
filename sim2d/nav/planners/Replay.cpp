#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/VelocityRecording.h"

namespace sim2d {

namespace {

constexpr double kSameTime = 1e-9;  // [s]

struct RecordingField {
  std::string_view text;
  int column = 1;  // 1-based, in bytes
};

/// Splits a line at commas. In both formats, quoted text columns come after the numeric ones.
std::vector<RecordingField> fieldsOf(std::string_view line) {
  std::vector<RecordingField> fields;
  std::size_t start = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    fields.push_back({line.substr(start, end - start), static_cast<int>(start) + 1});
    if (end == line.size()) {
      return fields;
    }
    start = end + 1;
  }
}

/// Parser for both formats.
class VelocityReader {
 public:
  VelocityReader(std::string_view text, std::string file, int robot)
      : rest_(text), file_(std::move(file)), robot_(robot) {}

  base::Result<VelocityRecording> read() {
    if (!next() || !readNames()) {
      report("replay.columns", {}, 1, 1);
      return problems_;
    }
    while (next()) {
      if (!line_.empty()) {
        readRow();
      }
    }
    if (problems_.empty() && record_.rows.empty()) {
      reportEmpty();
    }
    if (!problems_.empty()) {
      return problems_;
    }
    finish();
    return std::move(record_);
  }

 private:
  void report(std::string_view code, base::ProblemValues values, int line, int column) {
    problems_.push_back(base::error(code, std::move(values), file_, line, column));
  }

  void reportEmpty() {
    if (isTrajectory_) {
      report("replay.no-robot", {robot_}, 0, 0);
    } else {
      report("replay.empty", {}, 0, 0);
    }
  }

  /// Reads the next line without its line ending.
  bool next() {
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line_.empty() && line_.back() == '\r') {
      line_.remove_suffix(1);
    }
    ++lineNumber_;
    return true;
  }

  /// Index of the column with that name in the first line; -1 if absent.
  int columnOf(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
  }

  bool readNames() {
    for (const RecordingField& field : fieldsOf(line_)) {
      names_.push_back(base::trimmed(field.text));
    }
    isTrajectory_ = columnOf("id") >= 0;
    keys_ = isTrajectory_ ? std::vector<std::string>{"time", "id", "heading", "vx", "vy", "omega"}
                          : std::vector<std::string>{"time", "linear", "angular"};
    const bool hasLateral = !isTrajectory_ && columnOf("lateral") >= 0;
    if (hasLateral) {
      keys_.emplace_back("lateral");
    }
    for (const std::string& key : keys_) {
      columns_.push_back(columnOf(key));
    }
    values_.resize(keys_.size());
    return std::find(columns_.begin(), columns_.end(), -1) == columns_.end() &&
           (isTrajectory_ || names_.size() == keys_.size());
  }

  /// Parses the numbers of the line in the order of the keys; false if one is invalid.
  bool readNumbers(const std::vector<RecordingField>& fields) {
    bool isGood = true;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const RecordingField& field = fields[static_cast<std::size_t>(columns_[i])];
      const std::optional<double> value = base::parseDouble(base::trimmed(field.text));
      if (!value || !std::isfinite(*value)) {
        report("replay.not-finite", {keys_[i], field.text}, lineNumber_, field.column);
        isGood = false;
      } else {
        values_[i] = *value;
      }
    }
    return isGood;
  }

  void readRow() {
    const std::vector<RecordingField> fields = fieldsOf(line_);
    const bool isLong = isTrajectory_ && fields.size() > names_.size();  // in the last column
    if (fields.size() != names_.size() && !isLong) {
      report("replay.field-count", {fields.size(), names_.size()}, lineNumber_,
             fields.back().column);
      return;
    }
    if (!readNumbers(fields)) {
      return;
    }
    if (isTrajectory_ && values_[1] != robot_) {
      return;
    }
    if (values_[0] <= lastTime_) {
      report("replay.backwards", {}, lineNumber_,
             fields[static_cast<std::size_t>(columns_[0])].column);
      return;
    }
    if (isTrajectory_) {
      addState();
    } else {
      const double lateral = values_.size() > 3 ? values_[3] : 0.0;
      record_.rows.push_back({values_[0], {values_[1], values_[2], lateral}});
    }
    lastTime_ = values_[0];
  }

  /// Adds a trajectory row: time, id, heading, vx, vy, omega.
  void addState() {
    const bool isFirst = !std::isfinite(lastTime_);
    const double from = isFirst ? values_[0] : lastTime_;
    const double halfway = values_[2] - 0.5 * values_[5] * (values_[0] - from);
    const Vec2 ahead = base::directionOf(halfway);
    const Vec2 velocity(values_[3], values_[4]);
    const BodyTwist twist{ahead.dot(velocity), values_[5], base::cross(ahead, velocity)};
    if (!isFirst && isStart_) {
      record_.rows.clear();  // the velocity at the start of the recording is not a command
    }
    isStart_ = isFirst;
    record_.rows.push_back({from, twist});
  }

  void finish() {
    const std::size_t count = record_.rows.size();
    if (isTrajectory_) {
      record_.end = lastTime_;
    } else if (count == 1) {
      record_.end = std::numeric_limits<double>::infinity();
    } else {
      const double last = record_.rows[count - 1].time;
      record_.end = last + (last - record_.rows[count - 2].time);
    }
  }

  std::string_view rest_, line_;
  std::string file_;
  int robot_;
  int lineNumber_ = 0;
  bool isTrajectory_ = false;
  bool isStart_ = false;            // the previous row was the first of this robot
  std::vector<std::string> names_;  // of all columns
  std::vector<std::string> keys_;   // required columns
  std::vector<int> columns_;        // their indices
  std::vector<double> values_;      // of one row, in the order of the keys
  double lastTime_ = -std::numeric_limits<double>::infinity();
  base::Diagnostics problems_;
  VelocityRecording record_;
};

}  // namespace

BodyTwist VelocityRecording::at(double time) const {
  const double now = time + kSameTime;
  if (now >= end) {
    return {};
  }
  const auto after =
      std::upper_bound(rows.begin(), rows.end(), now,
                       [](double value, const TimedTwist& row) { return value < row.time; });
  return after == rows.begin() ? BodyTwist{} : std::prev(after)->twist;
}

base::Result<VelocityRecording> parseVelocities(const std::string& text, const std::string& file,
                                                int robot) {
  return VelocityReader(text, file, robot).read();
}

base::Result<VelocityRecording> readVelocities(const std::string& path, int robot) {
  const base::Result<std::string> text = base::readTextFile(path, base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  return parseVelocities(*text, path, robot);
}

namespace {

struct ReplayParameters {
  double robot = -1.0;
};

base::ParameterTable<ReplayParameters> replayTable() {
  base::ParameterTable<ReplayParameters> table;
  table.addCount(&ReplayParameters::robot, "robot", {-1e6, 1e6},
                 "Id of the robot whose velocities are read from a trajectory.csv.");
  return table;
}

std::vector<base::ParameterSpec> replaySpecs() {
  std::vector<base::ParameterSpec> specs{
      fileSpec("CSV with time,linear,angular and optionally lateral, or the trajectory.csv of a "
               "run; relative to the scenario.")};
  for (const base::ParameterSpec& spec : replayTable().specs()) {
    specs.push_back(spec);
  }
  return specs;
}

/// Drives recorded velocities without regard to obstacles.
class Replay : public Planner {
 public:
  explicit Replay(VelocityRecording record) : record_(std::move(record)) {}

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    return record_.at(observation.time);
  }
  bool needsGoal() const override { return false; }

 private:
  VelocityRecording record_;
};

base::Result<std::shared_ptr<Planner>> makeReplay(const PlannerSetup& setup) {
  ReplayParameters parameters;
  replayTable().set(parameters, setup.parameters);
  const std::string path = fileParameter(setup, kFileParameter);
  if (path.empty()) {
    return withRobotName(setup.robot, {base::error("replay.no-file")});
  }
  base::Result<VelocityRecording> record = readVelocities(path, static_cast<int>(parameters.robot));
  if (!record) {
    return record.diagnostics();
  }
  return std::shared_ptr<Planner>(std::make_shared<Replay>(*std::move(record)));
}

}  // namespace

void addReplay(PlannerRegistry& to);
void addReplay(PlannerRegistry& to) {
  to.add("replay", replaySpecs(), makeReplay, "Replays recorded velocities and ignores obstacles.");
}

}  // namespace sim2d
