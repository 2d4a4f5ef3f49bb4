#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/world/Compatibility.h"
#include "sim2d/world/TreeBreakpoint.h"

namespace sim2d {

/// A point to walk to. The order of the members spares a third of the room.
struct GoalItem {
  Vec2 position = Vec2::Zero();
  double radius = 0.3;  // rho [m]: reached inside
  int id = 0;           // of the global goal, 0 = a plain point

  GoalItem() = default;
  GoalItem(int goal, const Vec2& place, double within = 0.3)
      : position(place), radius(within), id(goal) {}
  friend bool operator==(const GoalItem& a, const GoalItem& b) {
    return a.id == b.id && a.position == b.position && a.radius == b.radius;
  }
};

/// What a behaviour may change of one person beside the motion of the step. Kept from step to step.
struct HumanControl {
  std::vector<GoalItem> goals;  // front = current
  bool frozen = false;          // StopMovement: desired speed 0 until resumed
  int group = -1;
};

/// The world as it was when the step began; nothing in it changes while people decide. People are
/// addressed by index (0 … humanCount() - 1), stable for the whole run; those not present (not yet
/// started, left) are skipped by everybody. Thread: read only, any.
class WorldView {
 public:
  virtual ~WorldView() = default;

  virtual std::int64_t step() const = 0;  // the step being computed, from 1
  virtual double time() const = 0;        // at the start of the step [s]
  virtual double dt() const = 0;
  virtual std::uint64_t seed() const = 0;
  virtual const Environment& scenario() const = 0;
  virtual const Compatibility& compatibility() const = 0;

  virtual int humanCount() const = 0;
  virtual bool isPresent(int human) const = 0;
  /// False: the mind of this person rests in this step, as it is.
  virtual bool decides(int /*human*/) const { return true; }
  virtual int indexOf(int humanId) const = 0;  // -1 = no such person
  virtual const ResolvedHuman& constants(int human) const = 0;
  /// The person (index) of whom an input made a copy; -1: this one is in the scenario.
  virtual int copiedFrom(int /*human*/) const { return -1; }
  virtual Pose2 pose(int human) const = 0;
  virtual Vec2 velocity(int human) const = 0;
  /// Present people whose centre is within `range`, by ascending distance, then id; without
  /// `human`.
  virtual void near(int human, double range, std::vector<int>& found) const = 0;

  virtual int robotCount() const = 0;
  virtual Pose2 robotPose(int robot) const = 0;
  virtual Vec2 robotVelocity(int robot) const = 0;
  virtual double robotRadius(int robot) const = 0;
  virtual int nearestRobot(int human) const = 0;  // -1 = none; ties: the first in the list

  virtual std::optional<Vec2> globalGoal(int id) const = 0;
  virtual const Area* area(const std::string& name) const = 0;
  /// Line of sight and way of sound: walls, obstacles and closed doors block, bodies do not.
  /// Always true with the quirk Q-34.
  virtual bool isVisible(const Vec2& from, const Vec2& to) const = 0;
  /// There is a way for this person's body (always true with `route: direct`).
  virtual bool isReachable(int human, const Vec2& point) const = 0;
  /// Length of this person's way to the point [m]; nothing where there is none.
  virtual std::optional<double> wayLength(int human, const Vec2& point) const {
    return isReachable(human, point) ? std::optional<double>((point - pose(human).position).norm())
                                     : std::nullopt;
  }
};

enum class Motion : std::uint8_t {
  Stand,  // v = 0, omega = 0
  Turn,   // on the spot towards `heading`
  Walk,   // by the person's model to `target`, along a way round walls as its route says
  Brake,  // by the model without a goal
};
inline bool isWalking(Motion motion) {
  return motion == Motion::Walk || motion == Motion::Brake;
}
enum class RobotTreatment : std::uint8_t { Pedestrian, Obstacle };

/// The one motion of one person in one step.
struct Intent {
  GoalItem target;                 // Walk
  Vec2 extraForce = Vec2::Zero();  // Walk: added to the forces of the model [m/s²]
  double speed = 0.0;              // Walk: desired speed v0 [m/s]
  double heading = 0.0;            // Turn [rad]
  double turnRate = base::kPi;     // limit while turning [rad/s]
  Motion motion = Motion::Stand;
  bool targetIsGoal = false;  // the target is the front of the person's own goals
  RobotTreatment robot = RobotTreatment::Pedestrian;
  bool active = false;  // a reaction or social action runs (column `state`)
};

/// Where behaviours write. One intent per person; `control` may be read and written at any time
/// during `decide`.
class Intents {
 public:
  explicit Intents(std::vector<HumanControl>& controls)
      : controls_(controls), intents_(controls.size()) {}
  void reset() {
    intents_.assign(controls_.size(), Intent{});
    events_.clear();
  }

  Intent& of(int human) { return intents_[static_cast<std::size_t>(human)]; }
  const Intent& of(int human) const { return intents_[static_cast<std::size_t>(human)]; }
  HumanControl& control(int human) { return controls_[static_cast<std::size_t>(human)]; }
  void emit(Event event) { events_.push_back(std::move(event)); }
  std::vector<Event>& events() { return events_; }

 private:
  std::vector<HumanControl>& controls_;
  std::vector<Intent> intents_;
  std::vector<Event> events_;
};

/// Decides what people want, once per step, in the order of their ids. The world owns goals that
/// are reached by walking: it removes (or rotates) the front goal when a step of Motion::Walk with
/// `targetIsGoal` ends inside its radius. A behaviour that takes a reached goal off the list itself
/// emits `goal`, and `arrived` when it was the last of a one-way list; to the world (wait, at_end)
/// these mean the same as its own.
class HumanBehavior {
 public:
  virtual ~HumanBehavior() = default;
  /// A person comes into the world (start, source, restart): a fresh mind.
  virtual void enter(int human, const WorldView& view) = 0;
  virtual void decide(const WorldView& view, Intents& intents) = 0;
  /// Changes of tree nodes in the last step, by id, then node.
  virtual void takeTreeChanges(TreeChanges& changes) { changes.clear(); }
  /// What went wrong since the last call (a faulty tree, an id that nobody has), once per cause.
  virtual void takeDiagnostics(base::Diagnostics& found) { found.clear(); }
  /// Tree and blackboard of a person for display: "key = value" lines; may be empty.
  virtual std::vector<std::pair<std::string, std::string>> blackboard(int /*human*/) const {
    return {};
  }
  /// Gives an entry of that list another value, from a text, before the next step. What is wrong
  /// with it; empty: it has it.
  virtual std::string setEntry(int /*human*/, const std::string& /*key*/,
                               const std::string& /*text*/) {
    return "people have no blackboards here";
  }
  /// From the next step on, instead of those before.
  virtual void setBreakpoints(const std::vector<TreeBreakpoint>& /*points*/) {}
  /// The first that was met since the last call.
  virtual std::optional<TreeBreak> takeBreak() { return std::nullopt; }
};

}  // namespace sim2d
