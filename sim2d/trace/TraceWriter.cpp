#include <array>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

namespace sim2d {
namespace {

constexpr std::array<const char*, kEventKinds> kEventNames = {
    "enter",  "leave",      "goal",  "arrived", "contact", "say",  "heard",
    "action", "action_end", "group", "replan",  "stuck",   "door", "stop"};

void appendInt(std::string& to, long long value) {
  to += std::to_string(value);
}

/// `ofPerson`: writes the group and state of a row.
template <class OfPerson>
void appendBodies(std::string& to, const std::string& stamp, const BodyColumns& bodies,
                  const char* kind, OfPerson ofPerson) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    to += stamp;
    appendInt(to, bodies.id[k]);
    to += kind;
    for (const double value : {bodies.x[k], bodies.y[k], bodies.heading[k], bodies.vx[k],
                               bodies.vy[k], bodies.omega[k]}) {
      to += base::formatDouble(value);
      to += ',';
    }
    ofPerson(k);
    if (bodies.goal[k] != kNoGoal) {
      appendInt(to, bodies.goal[k]);
    }
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

const char* eventKindName(EventKind kind) {
  return kEventNames[static_cast<std::size_t>(kind)];
}

std::optional<EventKind> eventKindOf(std::string_view name) {
  for (std::size_t k = 0; k < kEventNames.size(); ++k) {
    if (name == kEventNames[k]) {
      return static_cast<EventKind>(k);
    }
  }
  return std::nullopt;
}

std::string headLine(const char* columns) {
  return std::string(columns) + '\n';
}

void appendTrajectoryRows(std::string& to, const Frame& frame) {
  const std::string stamp = std::to_string(frame.step) + ',' + base::formatDouble(frame.time) + ',';
  appendBodies(to, stamp, frame.humans, ",human,", [&](std::size_t k) {
    appendInt(to, frame.humans.group[k]);
    to += ',';
    appendInt(to, frame.humans.state[k]);
    to += ',';
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
