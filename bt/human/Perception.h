#pragma once

#include "sim2d/base/Types.h"
#include "sim2d/world/HumanBehavior.h"

/// What one person can tell about others. Pure functions of the frozen view; people and robots by
/// index, distances centre to centre. Definitions: HuNavSim 2.0 (agent manager), with walls in the
/// way of sight and sound.
namespace bt {

/// Half of the natural field of view [rad]: a little more than a right angle to each side.
constexpr double kNaturalHalfView = base::kPi / 2.0 + 0.17;
/// A robot faces whoever is within this angle off its nose [rad].
constexpr double kFacingAngle = 0.3;

/// A person in the world, by index; as the port of a node the id.
struct Person {
  int index;
  Person(int i) : index(i) {}             // NOLINT: meant to convert
  operator int() const { return index; }  // NOLINT: meant to convert
};

/// Turn by which `observer` would look straight at `point`, in (-pi, pi]; 0 at the same place.
double bearingOf(const base::Vec2& point, const base::Pose2& observer);

/// Distance to the robot that counts for this person; infinity without a robot.
double robotDistance(const sim2d::WorldView& view, int human);

bool isRobotVisible(const sim2d::WorldView& view, Person human, double distance);
/// `halfView` [rad]: pi = all around, little = the observer looks at the target.
bool isPersonVisible(const sim2d::WorldView& view, Person observer, Person target, double distance,
                     double halfView);
bool isRobotFacing(const sim2d::WorldView& view, Person human);
/// A voice at `speaker` reaches `listener`.
bool isAudible(const sim2d::WorldView& view, int listener, int speaker, double distance);

double personDistance(const sim2d::WorldView& view, int from, int to);
int nearestPerson(const sim2d::WorldView& view, int human);  // present; -1 = nobody else

}  // namespace bt
