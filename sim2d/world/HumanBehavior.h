#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/TreeResults.h"
#include "sim2d/base/Types.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/world/Compatibility.h"

namespace sim2d {

/// A point to walk to. The member order minimises padding.
struct GoalItem {
  Vec2 position = Vec2::Zero();
  double radius = 0.3;  // rho [m]; the goal is reached inside
  int id = 0;           // of the global goal; 0: a plain point

  GoalItem() = default;
  GoalItem(int goal, const Vec2& place, double within = 0.3)
      : position(place), radius(within), id(goal) {}
  friend bool operator==(const GoalItem& a, const GoalItem& b) {
    return a.id == b.id && a.position == b.position && a.radius == b.radius;
  }
};

/// Persistent settings of one person that a behaviour may change, beside the motion of the step.
struct HumanControl {
  std::vector<GoalItem> goals;  // front = current
  bool frozen = false;          // StopMovement: desired speed 0 until resumed
  int group = -1;
};

/// State of the world at the start of the step; it does not change while people decide. People are
/// addressed by index (0 … humanCount() - 1), which is stable for the whole run; those not present
/// (not yet started, left) are skipped. Thread-safe, read-only.
class WorldView {
 public:
  virtual ~WorldView() = default;

  virtual std::int64_t step() const = 0;  // the step being computed, starting at 1
  virtual double time() const = 0;        // at the start of the step [s]
  virtual double dt() const = 0;
  virtual std::uint64_t seed() const = 0;
  virtual const Environment& scenario() const = 0;
  virtual const Compatibility& compatibility() const = 0;

  virtual int humanCount() const = 0;
  virtual bool isPresent(int human) const = 0;
  /// False: the behaviour of this person is not executed in this step.
  virtual bool decides(int /*human*/) const { return true; }
  virtual int indexOf(int humanId) const = 0;  // -1: no such person
  virtual const ResolvedHuman& constants(int human) const = 0;
  /// Index of the person of whom an input made this copy; -1: the person is in the scenario.
  virtual int copiedFrom(int /*human*/) const { return -1; }
  virtual Pose2 pose(int human) const = 0;
  virtual Vec2 velocity(int human) const = 0;
  /// Present people whose centre is within `range`, except `human`, by ascending distance, then id.
  virtual void near(int human, double range, std::vector<int>& found) const = 0;

  virtual int robotCount() const = 0;
  virtual Pose2 robotPose(int robot) const = 0;
  virtual Vec2 robotVelocity(int robot) const = 0;
  virtual double robotRadius(int robot) const = 0;
  virtual int nearestRobot(int human) const = 0;  // -1: none; ties: the first in the list

  virtual std::optional<Vec2> globalGoal(int id) const = 0;
  virtual const Area* area(const std::string& name) const = 0;
  /// Line of sight and of sound: walls, obstacles and closed doors block, bodies do not. Always
  /// true with quirk Q-34.
  virtual bool isVisible(const Vec2& from, const Vec2& to) const = 0;
  /// True if this person's body has a path to the point (always true with `route: direct`).
  virtual bool isReachable(int human, const Vec2& point) const = 0;
  /// Length of this person's path to the point [m]; none if there is no path.
  virtual std::optional<double> pathLength(int human, const Vec2& point) const {
    return isReachable(human, point) ? std::optional<double>((point - pose(human).position).norm())
                                     : std::nullopt;
  }
};

enum class Motion : std::uint8_t {
  Stand,  // v = 0, omega = 0
  Turn,   // in place, towards `heading`
  Walk,   // by the person's model to `target`, along a path around walls if the route is planned
  Brake,  // by the model without a goal
};
inline bool isWalking(Motion motion) {
  return motion == Motion::Walk || motion == Motion::Brake;
}
enum class RobotTreatment : std::uint8_t { Pedestrian, Obstacle };

/// The motion of one person in one step.
struct Intent {
  GoalItem target;                 // Walk
  Vec2 extraForce = Vec2::Zero();  // Walk: added to the forces of the model [m/s²]
  double speed = 0.0;              // Walk: desired speed v0 [m/s]
  double heading = 0.0;            // Turn [rad]
  double turnRate = base::kPi;     // limit while turning [rad/s]
  Motion motion = Motion::Stand;
  bool targetIsGoal = false;  // the target is the front of the person's own goals
  RobotTreatment robot = RobotTreatment::Pedestrian;
  bool active = false;  // a reaction or social action is running (column `state`)
};

/// Output of behaviours: one intent per person. `control` may be read and written at any time
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

/// Stops a run after the step in which a node of a behaviour tree starts to match. The match must
/// end before it stops the run again.
struct TreeBreakpoint {
  std::optional<int> person;               // id; none: any person
  std::string path;                        // of the node, as in trees.csv
  std::optional<base::NodeStatus> status;  // returned status; none: any tick
  std::string condition;  // optional script on the person's blackboard that must also hold

  friend bool operator==(const TreeBreakpoint& a, const TreeBreakpoint& b) {
    return a.person == b.person && a.path == b.path && a.status == b.status &&
           a.condition == b.condition;
  }
};

/// A breakpoint that was hit.
struct TreeBreakpointHit {
  TreeBreakpoint at;
  int person = 0;  // id
  base::NodeStatus status = base::NodeStatus::Idle;
};

/// Decides the intents of people, once per step, in the order of their ids. The world handles goals
/// that are reached by walking: it removes (or rotates) the front goal when a step of Motion::Walk
/// with `targetIsGoal` ends inside its radius. A behaviour that removes a reached goal itself emits
/// `goal`, and `arrived` for the last goal of a one-way list; the world (wait, at_end) treats these
/// like its own.
class HumanBehavior {
 public:
  virtual ~HumanBehavior() = default;
  /// Called when a person enters the world (start, source, restart): initialises the behaviour.
  virtual void enter(int human, const WorldView& view) = 0;
  virtual void decide(const WorldView& view, Intents& intents) = 0;
  /// Status changes of tree nodes in the last step, by id, then node.
  virtual void takeTreeChanges(TreeChanges& changes) { changes.clear(); }
  /// Whether the person's behaviour tree is not the one generated from behaviour and goals.
  virtual bool hasCustomTree(int /*human*/, const WorldView& /*view*/) const { return false; }
  /// What the nodes of people's trees have returned since the beginning; one entry per person.
  virtual std::vector<base::TreeResults> treeResults() const { return {}; }
  /// Problems since the last call (a faulty tree, an unknown id), once per cause.
  virtual void takeDiagnostics(base::Diagnostics& found) { found.clear(); }
  /// Tree and blackboard entries of a person for display, as (key, value); may be empty.
  virtual std::vector<std::pair<std::string, std::string>> blackboard(int /*human*/) const {
    return {};
  }
  /// Sets an entry of that list from a text, before the next step. Returns the problem; empty on
  /// success.
  virtual std::string setBlackboardEntry(int /*human*/, const std::string& /*key*/,
                                         const std::string& /*text*/) {
    return "people have no blackboards in this world";
  }
  /// Replaces the breakpoints, from the next step on.
  virtual void setBreakpoints(const std::vector<TreeBreakpoint>& /*points*/) {}
  /// The first breakpoint hit since the last call.
  virtual std::optional<TreeBreakpointHit> takeBreakpointHit() { return std::nullopt; }
};

}  // namespace sim2d
