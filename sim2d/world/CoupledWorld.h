#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/world/World.h"

namespace sim2d {

/// State of a person in another simulator. World frame.
struct CoupledPerson {
  int id = 0;
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  std::vector<Vec2> obstacles;   // obstacle points near the person, from that simulator
};

/// State of the robot in the other simulator.
struct CoupledRobot {
  std::string name = "robot";
  Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  double radius = 0.35;          // [m]; used when the robot first appears
};

/// The people of a scenario in the world of another simulator. That simulator owns clock, poses and
/// obstacles and supplies its state before each step; this class adds trees, paths and forces and
/// moves people from that state. There are no contacts and no collisions with walls; but as in
/// other worlds people and the robot lose the speed that would press them into each other before
/// the step ends, unless people pass through each other (`hunav2`). Doors, sources, sinks, start
/// times, `at_end` and the scenario's robots are ignored.
///
/// A person participates from the first state on that contains it, with a newly started behaviour.
/// Walls of the scenario's map are used for paths and visibility, the supplied points for forces.
class CoupledWorld : public WorldBase {
 public:
  static base::Result<std::unique_ptr<CoupledWorld>> create(WorldSetup setup);

  /// Sets the state: exactly the people in `people` are present, at these poses. Ids that are not
  /// in the scenario are ignored (see `contains`). Without `robot` there is none.
  void take(const std::vector<CoupledPerson>& people, const std::optional<CoupledRobot>& robot);
  bool contains(int id) const { return view_.indexOf(id) >= 0; }

  /// Decisions and motion of all people over dt [s], > 0, from the state last taken or of the
  /// previous step; `only`: of this person, while the others stand. Returns false if a velocity is
  /// not finite; then no person has moved and `failure` contains the reason.
  bool step(double dt, std::optional<int> only = std::nullopt);
  const std::string& failure() const { return failure_; }
  /// Advances the clock of the behaviours after steps of single persons; steps of all people
  /// advance it themselves.
  void pass(double dt) { state_.time += dt; }
  double time() const { return state_.time; }  // [s]

  double omega(int human) const { return state_.omega[at(human)]; }
  bool isActive(int human) const { return state_.active[at(human)] != 0; }
  const HumanControl& control(int human) const { return state_.controls[at(human)]; }
  /// Forces in the last step, by index of the person.
  const ForceColumns& forces() const { return forces_; }
  /// Events of the last step: goals, ends of paths, sounds …
  const std::vector<Event>& events() const { return state_.events; }

 private:
  CoupledWorld(WorldParts parts, std::unique_ptr<HumanBehavior> humanBehavior);
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  void put(std::size_t human, const CoupledPerson& person);
  void takeRobot(const std::optional<CoupledRobot>& robot);
  bool isSound();
  void keepBodiesApart(double dt);
  void move(std::size_t human, double dt);
  bool moves(std::size_t human) const {
    return state_.present[human] != 0 && view_.decides(static_cast<int>(human));
  }

  ForceColumns forces_;
  std::vector<std::vector<Obstacles::Point>> walls_;  // by person
  std::vector<char> entered_;                         // by person
  std::vector<Vec2> moves_;                           // velocities of this step, by person [m/s]
};

}  // namespace sim2d
