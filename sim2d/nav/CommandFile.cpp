#include "sim2d/nav/CommandFile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"

namespace sim2d {
namespace {

constexpr double kSameTime = 1e-9;  // [s]

struct CommandField {
  std::string_view text;
  int column = 1;  // from 1, in bytes
};

/// The fields of a line. Our files have texts, perhaps in quotes, behind the numbers only.
std::vector<CommandField> fieldsOf(std::string_view line) {
  std::vector<CommandField> fields;
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

/// Reads one file; both kinds.
class CommandReader {
 public:
  CommandReader(std::string_view text, std::string file, int robot)
      : rest_(text), file_(std::move(file)), robot_(robot) {}

  base::Result<CommandRecord> read() {
    if (!next() || !readNames()) {
      tell("replay.columns", {}, 1, 1);
      return problems_;
    }
    while (next()) {
      if (!line_.empty()) {
        readRow();
      }
    }
    if (problems_.empty() && record_.rows.empty()) {
      tellEmpty();
    }
    if (!problems_.empty()) {
      return problems_;
    }
    finish();
    return std::move(record_);
  }

 private:
  void tell(std::string_view code, base::ProblemValues values, int line, int column) {
    problems_.push_back(base::error(code, std::move(values), file_, line, column));
  }

  void tellEmpty() {
    if (isTrajectory_) {
      tell("replay.no-robot", {robot_}, 0, 0);
    } else {
      tell("replay.empty", {}, 0, 0);
    }
  }

  /// The next line, without its end.
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

  /// The number of the column of that name in the first line; none: -1.
  int columnOf(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
  }

  bool readNames() {
    for (const CommandField& field : fieldsOf(line_)) {
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

  /// The numbers of the line in the order of the keys; false when one is none.
  bool readNumbers(const std::vector<CommandField>& fields) {
    bool isGood = true;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const CommandField& field = fields[static_cast<std::size_t>(columns_[i])];
      const std::optional<double> value = base::parseDouble(base::trimmed(field.text));
      if (!value || !std::isfinite(*value)) {
        tell("replay.not-finite", {keys_[i], field.text}, lineNumber_, field.column);
        isGood = false;
      } else {
        values_[i] = *value;
      }
    }
    return isGood;
  }

  void readRow() {
    const std::vector<CommandField> fields = fieldsOf(line_);
    const bool isLong = isTrajectory_ && fields.size() > names_.size();  // commas in a last text
    if (fields.size() != names_.size() && !isLong) {
      tell("replay.field-count", {fields.size(), names_.size()}, lineNumber_, fields.back().column);
      return;
    }
    if (!readNumbers(fields)) {
      return;
    }
    if (isTrajectory_ && values_[1] != robot_) {
      return;
    }
    if (values_[0] <= lastTime_) {
      tell("replay.backwards", {}, lineNumber_,
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

  /// A row of a trajectory: time, id, heading, vx, vy, omega.
  void addState() {
    const bool isFirst = !std::isfinite(lastTime_);
    const double from = isFirst ? values_[0] : lastTime_;
    const double halfway = values_[2] - 0.5 * values_[5] * (values_[0] - from);
    const Vec2 ahead = base::directionOf(halfway);
    const Vec2 velocity(values_[3], values_[4]);
    const BodyTwist twist{ahead.dot(velocity), values_[5], base::cross(ahead, velocity)};
    if (!isFirst && isStart_) {
      record_.rows.clear();  // how fast it was when the record began is no command
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
  bool isStart_ = false;            // the last row was the first of this robot
  std::vector<std::string> names_;  // of all columns
  std::vector<std::string> keys_;   // that are wanted
  std::vector<int> columns_;        // where they stand
  std::vector<double> values_;      // of a row, in the order of the keys
  double lastTime_ = -std::numeric_limits<double>::infinity();
  base::Diagnostics problems_;
  CommandRecord record_;
};

}  // namespace

BodyTwist CommandRecord::at(double time) const {
  const double now = time + kSameTime;
  if (now >= end) {
    return {};
  }
  const auto after =
      std::upper_bound(rows.begin(), rows.end(), now,
                       [](double value, const TimedTwist& row) { return value < row.time; });
  return after == rows.begin() ? BodyTwist{} : std::prev(after)->twist;
}

base::Result<CommandRecord> parseCommands(const std::string& text, const std::string& file,
                                          int robot) {
  return CommandReader(text, file, robot).read();
}

base::Result<CommandRecord> readCommands(const std::string& path, int robot) {
  const base::Result<std::string> text = base::readTextFile(path, base::kMostRecord);
  if (!text) {
    return text.diagnostics();
  }
  return parseCommands(*text, path, robot);
}

}  // namespace sim2d
