#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Maximum speed at which a person may approach an object at distance `room` [m]: it can stop with
/// 1.5 m/s² after a reaction time of 0.3 s. Negative without clearance: the speed of moving away.
double maxClosingSpeed(double room);

/// Reaction of people to robots, independent of their pedestrian model: they walk around robots in
/// their way, at the positions predicted by constant velocity; they wait where a robot blocks the
/// only path and step aside for one that comes through; and they approach a visible robot only as
/// fast as they can stop. Robots that approach from behind are not seen. People without a robot in
/// sight range are not affected and cost nothing, nor are people of models that do not give way,
/// and none with all quirks of the original. Not thread-safe.
class YieldModel {
 public:
  static constexpr double kForesight = 4.0;  // [s]; prediction horizon for robots
  /// A person walking along a path.
  struct Walking {
    std::size_t human = 0;
    Vec2 position = Vec2::Zero();
    double radius = 0.35;           // of the body [m]
    double speed = 1.0;             // desired [m/s]
    Vec2 direction = Vec2::Zero();  // of the path; unit vector, not zero
    double goalRadius = 0.3;        // [m]
    std::vector<Vec2> way;          // remaining path points; not empty
  };
  struct Guidance {
    Vec2 direction = Vec2::Zero();  // walking direction; zero: stand
    bool waits = false;             // no space to pass
    /// Outlines of standing obstacles, for finding another path; empty: the obstacle moves.
    std::vector<std::vector<Vec2>> closed;
    double stoodFor = 0.0;  // [s]
  };

  /// Finds the people near each robot in this step.
  void update(const FrozenWorld& world);
  /// People near a robot, ascending.
  const std::vector<std::size_t>& people() const { return people_; }
  bool isNearRobot(std::size_t human) const;

  Guidance lead(const FrozenWorld& world, const Walking& who);
  /// The velocity nearest to `wanted` that does not lead the person into a robot. `walls`: points
  /// near the body; null: none.
  Vec2 limited(const FrozenWorld& world, std::size_t human, const Vec2& wanted,
               const std::vector<Obstacles::Point>* walls) const;

 private:
  struct MetRobot {  // a robot at its predicted pose
    std::size_t robot = 0;
    Pose2 pose;
    bool stands = false;
    std::vector<Vec2> outline;  // to be avoided; empty: too close to walk around
  };
  struct Conflict {
    std::size_t met = 0;
    std::size_t leg = 0;  // of the line
    double share = 0.0;   // of the leg
  };
  struct Memory {  // side on which a robot is passed
    std::size_t robot = 0;
    bool isLeft = false;
    double at = -1e9;  // [s]
  };

  /// No obstacle is in between.
  static bool isSeen(const FrozenWorld& world, const Vec2& eye, const Vec2& point);
  /// The point is in the person's field of view.
  static bool isInFront(const FrozenWorld& world, std::size_t human, const Vec2& point);
  std::pair<std::size_t, std::size_t> nearRange(std::size_t human) const;
  std::vector<MetRobot> metRobots(const FrozenWorld& world, const Walking& who) const;
  void computeOutlines(std::vector<MetRobot>& met, const Walking& who, double room) const;
  static std::optional<Conflict> firstConflict(const std::vector<MetRobot>& met,
                                               const std::vector<Vec2>& line);
  static bool isPathFree(const FrozenWorld& world, const Walking& who,
                         const std::vector<MetRobot>& met, std::size_t around,
                         const std::vector<Vec2>& way);
  std::optional<Vec2> directionPast(const FrozenWorld& world, const Walking& who,
                                    const std::vector<MetRobot>& met, const std::vector<Vec2>& line,
                                    const Conflict& conflict);
  const std::vector<Vec2>* choosePath(const std::vector<Vec2>* left, const std::vector<Vec2>* right,
                                      std::size_t human, const MetRobot& met, double time);
  Vec2 pointBeside(const FrozenWorld& world, const MetRobot& met, const Vec2& place,
                   double radius) const;
  Guidance waiting(const FrozenWorld& world, const Walking& who, const std::vector<MetRobot>& met,
                   std::size_t blocking) const;
  std::optional<HalfPlane> speedBound(const FrozenWorld& world, std::size_t human,
                                      std::size_t robot, const Vec2& velocity) const;

  std::vector<Footprint> footprints_;                      // of the robots
  std::vector<OutlineDirections> directions_;              // of their current headings
  std::vector<double> movedAt_;                            // time of their last motion [s]
  std::vector<std::pair<std::size_t, std::size_t>> near_;  // person, robot; ascending
  std::vector<std::size_t> people_;                        // people in near_
  std::vector<Memory> memory_;                             // by person
};

}  // namespace sim2d
