#include "app/studies/FailureKind.h"

#include <cmath>
#include <limits>
#include <string_view>

#include "metrics/MetricParameters.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr double kMovingSpeed = 0.1;  // [m/s]
constexpr std::string_view kCollision = "collision: ";
constexpr std::string_view kWithObstacle = " with an obstacle";

FailureEnd endOf(const ResultRow& row) {
  if (!row.ok) {
    return FailureEnd::Error;
  }
  if (base::startsWith(row.reason, kCollision)) {
    return FailureEnd::Contact;
  }
  if (base::startsWith(row.reason, "stuck: ")) {
    return FailureEnd::Standstill;
  }
  if (base::startsWith(row.reason, "navigation_failed: ") ||
      base::startsWith(row.reason, "goal_missed: ")) {
    return FailureEnd::Failure;
  }
  constexpr const char* kContacts[] = {"robot_on_person_collision", "person_on_robot_collision",
                                       "obstacle_collisions"};
  for (const char* key : kContacts) {  // a contact that did not end the run
    if (fieldNumber(row, key) > 0.0) {
      return FailureEnd::Contact;
    }
  }
  return FailureEnd::Time;
}

/// Columns of the robot that collided have its name as a prefix, unless it is the first robot.
std::string prefixOf(const ResultRow& row) {
  if (!base::startsWith(row.reason, kCollision)) {
    return {};
  }
  const std::string robot =
      row.reason.substr(kCollision.size(), row.reason.find(" with ") - kCollision.size());
  const std::string prefix = robot + ".";
  return fieldOf(row, prefix + "final_bearing_to_person") != nullptr ? prefix : std::string();
}

FailureSide sideOf(double bearing) {
  const double angle = std::fabs(bearing);
  if (angle <= base::kPi / 4.0) {
    return FailureSide::Front;
  }
  if (angle >= 3.0 * base::kPi / 4.0) {
    return FailureSide::Behind;
  }
  return bearing > 0.0 ? FailureSide::Left : FailureSide::Right;
}

}  // namespace

std::string FailureKind::name() const {
  constexpr const char* kEnds[] = {"contact", "standstill", "failure", "time", "error"};
  constexpr const char* kSides[] = {"front",    "left",      "right",  "behind",
                                    "obstacle", "no-person", "earlier"};
  std::string text = std::string(kEnds[static_cast<int>(end)]) + "-";
  text += kSides[static_cast<int>(side)];
  const bool hasPerson = side < FailureSide::Obstacle;
  return hasPerson ? text + (isMoving ? "-moving" : "-standing") : text;
}

std::string FailureKind::text() const {
  constexpr const char* kEnds[] = {"contact", "standstill", "navigation failed", "time limit",
                                   "run broke off"};
  constexpr const char* kSides[] = {"in front", "on the left", "on the right", "behind"};
  const std::string what = kEnds[static_cast<int>(end)];
  if (side == FailureSide::Obstacle) {
    return what + " with an obstacle";
  }
  if (side == FailureSide::NoPerson) {
    return what + ", no person near";
  }
  if (side == FailureSide::Earlier) {
    return what + " before the end of the run";
  }
  return what + (end == FailureEnd::Contact ? " with a " : ", nearest is a ") +
         (isMoving ? "moving" : "standing") + " person " + kSides[static_cast<int>(side)];
}

double fieldNumber(const ResultRow& row, const std::string& column) {
  return numberOf(row, column).value_or(std::numeric_limits<double>::quiet_NaN());
}

bool wasSimulated(const ResultRow& row) {
  return row.ok || !row.simulated.empty();
}

std::optional<FailureKind> failureKindOf(const ResultRow& row) {
  if (!wasSimulated(row) || !isUnsuccessful(row)) {
    return std::nullopt;
  }
  FailureKind kind;
  kind.end = endOf(row);
  if (base::endsWith(row.reason, kWithObstacle)) {
    kind.side = FailureSide::Obstacle;
    return kind;
  }
  if (kind.end == FailureEnd::Contact && !base::startsWith(row.reason, kCollision)) {
    kind.side = FailureSide::Earlier;
    return kind;
  }
  const std::string prefix = prefixOf(row);
  const double distance = fieldNumber(row, prefix + "final_distance_to_person");
  if (distance < metrics::MetricParameters().socialDistance) {
    kind.side = sideOf(fieldNumber(row, prefix + "final_bearing_to_person"));
    kind.isMoving = fieldNumber(row, prefix + "final_person_speed") > kMovingSpeed;
  }
  return kind;
}

}  // namespace app
