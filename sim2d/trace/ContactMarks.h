#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/trace/Recording.h"

namespace sim2d {

/// Where two bodies touched, or one a wall, and who ran into whom.
struct ContactMark {
  enum class Cause { Robot, Person, Both };  // Both: equally fast
  std::int64_t step = 0;
  double time = 0.0;             // [s]
  Vec2 position = Vec2::Zero();  // on the line of centres between the bodies [m]; wall: of the body
  int id = 0;
  std::optional<int> other;  // none: a wall or obstacle
  Cause cause = Cause::Person;
};

/// Of robot and person the event says who closed in faster; where it does not (runs as the
/// original, recordings of others) it is told by `culpritOf` from the state before. Whoever runs
/// into a wall caused it, among people a person. `now` has the step of the contact; none when a
/// body is not in it.
std::optional<ContactMark> contactMark(const StepEvent& contact, const Frame& before,
                                       const Frame& now, const TraceHeader& header);

/// Of the events from number `first` to before `end`, in their order. States that were dropped give
/// none.
std::vector<ContactMark> contactMarks(const Recording& recording, std::size_t first = 0,
                                      std::size_t end = static_cast<std::size_t>(-1));
std::vector<ContactMark> contactMarks(const Trace& trace);

}  // namespace sim2d
