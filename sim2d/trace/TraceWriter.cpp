#include <algorithm>
#include <array>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
namespace {

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
