#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/map/CostGrid.h"
#include "sim2d/trace/Inputs.h"

namespace sim2d {

using base::Vec2;

constexpr int kNoGoal = -1;  // column `goal` when there is none (written empty)

/// State of the robots: -1, -2 … or, as part of theirs, of the people in the world, by ascending
/// id. World frame; [m], [rad], [m/s], [rad/s].
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
  /// visit(pointer to member) for each column.
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
bool operator==(const BodyColumns& a, const BodyColumns& b);
using RobotColumns = BodyColumns;

struct HumanColumns : BodyColumns {
  std::vector<int> group;           // -1 = none
  std::vector<std::uint8_t> state;  // 1 while a reaction or social action runs

  template <class Visit>
  static void eachColumn(Visit visit) {
    BodyColumns::eachColumn(visit);
    visit(&HumanColumns::group);
    visit(&HumanColumns::state);
  }
};
bool operator==(const HumanColumns& a, const HumanColumns& b);

/// Terms of the force on each person [m/s²] in the step that led to this state; the sum of the
/// terms is what moved the person. Empty in step 0 and after a step that failed.
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
bool operator==(const ForceColumns& a, const ForceColumns& b);

/// Calls visit(column) for each of the columns.
template <class Columns, class Visit>
void forEachColumn(Columns& columns, Visit visit) {
  Columns::eachColumn([&](auto column) { visit(columns.*column); });
}

enum class EventKind {  // in the order of the file
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
  bool hasId = true;  // doors and the stop of the run have none
  int other = 0;
  bool hasOther = false;
  std::string text;
};
bool operator==(const Event& a, const Event& b);

/// Nodes of behaviour trees that returned another status than in the step before. In the first step
/// nearly all nodes of all people do, so that a change takes four bytes.
class TreeChanges {
 public:
  /// Of all nodes of a tree, by the node's number.
  using Paths = std::shared_ptr<const std::vector<std::string>>;

  /// `id`: of the person whose tree it is.
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
  /// Calls visit(id, paths, node, status) in the order in which they were added.
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
  /// Calls drop(column, items in that column of `usual`) for every column.
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
    std::uint32_t end = 0;  // in nodes_
    Paths paths;
  };
  std::vector<Tree> trees_;
  std::vector<std::uint32_t> nodes_;
};

/// What a robot's sensors and planner told in the step that led to this state, for display. World
/// frame.
struct RobotSenses {
  struct Scan {                     // the last turn of the lidar
    base::Pose2 sensor;             // where the robot takes its sensor to be
    double time = 0.0;              // [s]
    double angleMin = 0.0;          // [rad], of the first beam, in the sensor's frame
    double perBeam = 0.0;           // [rad] between neighbours, counter-clockwise
    double range = 30.0;            // [m]; beams without a hit have it
    std::vector<double> distances;  // [m]
  };
  struct LaterScan {                    // of a turn that nobody has looked at
    double time = 0.0;                  // [s]
    std::function<const Scan&()> make;  // once, and lives as long as this; any thread
  };
  struct Body {  // a track of its detector
    int id = 0;
    bool isRobot = false;
    Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();  // [m], [m/s]
    double radius = 0.35;                                   // [m]
  };
  struct Way {                 // one that the planner weighed
    std::vector<Vec2> points;  // [m], the robot's place first
    double cost = 0.0;         // the less the better; infinite: would hit something
    bool isChosen = false;
    std::vector<std::pair<std::string, double>> scores{};  // parts of the cost; none: not told
  };

  struct Localizer {           // what a localiser publishes
    bool isLocalized = false;  // a correction has come
    base::Pose2 mapToOdom;     // the frame odom in the map
  };

  base::Pose2 believed;                        // in the map, as the robot estimates it
  std::optional<Localizer> localizer;          // none: the robot has none
  std::optional<Scan> scan;                    // none: no lidar, not turned yet, or for later
  std::shared_ptr<const LaterScan> laterScan;  // instead of it; where scans alone are told
  std::vector<Body> bodies;
  std::vector<Way> ways;
  CostGridPtr localCosts, globalCosts;  // of its planner, while somebody looks at them
  std::string controller;               // that drives, where a planner has several
  std::vector<Vec2> lookahead;          // what it aims at
  std::vector<Vec2> predicted;          // where it means to go
};

/// A turn of a lidar that the run records: a row of `scans.csv`.
struct RecordedScan {
  std::int64_t step = 0;  // whose state was looked at: mostly that before the frame it came with
  int robot = -1;
  RobotSenses::Scan scan;
};

/// One instant: the state after step `step`. Immutable once published; what canvas, recorder and
/// metrics read.
struct Frame {
  std::int64_t step = 0;
  double time = 0.0;  // [s], step * dt
  HumanColumns humans;
  RobotColumns robots;
  ForceColumns forces;
  std::vector<Event> events;                  // of this step, ordered by kind, then id
  StepInputs inputs;                          // that led to this state; nearly always none
  TreeChanges treeChanges;                    // of this step, by id, then node
  std::vector<std::vector<Vec2>> robotPaths;  // what the planners follow now, per robot
  std::shared_ptr<const std::vector<RobotSenses>> senses;  // per robot; null: nobody asked for it
  /// What people follow from here on, one per person: way points [m] still to be walked to, none
  /// for who heads straight on or stands. For display; null: nobody asked for it.
  std::shared_ptr<const std::vector<std::vector<Vec2>>> humanPaths;
  std::vector<RecordedScan> scans;  // made in the step that led to this state
  std::vector<char> doorOpen;
};

}  // namespace sim2d
