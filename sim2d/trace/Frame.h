#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim2d/base/Types.h"

namespace sim2d {

using base::Vec2;

constexpr int kNoGoal = -1;  // column `goal` when there is none (written empty)

/// State of the people in the world, by ascending id. World frame; [m], [rad], [m/s], [rad/s].
struct HumanColumns {
  std::vector<int> id;
  std::vector<double> x, y, heading, vx, vy, omega;
  std::vector<int> group;           // -1 = none
  std::vector<std::uint8_t> state;  // 1 while a reaction or social action runs
  std::vector<int> goal;            // id of the current global goal or kNoGoal
  std::size_t size() const { return id.size(); }
  friend bool operator==(const HumanColumns& a, const HumanColumns& b) {
    return std::tie(a.id, a.x, a.y, a.heading, a.vx, a.vy, a.omega, a.group, a.state, a.goal) ==
           std::tie(b.id, b.x, b.y, b.heading, b.vx, b.vy, b.omega, b.group, b.state, b.goal);
  }
};

/// State of the robots: -1, -2 …
struct RobotColumns {
  std::vector<int> id;
  std::vector<double> x, y, heading, vx, vy, omega;
  std::vector<int> goal;
  std::size_t size() const { return id.size(); }
  friend bool operator==(const RobotColumns& a, const RobotColumns& b) {
    return std::tie(a.id, a.x, a.y, a.heading, a.vx, a.vy, a.omega, a.goal) ==
           std::tie(b.id, b.x, b.y, b.heading, b.vx, b.vy, b.omega, b.goal);
  }
};

/// Terms of the force on each person [m/s²] in the step that led to this state; the sum of the
/// terms is what moved the person. Empty in step 0.
struct ForceColumns {
  std::vector<Vec2> goal, social, obstacle, group;
};

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
  Door,
  Stop
};
constexpr int kEventKinds = 14;
const char* eventKindName(EventKind kind);  // "enter" …
std::optional<EventKind> eventKindOf(std::string_view name);

struct Event {
  EventKind kind = EventKind::Enter;
  int id = 0;
  bool hasId = true;  // doors and the stop of the run have none
  int other = 0;
  bool hasOther = false;
  std::string text;
  friend bool operator==(const Event& a, const Event& b) {
    return std::tie(a.kind, a.id, a.hasId, a.other, a.hasOther, a.text) ==
           std::tie(b.kind, b.id, b.hasId, b.other, b.hasOther, b.text);
  }
};

/// A node of a behaviour tree returned another status than in the step before.
struct TreeChange {
  int id = 0;                                             // of the person
  std::shared_ptr<const std::vector<std::string>> paths;  // of all nodes of the tree
  int node = 0;
  base::NodeStatus status = base::NodeStatus::Idle;
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
  std::vector<TreeChange> treeChanges;        // of this step, by id, then node
  std::vector<std::vector<Vec2>> robotPaths;  // what the planners follow now, per robot
  std::vector<char> doorOpen;
};

}  // namespace sim2d
