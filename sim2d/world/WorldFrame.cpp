#include "sim2d/world/WorldFrame.h"

#include <tuple>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

bool precedes(const Event& a, const Event& b) {
  return std::make_tuple(a.kind, a.hasId ? a.id : 0) < std::make_tuple(b.kind, b.hasId ? b.id : 0);
}

template <class... Columns>
void clearAll(Columns&... columns) {
  (columns.clear(), ...);
}

template <class... Columns>
void reserveAll(std::size_t count, Columns&... columns) {
  (columns.reserve(count), ...);
}

/// Growing up by doubling would need up to three times the memory.
void reserveFirst(std::size_t count, Frame& frame) {
  HumanColumns& humans = frame.humans;
  if (humans.id.capacity() == 0) {
    reserveAll(count, humans.id, humans.x, humans.y, humans.heading, humans.vx, humans.vy,
               humans.omega, humans.group, humans.state, humans.goal);
  }
}

void clear(HumanColumns& humans) {
  clearAll(humans.id, humans.x, humans.y, humans.heading, humans.vx, humans.vy, humans.omega,
           humans.group, humans.state, humans.goal);
}

void clear(RobotColumns& robots) {
  clearAll(robots.id, robots.x, robots.y, robots.heading, robots.vx, robots.vy, robots.omega,
           robots.goal);
}

/// Leaves those of people who are present; who came in after the step has none yet.
void keepPresent(const std::vector<char>& present, std::vector<Vec2>& column) {
  column.resize(present.size(), Vec2::Zero());
  std::size_t count = 0;
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i] == 0) {
      continue;
    }
    if (count != i) {  // mostly nobody is missing
      column[count] = column[i];
    }
    ++count;
  }
  column.resize(count);
}

void appendPerson(const WorldModel& model, const WorldState& state, std::size_t i,
                  HumanColumns& humans) {
  const HumanControl& control = state.controls[i];
  humans.id.push_back(model.people[i].constants.id);
  humans.x.push_back(state.x[i]);
  humans.y.push_back(state.y[i]);
  humans.heading.push_back(state.heading[i]);
  humans.vx.push_back(state.vx[i]);
  humans.vy.push_back(state.vy[i]);
  humans.omega.push_back(state.omega[i]);
  humans.group.push_back(control.group >= 0 ? control.group : -1);
  humans.state.push_back(static_cast<std::uint8_t>(state.active[i]));
  const bool hasGoal = !control.goals.empty() && control.goals.front().id > 0;
  humans.goal.push_back(hasGoal ? control.goals.front().id : kNoGoal);
}

void appendRobot(const ResolvedRobot& constants, const RobotState& robot, RobotColumns& robots) {
  robots.id.push_back(constants.id);
  robots.x.push_back(robot.pose.position.x());
  robots.y.push_back(robot.pose.position.y());
  robots.heading.push_back(robot.pose.heading);
  robots.vx.push_back(robot.velocity.x());
  robots.vy.push_back(robot.velocity.y());
  robots.omega.push_back(robot.omega);
  const int goal = robot.goal < constants.goals.size() ? constants.goalIds[robot.goal] : 0;
  robots.goal.push_back(goal > 0 ? goal : kNoGoal);
}

}  // namespace

void fillFrame(const WorldModel& model, WorldState& state, Frame& frame) {
  frame.step = state.step;
  frame.time = state.time;
  clear(frame.humans);
  clear(frame.robots);
  reserveFirst(model.people.size(), frame);
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    if (state.present[i] == 0) {
      continue;
    }
    appendPerson(model, state, i, frame.humans);
  }
  if (state.step > 0) {
    ForceColumns& forces = frame.forces;
    for (std::vector<Vec2>* column :
         {&forces.goal, &forces.social, &forces.obstacle, &forces.group}) {
      keepPresent(state.present, *column);
    }
  }
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    appendRobot(model.robots[i], state.robots[i], frame.robots);
  }
  std::swap(frame.events, state.events);
  sortStably(frame.events, precedes);
  frame.doorOpen = state.doorOpen;
}

}  // namespace sim2d
