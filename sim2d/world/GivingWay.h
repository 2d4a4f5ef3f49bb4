#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Speed at which a person may close in on something with `room` left [m]: one that can be braked
/// away with 1.5 m/s² after a reaction time of 0.3 s. Below zero, without room: so one leaves.
double closingSpeedFor(double room);

/// How people give way to robots, by whatever model they walk: round those in their way, where
/// these will be by their velocity; they wait where one stands in the only way and step aside for
/// one that comes through it; and they close in on a robot in sight only as fast as they can stop.
/// A robot that comes from behind is not seen. Who has no robot within sight range is not touched,
/// and costs nothing; nor are people of models that do not give way, and nobody with all quirks of
/// the original. Thread: one at a time.
class GivingWay {
 public:
  static constexpr double kForesight = 4.0;  // [s]; robots are met no later
  /// Somebody on the way.
  struct Walking {
    std::size_t human = 0;
    Vec2 position = Vec2::Zero();
    double radius = 0.35;           // of the body [m]
    double speed = 1.0;             // wanted [m/s]
    Vec2 direction = Vec2::Zero();  // of the way; unit vector, not zero
    double goalRadius = 0.3;        // [m]
    std::vector<Vec2> way;          // the points to walk to; not empty
  };
  struct Lead {
    Vec2 direction = Vec2::Zero();  // where to head; zero: stand
    bool waits = false;             // there is no room to pass
    /// What stands there, to look for another way; empty: something that moves.
    std::vector<std::vector<Vec2>> closed;
    double stoodFor = 0.0;  // [s]
  };

  /// Who is near which robot in this step.
  void update(const FrozenWorld& world);
  /// Those near a robot, ascending.
  const std::vector<std::size_t>& people() const { return people_; }
  bool concerns(std::size_t human) const;

  Lead lead(const FrozenWorld& world, const Walking& who);
  /// The velocity nearest to `wanted` that brings the person into no robot. `walls`: near the body;
  /// null: none.
  Vec2 limited(const FrozenWorld& world, std::size_t human, const Vec2& wanted,
               const std::vector<Obstacles::Point>* walls) const;

 private:
  struct Met {  // a robot, where it will be met
    std::size_t robot = 0;
    Pose2 pose;
    bool stands = false;
    std::vector<Vec2> outline;  // to keep out of; empty: met too closely to walk round it
  };
  struct Conflict {
    std::size_t met = 0;
    std::size_t leg = 0;  // of the line
    double share = 0.0;   // of the leg
  };
  struct Memory {  // the side on which a robot is passed
    std::size_t robot = 0;
    bool isLeft = false;
    double at = -1e9;  // [s]
  };

  /// Nothing solid is between.
  static bool isSeen(const FrozenWorld& world, const Vec2& eye, const Vec2& point);
  /// Where the person looks.
  static bool isInFront(const FrozenWorld& world, std::size_t human, const Vec2& point);
  std::pair<std::size_t, std::size_t> nearOf(std::size_t human) const;
  std::vector<Met> metBy(const FrozenWorld& world, const Walking& who) const;
  void draw(std::vector<Met>& met, const Walking& who, double room) const;
  static std::optional<Conflict> firstConflict(const std::vector<Met>& met,
                                               const std::vector<Vec2>& line);
  static bool isWayFree(const FrozenWorld& world, const Walking& who, const std::vector<Met>& met,
                        std::size_t around, const std::vector<Vec2>& way);
  std::optional<Vec2> wayPast(const FrozenWorld& world, const Walking& who,
                              const std::vector<Met>& met, const std::vector<Vec2>& line,
                              const Conflict& conflict);
  const std::vector<Vec2>* choose(const std::vector<Vec2>* left, const std::vector<Vec2>* right,
                                  std::size_t human, const Met& met, double time);
  Vec2 besideOf(const FrozenWorld& world, const Met& met, const Vec2& place, double radius) const;
  Lead waiting(const FrozenWorld& world, const Walking& who, const std::vector<Met>& met,
               std::size_t blocking) const;
  std::optional<HalfPlane> boundBy(const FrozenWorld& world, std::size_t human, std::size_t robot,
                                   const Vec2& velocity) const;

  std::vector<Footprint> footprints_;                      // of the robots
  std::vector<OutlineDirections> directions_;              // of their headings, now
  std::vector<double> movedAt_;                            // idem, last [s]
  std::vector<std::pair<std::size_t, std::size_t>> near_;  // person, robot; ascending
  std::vector<std::size_t> people_;                        // of these
  std::vector<Memory> memory_;                             // by person
};

}  // namespace sim2d
