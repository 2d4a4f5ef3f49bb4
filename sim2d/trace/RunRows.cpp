#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
namespace {

constexpr char kInputColumns[] = "step,input,id,name,x,y,heading,vx,vy,omega,desired_vx,desired_vy";
constexpr std::size_t kFirstNumber = 4;
constexpr std::array<const char*, 11> kInputNames = {
    "robot", "open", "close", "move", "add", "set", "push", "stop", "resume", "entry", "goal"};

/// In the order of the columns.
template <class AnyInput>
auto numbersOf(AnyInput& input) {
  return std::array{&input.pose.position.x(),   &input.pose.position.y(),  &input.pose.heading,
                    &input.velocity.x(),        &input.velocity.y(),       &input.omega,
                    &input.desiredVelocity.x(), &input.desiredVelocity.y()};
}

void readRow(CsvTable& row, RecordedInputs& inputs) {
  Input input;
  std::int64_t step = 0;
  row.read(0, step);
  const auto kind = std::find(kInputNames.begin(), kInputNames.end(), row[1].text);
  if (kind == kInputNames.end()) {
    row.error(1, "trace.unknown-input", {row[1].text});
  }
  input.kind = static_cast<InputKind>(kind - kInputNames.begin());
  row.read(2, input.id);
  input.name = row[3].text;
  std::size_t column = kFirstNumber;
  for (double* const number : numbersOf(input)) {
    const std::optional<double> value = base::parseDouble(row[column].text);
    if (!value || !std::isfinite(*value)) {
      row.error(column, "trace.no-finite-number", {row[column].text});
    }
    *number = value.value_or(0.0);
    ++column;
  }
  if (!inputs.empty() && step < inputs.back().first) {
    row.error(0, "trace.steps-backwards");
  }
  inputs.emplace_back(step, std::move(input));
}

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

constexpr std::array<const char*, kEventKinds> kEventNames = {"enter",
                                                              "leave",
                                                              "goal",
                                                              "arrived",
                                                              "contact",
                                                              "say",
                                                              "heard",
                                                              "action",
                                                              "action_end",
                                                              "group",
                                                              "replan",
                                                              "stuck",
                                                              "navigation_succeeded",
                                                              "navigation_failed",
                                                              "door",
                                                              "stop",
                                                              "dock",
                                                              "photo",
                                                              "battery"};

/// `ofPerson` appends group and state.
template <class OfPerson>
void appendBodies(std::string& to, const std::string& stamp, const BodyColumns& bodies,
                  const char* kind, OfPerson ofPerson) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    to += stamp;
    to += std::to_string(bodies.id[k]);
    to += kind;
    for (const double value : {bodies.x[k], bodies.y[k], bodies.heading[k], bodies.vx[k],
                               bodies.vy[k], bodies.omega[k]}) {
      to += base::formatDouble(value);
      to += ',';
    }
    ofPerson(k);
    if (bodies.goal[k] != kNoGoal) {
      to += std::to_string(bodies.goal[k]);
    }
    to += '\n';
  }
}

}  // namespace

bool operator==(const Input& a, const Input& b) {
  return a.kind == b.kind && a.id == b.id && a.name == b.name && a.pose == b.pose &&
         a.velocity == b.velocity && a.omega == b.omega && a.desiredVelocity == b.desiredVelocity;
}

const char* inputKindName(InputKind kind) {
  return kInputNames[static_cast<std::size_t>(kind)];
}

StepInputs inputsOf(const RecordedInputs& inputs, std::int64_t step) {
  StepInputs found;
  const auto isBefore = [](const auto& each, std::int64_t wanted) { return each.first < wanted; };
  for (auto each = std::lower_bound(inputs.begin(), inputs.end(), step, isBefore);
       each != inputs.end() && each->first == step; ++each) {
    found.push_back(each->second);
  }
  return found;
}

std::string inputsHeader() {
  return std::string(kInputColumns) + '\n';
}

void appendInputRow(std::string& to, std::int64_t step, const Input& input) {
  to +=
      std::to_string(step) + ',' + inputKindName(input.kind) + ',' + std::to_string(input.id) + ',';
  appendCsvField(to, input.name);
  for (const double* const number : numbersOf(input)) {
    to += ',' + base::formatDouble(*number);
  }
  to += '\n';
}

base::Result<RecordedInputs> parseInputs(const std::string& text, const std::string& file) {
  return readCsvTable<RecordedInputs>(text, file, kInputColumns, readRow);
}

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

const char* eventKindName(EventKind kind) {
  return kEventNames[static_cast<std::size_t>(kind)];
}

std::optional<EventKind> eventKindOf(std::string_view name) {
  const auto* const found = std::find(kEventNames.begin(), kEventNames.end(), name);
  return found == kEventNames.end()
             ? std::nullopt
             : std::optional(static_cast<EventKind>(found - kEventNames.begin()));
}

std::string headerLine(const char* columns) {
  return std::string(columns) + '\n';
}

void appendTrajectoryRows(std::string& to, const Frame& frame) {
  const std::string stamp = std::to_string(frame.step) + ',' + base::formatDouble(frame.time) + ',';
  appendBodies(to, stamp, frame.humans, ",human,", [&](std::size_t k) {
    to += std::to_string(frame.humans.group[k]) + ',' + std::to_string(frame.humans.state[k]) + ',';
  });
  appendBodies(to, stamp, frame.robots, ",robot,", [&](std::size_t) { to += "-1,0,"; });
}

void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event) {
  const auto idText = [](bool isThere, int id) { return isThere ? std::to_string(id) : ""; };
  to += std::to_string(step) + ',' + base::formatDouble(static_cast<double>(step) * dt) + ',' +
        eventKindName(event.kind) + ',' + idText(event.hasId, event.id) + ',' +
        idText(event.hasOther, event.other) + ',';
  appendCsvField(to, event.text);
  to += '\n';
}

void appendTreeRows(std::string& to, std::int64_t step, const TreeChanges& changes) {
  const std::string stamp = std::to_string(step) + ',';
  changes.forEach([&](int id, const TreeChanges::Paths& paths, int node, base::NodeStatus status) {
    to += stamp;
    to += std::to_string(id);
    to += ',';
    appendCsvField(to, paths->at(static_cast<std::size_t>(node)));
    to += ',';
    to += base::nodeStatusName(status);
    to += '\n';
  });
}

std::string trajectoryCsv(const Trace& trace) {
  std::string text = headerLine(kTrajectoryColumns);
  for (const Frame& frame : trace.frames) {
    appendTrajectoryRows(text, frame);
  }
  return text;
}

std::string eventsCsv(const Trace& trace) {
  std::string text = headerLine(kEventColumns);
  for (const auto& [step, event] : trace.events) {
    appendEventRow(text, step, trace.header.dt, event);
  }
  return text;
}

}  // namespace sim2d
