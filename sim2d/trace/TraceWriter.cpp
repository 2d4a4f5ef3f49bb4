#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/trace/TraceRows.h"

namespace sim2d {

namespace {

void appendInt(std::string& to, long long value) {
  to += std::to_string(value);
}

void appendNumbers(std::string& to, std::initializer_list<double> values) {
  for (const double value : values) {
    to += base::formatDouble(value);
    to += ',';
  }
}

void appendGoal(std::string& to, int goal) {
  if (goal != kNoGoal) {
    appendInt(to, goal);
  }
}

void appendHumans(std::string& to, const std::string& stamp, const HumanColumns& humans) {
  for (std::size_t k = 0; k < humans.size(); ++k) {
    to += stamp;
    appendInt(to, humans.id[k]);
    to += ",human,";
    appendNumbers(to, {humans.x[k], humans.y[k], humans.heading[k], humans.vx[k], humans.vy[k],
                       humans.omega[k]});
    appendInt(to, humans.group[k]);
    to += ',';
    appendInt(to, humans.state[k]);
    to += ',';
    appendGoal(to, humans.goal[k]);
    to += '\n';
  }
}

void appendRobots(std::string& to, const std::string& stamp, const RobotColumns& robots) {
  for (std::size_t k = 0; k < robots.size(); ++k) {
    to += stamp;
    appendInt(to, robots.id[k]);
    to += ",robot,";
    appendNumbers(to, {robots.x[k], robots.y[k], robots.heading[k], robots.vx[k], robots.vy[k],
                       robots.omega[k]});
    to += "-1,0,";
    appendGoal(to, robots.goal[k]);
    to += '\n';
  }
}

std::uint64_t fnv1a(const std::string& bytes, std::uint64_t hash) {
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

std::string headLine(const char* columns) {
  return std::string(columns) + '\n';
}

void appendTrajectoryRows(std::string& to, const Frame& frame) {
  const std::string stamp = std::to_string(frame.step) + ',' + base::formatDouble(frame.time) + ',';
  appendHumans(to, stamp, frame.humans);
  appendRobots(to, stamp, frame.robots);
}

void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event) {
  appendInt(to, step);
  to += ',';
  to += base::formatDouble(static_cast<double>(step) * dt);
  to += ',';
  to += eventKindName(event.kind);
  to += ',';
  if (event.hasId) {
    appendInt(to, event.id);
  }
  to += ',';
  if (event.hasOther) {
    appendInt(to, event.other);
  }
  to += ',';
  appendCsvField(to, event.text);
  to += '\n';
}

void appendTreeRows(std::string& to, std::int64_t step, const TreeChanges& changes) {
  const std::string stamp = std::to_string(step) + ',';
  changes.forEach([&](int id, const TreeChanges::Paths& paths, int node, base::NodeStatus status) {
    to += stamp;
    appendInt(to, id);
    to += ',';
    appendCsvField(to, paths->at(static_cast<std::size_t>(node)));
    to += ',';
    to += base::nodeStatusName(status);
    to += '\n';
  });
}

std::string trajectoryCsv(const Trace& trace) {
  std::string text = headLine(kTrajectoryColumns);
  for (const Frame& frame : trace.frames) {
    appendTrajectoryRows(text, frame);
  }
  return text;
}

std::string eventsCsv(const Trace& trace) {
  std::string text = headLine(kEventColumns);
  for (const auto& [step, event] : trace.events) {
    appendEventRow(text, step, trace.header.dt, event);
  }
  return text;
}

std::uint64_t hashOf(const Trace& trace) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325ULL;
  return fnv1a(eventsCsv(trace), fnv1a(trajectoryCsv(trace), kOffset));
}

}  // namespace sim2d
