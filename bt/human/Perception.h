#pragma once

#include "sim2d/base/Types.h"
#include "sim2d/world/HumanBehavior.h"

/// What one person perceives of others. Pure functions of the frozen view. People and robots are
/// indices, distances are centre to centre. Definitions: HuNavSim 2.0 (agent manager), extended by
/// walls that block sight and sound.
namespace bt {

/// Half of the natural field of view [rad]: slightly more than a right angle to each side.
constexpr double kDefaultHalfView = base::kPi / 2.0 + 0.17;
/// A robot faces a person within this angle of its heading [rad].
constexpr double kFacingAngle = 0.3;

/// Index of a person in the world; a node port contains the id.
struct AgentIndex {
  int index;
  AgentIndex(int i) : index(i) {}         // NOLINT: implicit conversion intended
  operator int() const { return index; }  // NOLINT: implicit conversion intended
};

/// Turn that makes `observer` face `point`, in (-pi, pi]; 0 at the same position.
double bearingOf(const base::Vec2& point, const base::Pose2& observer);

/// Distance to the robot relevant for this person; infinity without a robot.
double robotDistance(const sim2d::WorldView& view, int human);

bool isRobotVisible(const sim2d::WorldView& view, AgentIndex human, double distance);
/// `halfView` [rad]: pi: all around; small: the observer looks at the target.
bool isAgentVisible(const sim2d::WorldView& view, AgentIndex observer, AgentIndex target,
                    double distance, double halfView);
bool isRobotFacing(const sim2d::WorldView& view, AgentIndex human);
/// Whether a voice at `speaker` reaches `listener`.
bool isAudible(const sim2d::WorldView& view, int listener, int speaker, double distance);

double agentDistance(const sim2d::WorldView& view, int from, int to);
int nearestAgent(const sim2d::WorldView& view, int human);  // present; -1: none

}  // namespace bt
