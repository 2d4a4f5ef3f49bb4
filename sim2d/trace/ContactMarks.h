#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/trace/Recording.h"

namespace sim2d {

/// Position and cause of a contact between two bodies, or of a body with a wall.
struct ContactMark {
  enum class Cause { Robot, Person, Both };  // Both: equal closing speeds
  std::int64_t step = 0;
  double time = 0.0;             // [s]
  Vec2 position = Vec2::Zero();  // [m], on the line of centres; wall: position of the body
  int id = 0;
  std::optional<int> other;  // none: a wall or obstacle
  Cause cause = Cause::Person;
};

/// Cause of a contact between a robot and a person: as the event states, else (HuNavSim
/// compatibility mode, third-party recordings) determined by `contactInitiator` from the previous
/// state. For walls it is the body, between people `Person`. `now` is the state at the contact;
/// none if a body is not in it.
std::optional<ContactMark> contactMark(const StepEvent& contact, const Frame& before,
                                       const Frame& now, const TraceHeader& header);

/// Contacts among the events `first` to `end` (excluded), in order. Events whose states were
/// dropped are omitted.
std::vector<ContactMark> contactMarks(const Recording& recording, std::size_t first = 0,
                                      std::size_t end = static_cast<std::size_t>(-1));
std::vector<ContactMark> contactMarks(const Trace& trace);

}  // namespace sim2d
