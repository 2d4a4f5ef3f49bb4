#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/map/CostGrid.h"

namespace sim2d {

enum class InputKind {
  Robot,  // a velocity command that replaces the planner's; for planner `teleop` the latest command
  Open,   // opens a door
  Close,
  Move,  // moves a person or robot to a pose, at rest
  Add,   // spawns a copy of a person
  Set,   // sets position, velocity and desired velocity of a person
  Push,  // adds a velocity to a person's own for one step
  Stop,  // a person brakes and stays until Resume or until they enter again
  Resume,
  Entry,  // sets an entry of a person's blackboard before the tree is ticked
  Goal    // a robot drives to a position and abandons its scenario goals
};
const char* inputKindName(InputKind kind);  // "robot" …

/// An external input to a running world in one step. Members that the kind does not use are 0.
struct Input {
  InputKind kind = InputKind::Move;
  int id = 0;        // of the robot (-1, -2 …) or person; Add: the new person's
  std::string name;  // of the door; Add: name of the person copied; Entry: "key=value"
  base::Pose2 pose;  // Move, Add, Set, Goal (heading ignored)
  base::Vec2 velocity = {0.0, 0.0};      // Set, Push [m/s]; Robot: x ahead, y to its left
  double omega = 0.0;                    // Robot [rad/s]
  base::Vec2 desiredVelocity{0.0, 0.0};  // Set [m/s]
};
bool operator==(const Input& a, const Input& b);

/// The inputs of one step, in the order of application.
using StepInputs = std::vector<Input>;
/// Each with the step that it led to, as in Frame::step.
using RecordedInputs = std::vector<std::pair<std::int64_t, Input>>;

/// The inputs that led to `step`.
StepInputs inputsOf(const RecordedInputs& inputs, std::int64_t step);

/// Rows of `inputs.csv` (columns: FORMAT.md); reading returns equal values.
std::string inputsHeader();
void appendInputRow(std::string& to, std::int64_t step, const Input& input);
/// Reports all problems with their places; steps must not decrease.
base::Result<RecordedInputs> parseInputs(const std::string& text, const std::string& file);

using base::Vec2;

constexpr int kNoGoal = -1;  // value of `goal` without a goal (written as empty field)

/// States of bodies by ascending id: of robots (-1, -2 …), or as base of HumanColumns of people.
/// World frame; [m], [rad], [m/s], [rad/s].
struct BodyColumns {
  std::vector<int> id;
  std::vector<double> x, y, heading, vx, vy, omega;
  std::vector<int> goal;  // id of the current global goal or kNoGoal

  std::size_t size() const { return id.size(); }
  void add(int body, const base::Pose2& pose, const Vec2& velocity, double turning, int itsGoal) {
    id.push_back(body);
    x.push_back(pose.position.x());
    y.push_back(pose.position.y());
    heading.push_back(pose.heading);
    vx.push_back(velocity.x());
    vy.push_back(velocity.y());
    omega.push_back(turning);
    goal.push_back(itsGoal);
  }
  /// Calls visit(pointer to member) for each column.
  template <class Visit>
  static void eachColumn(Visit visit) {
    using T = BodyColumns;
    visit(&T::id);
    visit(&T::x);
    visit(&T::y);
    visit(&T::heading);
    visit(&T::vx);
    visit(&T::vy);
    visit(&T::omega);
    visit(&T::goal);
  }
};
using RobotColumns = BodyColumns;

struct HumanColumns : BodyColumns {
  std::vector<int> group;           // -1 = none
  std::vector<std::uint8_t> state;  // 1 during a reaction or social action

  template <class Visit>
  static void eachColumn(Visit visit) {
    BodyColumns::eachColumn(visit);
    visit(&HumanColumns::group);
    visit(&HumanColumns::state);
  }
};

/// Components of the force on each person [m/s²] in the step that led to this state; their sum
/// moved the person. Empty in step 0 and after a failed step.
struct ForceColumns {
  std::vector<Vec2> goal, social, obstacle, group;

  template <class Visit>
  static void eachColumn(Visit visit) {
    using T = ForceColumns;
    visit(&T::goal);
    visit(&T::social);
    visit(&T::obstacle);
    visit(&T::group);
  }
};

/// Compares all columns.
template <class Columns>
auto operator==(const Columns& a, const Columns& b) -> decltype(Columns::eachColumn(0), bool()) {
  bool isSame = true;
  Columns::eachColumn([&](auto column) { isSame = isSame && a.*column == b.*column; });
  return isSame;
}

/// Calls visit(column) for each column.
template <class Columns, class Visit>
void forEachColumn(Columns& columns, Visit visit) {
  Columns::eachColumn([&](auto column) { visit(columns.*column); });
}

enum class EventKind {  // in the order of events.csv
  Enter,
  Leave,
  Goal,
  Arrived,
  Contact,
  Say,
  Heard,
  Action,
  ActionEnd,
  Group,
  Replan,
  Stuck,
  NavigationSucceeded,
  NavigationFailed,
  Door,
  Stop,
  Dock,
  Photo,
  Battery
};
constexpr int kEventKinds = 19;
const char* eventKindName(EventKind kind);  // "enter" …
std::optional<EventKind> eventKindOf(std::string_view name);

struct Event {
  EventKind kind = EventKind::Enter;
  int id = 0;
  bool hasId = true;  // false: doors, end of the run
  int other = 0;
  bool hasOther = false;
  std::string text;

  friend bool operator==(const Event& a, const Event& b) {
    return a.kind == b.kind && a.id == b.id && a.hasId == b.hasId && a.other == b.other &&
           a.hasOther == b.hasOther && a.text == b.text;
  }
};

/// Text of the event `arrived` when a robot reaches a position given by the input `goal` instead of
/// a goal of the scenario.
constexpr char kOrderText[] = "order";

/// Whether the robot has reached the last of its own goals.
inline bool isRobotArrival(const Event& event, int robotId) {
  return event.kind == EventKind::Arrived && event.hasId && event.id == robotId &&
         event.text != kOrderText;
}

/// Behaviour-tree nodes whose status changed in a step. In the first step almost all nodes change,
/// so each change is packed into four bytes.
class TreeChanges {
 public:
  /// Paths of all nodes of a tree, by node number.
  using Paths = std::shared_ptr<const std::vector<std::string>>;

  /// `id`: the person that owns the tree.
  void add(int id, const Paths& paths, int node, base::NodeStatus status) {
    if (trees_.empty() || trees_.back().id != id || trees_.back().paths != paths) {
      trees_.push_back({id, 0, paths});
    }
    nodes_.push_back(static_cast<std::uint32_t>(node) << kStatusBits |
                     static_cast<std::uint32_t>(status));
    trees_.back().end = static_cast<std::uint32_t>(nodes_.size());
  }
  void append(const TreeChanges& later) {
    later.forEach([this](int id, const Paths& paths, int node, base::NodeStatus status) {
      add(id, paths, node, status);
    });
  }
  /// Calls visit(id, paths, node, status) in insertion order.
  template <class Visit>
  void forEach(Visit visit) const {
    std::uint32_t at = 0;
    for (const Tree& tree : trees_) {
      for (; at < tree.end; ++at) {
        visit(tree.id, tree.paths, static_cast<int>(nodes_[at] >> kStatusBits),
              static_cast<base::NodeStatus>(nodes_[at] & kStatusMask));
      }
    }
  }
  std::size_t size() const { return nodes_.size(); }
  void clear() {
    trees_.clear();
    nodes_.clear();
  }
  /// Calls drop(column, size of that column in `usual`) for each column.
  template <class Drop>
  void forColumns(const TreeChanges& usual, Drop drop) {
    drop(trees_, usual.trees_.size());
    drop(nodes_, usual.nodes_.size());
  }

 private:
  static constexpr std::uint32_t kStatusBits = 3;
  static constexpr std::uint32_t kStatusMask = 7;
  struct Tree {
    int id = 0;
    std::uint32_t end = 0;  // index in nodes_
    Paths paths;
  };
  std::vector<Tree> trees_;
  std::vector<std::uint32_t> nodes_;
};

/// Sensor data and planner output of a robot in the step that led to this state, for display. World
/// frame.
struct RobotTelemetry {
  struct Scan {                     // the last complete lidar scan
    base::Pose2 sensor;             // sensor pose as estimated by the robot
    double time = 0.0;              // [s]
    double angleMin = 0.0;          // [rad], of the first beam, in the sensor's frame
    double angleIncrement = 0.0;    // [rad] between beams, counter-clockwise
    double range = 30.0;            // [m], distance of beams without a hit
    std::vector<double> distances;  // [m]
  };
  struct DeferredScan {                 // a scan that is computed on demand
    double time = 0.0;                  // [s]
    std::function<const Scan&()> make;  // evaluated once; valid with this; thread-safe
  };
  struct Body {  // a track of the detector
    int id = 0;
    bool isRobot = false;
    Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();  // [m], [m/s]
    double radius = 0.35;                                   // [m]
  };
  struct Candidate {           // a candidate trajectory of the planner
    std::vector<Vec2> points;  // [m], begins at the robot
    double cost = 0.0;         // lower is better; infinite: collision
    bool isChosen = false;
    std::vector<std::pair<std::string, double>> scores{};  // terms of the cost; may be empty
  };

  struct Localizer {           // output of the localizer
    bool isLocalized = false;  // a correction was received
    base::Pose2 mapToOdom;     // pose of the frame odom in map
  };

  base::Pose2 believed;                              // estimated pose in the map
  std::optional<Localizer> localizer;                // none: no localizer
  std::optional<Scan> scan;                          // none: no lidar, no scan yet, or deferred
  std::shared_ptr<const DeferredScan> deferredScan;  // deferred scan, if only scans are requested
  std::vector<Body> bodies;
  std::vector<Candidate> ways;
  CostGridPtr localCosts, globalCosts;  // costmaps, while they are displayed
  std::vector<MaskGrid> masks;          // of costmap filters, while they are displayed
  std::string controller;               // active controller, if there are several
  std::vector<Vec2> lookahead;          // lookahead points
  std::vector<Vec2> predicted;          // predicted path
};

/// A recorded lidar scan: a row of `scans.csv`.
struct RecordedScan {
  std::int64_t step = 0;  // the scanned state, mostly the one before the frame it is stored in
  int robot = -1;
  RobotTelemetry::Scan scan;
};

/// The state after step `step`. Immutable once published; read by canvas, recorder and metrics.
struct Frame {
  std::int64_t step = 0;
  double time = 0.0;  // [s], step * dt
  HumanColumns humans;
  RobotColumns robots;
  ForceColumns forces;
  std::vector<Event> events;                  // of this step, ordered by kind, then id
  StepInputs inputs;                          // inputs that led to this state; usually none
  TreeChanges treeChanges;                    // of this step, by id, then node
  std::vector<std::vector<Vec2>> robotPaths;  // current path of each planner, per robot
  std::shared_ptr<const std::vector<RobotTelemetry>> senses;  // per robot; null: not requested
  /// Remaining waypoints [m] of each person; empty for people who walk straight or stand. For
  /// display; null: not requested.
  std::shared_ptr<const std::vector<std::vector<Vec2>>> humanPaths;
  std::vector<RecordedScan> scans;  // completed in the step that led to this state
  std::vector<char> doorOpen;
};

}  // namespace sim2d
