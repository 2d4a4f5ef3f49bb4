#pragma once

#include "bt/human/HumanContext.h"
#include "sim2d/world/HumanBehavior.h"

/// What one person perceives of others, and motions that nodes request, as intents. Pure functions
/// of the frozen view, without side effects. Source: HuNavSim 2.0, extended by walls that block
/// sight and sound; differences are documented at each function. People and robots are indices,
/// distances are centre to centre [m].
namespace bt {

/// Half of the natural field of view [rad]: slightly more than a right angle to each side.
constexpr double kDefaultHalfView = base::kPi / 2.0 + 0.17;
/// A robot faces a person within this angle of its heading [rad].
constexpr double kFacingAngle = 0.3;

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

/// Turn rate on the spot [rad/s]. HuNavSim's limit of a tenth of a turn per tick at 20 Hz and above
/// would depend on the step length.
constexpr double kTurnRate = base::kPi;

/// A person or robot that a person walks to.
struct Target {
  base::Pose2 pose;
  double radius = 0.0;  // [m]
  bool isRobot = false;
};
std::optional<Target> nearestRobotOf(const sim2d::WorldView& view, int human);
Target agentTarget(const sim2d::WorldView& view, int human);

/// A motion, and whether its target is reached.
struct MotionPlan {
  sim2d::Intent intent;
  bool isReached = false;
};

/// v0, or 0 if frozen [m/s].
double ownSpeed(HumanContext& context, int human);
/// How a person treats the robot: impassive people as an obstacle, others while they react to it.
sim2d::RobotTreatment robotTreatment(const HumanContext& context, int human, bool isReacting);

/// Walks to the front goal; brakes without goals.
sim2d::Intent regularWalk(HumanContext& context, int human);
/// Walks to any point at the person's own speed.
sim2d::Intent walkTo(HumanContext& context, int human, const sim2d::GoalItem& place);
/// Turns towards a point. `isReached`: the heading at the end of the step is within `tolerance`.
MotionPlan turnTo(const HumanContext& context, int human, const base::Vec2& point,
                  double tolerance);
/// One step of a look node: like turnTo, or HuNavSim's step with Q-06.
MotionPlan lookAt(const HumanContext& context, int human, const base::Vec2& point,
                  double tolerance);

struct Approach {
  double closest = 1.5;   // [m]
  double maxSpeed = 1.5;  // [m/s]
};
/// Approaches the target, slower with decreasing distance; looks at it within `closest`.
sim2d::Intent approach(const HumanContext& context, int human, const Target& target,
                       const Approach& how);
/// Walks behind the target. `maxSpeed` < 0: the person's own speed.
sim2d::Intent follow(HumanContext& context, int human, const Target& target, const Approach& how);
/// Walks to a point in front of the robot.
sim2d::Intent blockRobot(const HumanContext& context, int human, const Target& robot,
                         double robotSpeed, double front);
/// Walks to a point in front of a person.
sim2d::Intent blockAgent(const HumanContext& context, int human, const Target& person,
                         double front);
struct Escape {
  double safe = 5.0;    // [m]
  double speed = 1.5;   // [m/s]
  double beyond = 0.0;  // walks this much farther than `safe` [m]
};
/// Goal radius of an escape [m].
constexpr double kEscapeRadius = 0.3;
/// Walks away from the target to the distance `safe` and looks at it from there.
sim2d::Intent avoid(const HumanContext& context, int human, const Target& target,
                    const Escape& how);
/// Walks to the person's own goals while the robot repels (first version of HuNavSim): force factor
/// * sigma / gap.
sim2d::Intent walkWithRobotRepulsion(HumanContext& context, int human, const Target& robot,
                                     double speed, double factor);

}  // namespace bt
