#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/world/Goals.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/World.h"
#include "sim2d/world/WorldInside.h"
#include "sim2d/world/WorldViewOf.h"

namespace sim2d {

/// A person as another simulator has them. World frame.
struct CoupledPerson {
  int id = 0;
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  std::vector<Vec2> obstacles;   // points of what is solid near the person, from that simulator
};

/// Its robot.
struct CoupledRobot {
  std::string name = "robot";
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  double radius = 0.35;          // [m]; counts when the robot comes in
};

/// The people of a scenario in the world of another simulator: that one owns clock, places and
/// obstacles and gives its state before each step; trees, ways and forces are ours and move people
/// from there. There are no contacts and no walls to run into, that is up to the other; but as in
/// other worlds people and the robot lose the speed that would press them into each other before
/// the step ends, unless people pass (`hunav2`).
/// Doors, sources, sinks, start times, `at_end` and the scenario's robots have no part in it.
///
/// People take part from the first state on that holds them, each with a fresh mind. Walls of the
/// scenario's map count for ways and for what is seen, the given points for forces.
class CoupledWorld {
 public:
  static base::Result<std::unique_ptr<CoupledWorld>> create(WorldSetup setup);

  /// Those in `people` are there, nobody else is, in these places. Ids that the scenario does not
  /// have are left out (`knows`). No `robot`: there is none.
  void take(const std::vector<CoupledPerson>& people, const std::optional<CoupledRobot>& robot);
  bool knows(int id) const { return view_.indexOf(id) >= 0; }

  /// Everybody decides and moves once, over dt [s], > 0; `only`: this person alone, as the others
  /// stand. From the state last taken, or of the step before. False when a velocity is not finite:
  /// then nobody has moved, and `failure` says why.
  bool step(double dt, std::optional<int> only = std::nullopt);
  const std::string& failure() const { return failure_; }
  /// The clock of minds goes on by itself in steps of everybody; after those of one person by this.
  void pass(double dt) { state_.time += dt; }
  double time() const { return state_.time; }  // [s]

  const WorldView& view() const { return view_; }
  HumanBehavior& behavior() { return *behavior_; }
  double omega(int human) const { return state_.omega[at(human)]; }
  bool isActive(int human) const { return state_.active[at(human)] != 0; }
  const HumanControl& control(int human) const { return state_.controls[at(human)]; }
  /// Of the last step, by index of the person.
  const ForceColumns& forces() const { return forces_; }
  /// Goals, ends of ways, what was said … in the last step.
  const std::vector<Event>& events() const { return state_.events; }

 private:
  /// The view, but that only one person may decide.
  class View : public WorldViewOf {
   public:
    using WorldViewOf::WorldViewOf;
    bool decides(int human) const override { return !only || *only == human; }
    std::optional<int> only;  // index
  };

  CoupledWorld(WorldParts parts, std::unique_ptr<HumanBehavior> minds);
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void put(std::size_t human, const CoupledPerson& person);
  void takeRobot(const std::optional<CoupledRobot>& robot);
  bool isSound();
  void keepBodiesApart(double dt);
  void move(std::size_t human, double dt);
  bool moves(std::size_t human) const {
    return state_.present[human] != 0 && view_.decides(static_cast<int>(human));
  }

  WorldModel model_;
  Surroundings surroundings_;
  const base::NeededWork ways_;  // whatever becomes of the map from here on
  std::unique_ptr<NavigationMap> navigation_;
  WorldState state_;
  NeighborGrid grid_;
  FrozenWorld frozen_;
  View view_;
  Intents intents_;
  std::unique_ptr<HumanBehavior> behavior_;
  PersonMotion motion_;
  Goals goals_;
  ForceColumns forces_;
  std::vector<std::vector<Obstacles::Point>> walls_;  // by person
  std::vector<char> entered_;                         // by person
  std::vector<double> headingsBefore_;
  std::vector<Vec2> moves_;         // velocities of this step, by person [m/s]
  std::vector<MovingDisc> discs_;   // of people, then robots
  std::vector<DiscPair> pairs_;
  std::string failure_;
};

}  // namespace sim2d
