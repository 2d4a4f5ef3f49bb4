#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim2d/trace/Recording.h"

namespace sim2d {

/// Which body caused a contact; used for contact events and by metrics.
enum class ContactInitiator { First, Second, Both };

/// The body with the higher closing speed along the line of centres; `Both` if the speeds are equal
/// to 1e-6 m/s or the centres coincide. Velocities [m/s] are those before the contact, which may
/// already have stopped the bodies.
inline ContactInitiator contactInitiator(const base::Vec2& first, const base::Vec2& velocityOfFirst,
                                         const base::Vec2& second,
                                         const base::Vec2& velocityOfSecond) {
  constexpr double kEqualSpeeds = 1e-6;  // [m/s]
  const base::Vec2 between = second - first;
  const double separation = between.norm();
  const base::Vec2 normal =
      separation > 0.0 ? base::Vec2(between / separation) : base::Vec2(0.0, 0.0);
  const double byFirst = velocityOfFirst.dot(normal);
  const double bySecond = -velocityOfSecond.dot(normal);
  if (byFirst > bySecond + kEqualSpeeds) {
    return ContactInitiator::First;
  }
  return bySecond > byFirst + kEqualSpeeds ? ContactInitiator::Second : ContactInitiator::Both;
}

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
