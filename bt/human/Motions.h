#pragma once

#include "bt/human/HumanContext.h"
#include "sim2d/world/HumanBehavior.h"

/// The motions that nodes ask for, as intents. Pure functions of the view: nothing is written.
/// Source: HuNavSim 2.0; what differs is said at each one. Distances centre to centre [m].
namespace bt {

/// Turning on the spot [rad/s]; the original's limit of a tenth of a turn per tick at 20 Hz and
/// faster would depend on the step.
constexpr double kTurnRate = base::kPi;

/// What a person or robot to walk to is made of.
struct Target {
  base::Pose2 pose;
  double radius = 0.0;  // [m]
  bool isRobot = false;
};
std::optional<Target> nearestRobotOf(const sim2d::WorldView& view, int human);
Target personTarget(const sim2d::WorldView& view, int human);

/// A motion and whether the place asked for is reached.
struct Plan {
  sim2d::Intent intent;
  bool isThere = false;
};

/// v0, or 0 while stopped [m/s].
double ownSpeed(HumanContext& context, int human);
/// How a person takes the robot: impassive people as an obstacle, others as long as they react.
sim2d::RobotTreatment robotTreatment(const HumanContext& context, int human, bool isReacting);

/// To the front goal; without goals: brake.
sim2d::Intent regularWalk(HumanContext& context, int human);
/// To any point, with the person's own speed.
sim2d::Intent walkTo(HumanContext& context, int human, const sim2d::GoalItem& place);
/// Turning towards a point; `isThere` = the heading at the end of the step is within `tolerance`.
Plan turnTo(const HumanContext& context, int human, const base::Vec2& point, double tolerance);
/// One step of a look node: as turnTo, or with Q-06 the original's step.
Plan lookAt(const HumanContext& context, int human, const base::Vec2& point, double tolerance);

struct Approach {
  double closest = 1.5;   // [m]
  double maxSpeed = 1.5;  // [m/s]
};
/// Slower the nearer; looks at the target within `closest`.
sim2d::Intent approach(const HumanContext& context, int human, const Target& target,
                       const Approach& how);
/// Behind somebody; `maxSpeed` below 0 = the own speed.
sim2d::Intent follow(HumanContext& context, int human, const Target& target, const Approach& how);
/// In front of the robot.
sim2d::Intent blockRobot(const HumanContext& context, int human, const Target& robot,
                         double robotSpeed, double front);
/// In front of a person.
sim2d::Intent blockPerson(const HumanContext& context, int human, const Target& person,
                          double front);
struct Escape {
  double safe = 5.0;    // [m]
  double speed = 1.5;   // [m/s]
  double beyond = 0.0;  // aims so much farther than `safe` [m]
};
/// Walks are over within this distance of the place that is fled to [m].
constexpr double kEscapeRadius = 0.3;
/// Away from somebody to `safe`; looks at them from there.
sim2d::Intent avoid(const HumanContext& context, int human, const Target& target,
                    const Escape& how);
/// On to the own goals while the robot pushes (first version of HuNavSim): force
/// factor * sigma / gap.
sim2d::Intent flinch(HumanContext& context, int human, const Target& robot, double speed,
                     double factor);

}  // namespace bt
