#include "sim2d/trace/ContactMarks.h"

#include <algorithm>
#include <memory>
#include <string>

namespace sim2d {

namespace {

struct TouchingBody {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();  // [m], [m/s]
};

std::optional<TouchingBody> bodyIn(const Frame& frame, int id) {
  const BodyColumns& bodies = id < 0 ? frame.robots : frame.humans;
  const auto found = std::find(bodies.id.begin(), bodies.id.end(), id);
  if (found == bodies.id.end()) {
    return std::nullopt;
  }
  const auto k = static_cast<std::size_t>(found - bodies.id.begin());
  return TouchingBody{{bodies.x[k], bodies.y[k]}, {bodies.vx[k], bodies.vy[k]}};
}

double touchingRadius(const TraceHeader& header, int id) {
  if (const TraceRobot* const robot = header.robot(id)) {
    return robot->radius;
  }
  const TraceHuman* const human = header.human(id);
  return human != nullptr ? human->radius : 0.0;
}

using Cause = ContactMark::Cause;

Cause kindOf(int id) {
  return id < 0 ? Cause::Robot : Cause::Person;
}

/// The cause given in the event's text after the closing speed: "0.52 robot front".
std::optional<Cause> statedCause(const std::string& text) {
  const auto has = [&text](const char* word) { return text.find(word) != std::string::npos; };
  return has(" robot ")    ? std::optional(Cause::Robot)
         : has(" person ") ? std::optional(Cause::Person)
         : has(" both ")   ? std::optional(Cause::Both)
                           : std::nullopt;
}

/// Of a robot and a person, by their motion before the contact.
Cause causeOf(const Frame& before, int id, int other) {
  const std::optional<TouchingBody> one = bodyIn(before, id);
  const std::optional<TouchingBody> its = bodyIn(before, other);
  if (!one || !its) {
    return Cause::Both;
  }
  const ContactInitiator initiator =
      contactInitiator(one->position, one->velocity, its->position, its->velocity);
  return initiator == ContactInitiator::First    ? kindOf(id)
         : initiator == ContactInitiator::Second ? kindOf(other)
                                                 : Cause::Both;
}

}  // namespace

std::optional<ContactMark> contactMark(const StepEvent& contact, const Frame& before,
                                       const Frame& now, const TraceHeader& header) {
  const auto& [step, event] = contact;
  const std::optional<TouchingBody> one = bodyIn(now, event.id);
  if (event.kind != EventKind::Contact || !event.hasId || !one) {
    return std::nullopt;
  }
  ContactMark mark;
  mark.step = step;
  mark.time = static_cast<double>(step) * header.dt;
  mark.id = event.id;
  mark.position = one->position;
  mark.cause = kindOf(event.id);
  if (!event.hasOther) {
    return mark;
  }
  const std::optional<TouchingBody> other = bodyIn(now, event.other);
  if (!other) {
    return std::nullopt;
  }
  mark.other = event.other;
  const double mine = touchingRadius(header, event.id);
  const double its = touchingRadius(header, event.other);
  const double share = mine + its > 0.0 ? mine / (mine + its) : 0.5;
  mark.position += share * (other->position - one->position);
  if (kindOf(event.other) != mark.cause) {
    const std::optional<Cause> told = statedCause(event.text);
    mark.cause = told ? *told : causeOf(before, event.id, event.other);
  }
  return mark;
}

std::vector<ContactMark> contactMarks(const Recording& recording, std::size_t first,
                                      std::size_t end) {
  std::vector<ContactMark> marks;
  const std::shared_ptr<const TraceHeader> header = recording.header();
  const std::size_t last = recording.size() > 0 ? recording.events().size() : first;
  for (std::size_t k = first; k < std::min(end, last); ++k) {
    const StepEvent event = recording.events()[k];
    if (event.second.kind != EventKind::Contact) {
      continue;
    }
    const FramePtr now = recording.frameIfKept(recording.indexAt(event.first));
    const FramePtr before =
        recording.frameIfKept(recording.indexAt(std::max<std::int64_t>(0, event.first - 1)));
    if (now == nullptr || before == nullptr) {
      continue;
    }
    if (std::optional<ContactMark> mark = contactMark(event, *before, *now, *header)) {
      marks.push_back(*mark);
    }
  }
  return marks;
}

std::vector<ContactMark> contactMarks(const Trace& trace) {
  std::vector<ContactMark> marks;
  const auto stateAt = [&trace](std::int64_t step) {
    const auto next = std::upper_bound(
        trace.frames.begin(), trace.frames.end(), step,
        [](std::int64_t wanted, const Frame& frame) { return wanted < frame.step; });
    return next == trace.frames.begin() ? next : next - 1;
  };
  for (const StepEvent& event : trace.events) {
    if (event.second.kind != EventKind::Contact || trace.frames.empty()) {
      continue;
    }
    if (std::optional<ContactMark> mark =
            contactMark(event, *stateAt(event.first - 1), *stateAt(event.first), trace.header)) {
      marks.push_back(*mark);
    }
  }
  return marks;
}

}  // namespace sim2d
