#include "sim2d/trace/RecordedPoints.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
namespace {

constexpr char kPointColumns[] = "step,id,kind,points";
constexpr char kRobotKind[] = "robot";
constexpr char kHumanKind[] = "human";

/// Parses "x y x y …"; none: not finite numbers, or an odd count.
std::optional<std::vector<base::Vec2>> pointsOf(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : base::split(text, ' ')) {
    const std::optional<double> number = base::parseDouble(word);
    if (!number || !std::isfinite(*number)) {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  if (numbers.size() % 2 != 0) {
    return std::nullopt;
  }
  std::vector<base::Vec2> points;
  for (std::size_t k = 0; k < numbers.size(); k += 2) {
    points.emplace_back(numbers[k], numbers[k + 1]);
  }
  return points;
}

void readPoints(CsvTable& row, RecordedPoints& all) {
  std::int64_t step = 0;
  int id = 0;
  const bool isGood = row.read(0, step, id);
  const bool isRobot = row[2].text == kRobotKind;
  const std::optional<std::vector<base::Vec2>> points = pointsOf(row[3].text);
  if (!isRobot && row[2].text != kHumanKind) {
    row.error(2, "trace.bad-kind", {row[2].text});
  } else if (!points) {
    row.error(3, "trace.bad-points");
  } else if (isGood) {
    all.add(step, id, isRobot, *points);
  }
}

}  // namespace

bool RecordedPoints::isBefore(const Entry& a, const Entry& b) {
  return std::tie(a.step, a.isRobot, a.id) < std::tie(b.step, b.isRobot, b.id);
}

void RecordedPoints::add(std::int64_t step, int id, bool isRobot,
                         const std::vector<base::Vec2>& points) {
  if (points.empty()) {
    return;
  }
  entries_.push_back({step, id, isRobot, points_.size(), points_.size() + points.size()});
  points_.insert(points_.end(), points.begin(), points.end());
  hasPeople_ = hasPeople_ || !isRobot;
  hasRobot_ = hasRobot_ || isRobot;
}

void RecordedPoints::sort() {
  std::stable_sort(entries_.begin(), entries_.end(), isBefore);
}

RecordedPoints::Range RecordedPoints::of(std::int64_t step, int id, bool isRobot) const {
  const Entry wanted{step, id, isRobot};
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), wanted, isBefore);
  return found == entries_.end() || isBefore(wanted, *found)
             ? Range()
             : Range{points_.data() + found->begin, points_.data() + found->end};
}

std::string RecordedPoints::csv() const {
  std::string text = headerLine(kPointColumns);
  for (const Entry& entry : entries_) {
    text += std::to_string(entry.step) + "," + std::to_string(entry.id) + "," +
            (entry.isRobot ? kRobotKind : kHumanKind) + ",";
    for (std::size_t k = entry.begin; k < entry.end; ++k) {
      text += (k > entry.begin ? " " : "") + base::formatDouble(points_[k].x()) + " " +
              base::formatDouble(points_[k].y());
    }
    text += "\n";
  }
  return text;
}

base::Result<RecordedPoints> parseRecordedPoints(const std::string& text, const std::string& file) {
  base::Result<RecordedPoints> all =
      readCsvTable<RecordedPoints>(text, file, kPointColumns, readPoints);
  if (all) {
    all->sort();
  }
  return all;
}

base::Result<RecordedPoints> readRecordedPoints(const std::string& directory) {
  const std::string file = (std::filesystem::path(directory) / kPointsFile).string();
  std::error_code none;  // optional: recordings of hunavsim have outlines instead
  if (!std::filesystem::exists(file, none)) {
    return RecordedPoints();
  }
  const base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  return text ? parseRecordedPoints(*text, file) : text.diagnostics();
}

}  // namespace sim2d
