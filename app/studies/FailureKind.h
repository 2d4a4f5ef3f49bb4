#pragma once

#include <optional>
#include <string>

#include "app/run/ResultRow.h"

namespace app {

/// How a failed run ended. `Failure`: the navigator gave up or stopped too far from the goal;
/// `Error`: the run broke off, for example because a planner program ended.
enum class FailureEnd { Contact, Standstill, Failure, Time, Error };

/// Where the nearest person is at the end, in the frame of the robot: `Front` up to 45 degrees to
/// either side of its heading, `Behind` from 135 degrees on. `Obstacle`: a contact with a wall or
/// obstacle; `NoPerson`: no person within the social space (3.6 m); `Earlier`: a contact that did
/// not end the run, closer than `contact_distance` without touching, or without
/// `stop_on_collision`.
enum class FailureSide { Front, Left, Right, Behind, Obstacle, NoPerson, Earlier };

/// The kind of a failure: how the run ended, where the nearest person was, and whether that person
/// moved (faster than 0.1 m/s). Failures with equal kinds count as the same failure.
struct FailureKind {
  FailureEnd end = FailureEnd::Contact;
  FailureSide side = FailureSide::NoPerson;
  bool isMoving = false;

  /// For names of files: "contact-left-moving", "standstill-no-person".
  std::string name() const;
  /// For readers: "contact with a moving person on the left".
  std::string text() const;

  bool operator==(const FailureKind& other) const {
    return end == other.end && side == other.side && isMoving == other.isMoving;
  }
};

/// Whether a run was simulated; otherwise it could not start or its process crashed, which is
/// neither a success nor a failure of the robot.
bool wasSimulated(const ResultRow& row);

/// nullopt: the run is no failure of the first robot (metric `success`), or was not simulated. The
/// row must have the metrics `final_bearing_to_person`, `final_distance_to_person` and
/// `final_person_speed`.
std::optional<FailureKind> failureKindOf(const ResultRow& row);

/// The number in a column of a row; NaN: there is none. True and False are 1 and 0.
double fieldNumber(const ResultRow& row, const std::string& column);

}  // namespace app
