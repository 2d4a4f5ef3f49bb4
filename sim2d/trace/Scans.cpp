#include "sim2d/trace/Scans.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace sim2d {
namespace {

constexpr char kScanColumns[] = "step,time,id,x,y,heading,angle_min,angle_step,range,distances";
constexpr std::size_t kDistances = 9;  // the last column: any number of values separated by blanks

void readDistances(CsvTable& row, std::vector<double>& distances) {
  const std::vector<std::string> words = base::split(row[kDistances].text, ' ');
  distances.reserve(words.size());
  for (const std::string& word : words) {
    const std::optional<double> distance = base::parseDouble(word);
    if (!distance || !std::isfinite(*distance) || *distance < 0.0) {
      row.error(kDistances, "trace.no-distance", {word});
      return;
    }
    distances.push_back(*distance);
  }
}

void readScan(CsvTable& row, std::vector<RecordedScan>& scans) {
  RecordedScan turn;
  RobotTelemetry::Scan& scan = turn.scan;
  row.read(0, turn.step, scan.time, turn.robot, scan.sensor.position.x(), scan.sensor.position.y(),
           scan.sensor.heading, scan.angleMin, scan.angleIncrement, scan.range);
  readDistances(row, scan.distances);
  if (!scans.empty() && turn.step < scans.back().step) {
    row.error(0, "trace.steps-backwards");
  }
  scans.push_back(std::move(turn));
}

}  // namespace

std::string scansHeader() {
  return std::string(kScanColumns) + '\n';
}

void appendScanRow(std::string& to, const RecordedScan& turn) {
  const RobotTelemetry::Scan& scan = turn.scan;
  to += std::to_string(turn.step) + ',' + base::formatDouble(scan.time) + ',' +
        std::to_string(turn.robot);
  for (const double number :
       {scan.sensor.position.x(), scan.sensor.position.y(), scan.sensor.heading, scan.angleMin,
        scan.angleIncrement, scan.range}) {
    to += ',' + base::formatDouble(number);
  }
  char before = ',';
  for (const double distance : scan.distances) {
    to += std::exchange(before, ' ') + base::formatDouble(distance);
  }
  to += '\n';
}

base::Result<std::vector<RecordedScan>> parseScans(const std::string& text,
                                                   const std::string& file) {
  return readCsvTable<std::vector<RecordedScan>>(text, file, kScanColumns, readScan);
}

}  // namespace sim2d
