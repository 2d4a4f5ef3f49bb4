#include "editor/panels/NowSection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/canvas/Tool.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

/// Where it drives in a run: a goal by its number, or the point that it has instead.
QString goalOfRobot(const sim2d::Robot& robot, int goal, const base::Vec2& at) {
  const std::optional<base::Vec2>& point = robot.goal.point;
  if (goal > 0) {
    return goalName(goal);
  }
  if (!point) {
    return robot.goal.goals.empty() ? QObject::tr("none") : QObject::tr("all visited");
  }
  const double radius = sim2d::resolveRobot({}, robot, -1).goalRadius;
  return (*point - at).norm() <= radius ? QObject::tr("%1, reached").arg(placeText(*point))
                                        : placeText(*point);
}

}  // namespace

NowSection::NowSection(QWidget* parent) : FormSection(tr("Now"), parent) {
  addRow(tr("Position"), position_);
  addRow(tr("Heading"), heading_);
  addRow(tr("Speed"), speed_);
  addRow(tr("Goal"), goal_);
  addRow(tr("Robot"), robot_);
  drive_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  addRow(tr("By hand"), drive_);
  setRowVisible(drive_, false);
  hide();
}

void NowSection::offerDrive(QAction* drive) {
  drive_->setDefaultAction(drive);
}

void NowSection::show(const sim2d::Frame* frame, std::optional<int> agent,
                      const sim2d::Robot* robot) {
  setVisible(frame != nullptr && agent &&
             (robot != nullptr ? showRobot(*frame, *agent, *robot) : showPerson(*frame, *agent)));
}

/// What people and robots have in common; the place in the columns, none = not in the frame.
template <class Columns>
std::optional<std::size_t> NowSection::showBody(const Columns& bodies, int id) {
  const auto found = std::find(bodies.id.begin(), bodies.id.end(), id);
  if (found == bodies.id.end()) {
    return std::nullopt;
  }
  const auto i = static_cast<std::size_t>(found - bodies.id.begin());
  const double speed = std::sqrt(bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]);
  const double degrees = bodies.heading[i] * 180.0 / base::kPi;
  position_->setText(placeText({bodies.x[i], bodies.y[i]}));
  heading_->setText(QStringLiteral("%1°").arg(degrees, 0, 'f', 1));
  speed_->setText(QStringLiteral("%1 m/s").arg(speed, 0, 'f', 2));
  goal_->setText(bodies.goal[i] == sim2d::kNoGoal ? tr("none") : goalName(bodies.goal[i]));
  return i;
}

bool NowSection::showPerson(const sim2d::Frame& frame, int id) {
  const sim2d::HumanColumns& people = frame.humans;
  const std::optional<std::size_t> index = showBody(people, id);
  if (!index) {
    return false;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    const double dx = frame.robots.x[i] - people.x[*index];
    const double dy = frame.robots.y[i] - people.y[*index];
    nearest = std::min(nearest, std::sqrt(dx * dx + dy * dy));
  }
  setRowVisible(drive_, false);
  setNote(people.state[*index] != 0 ? tr("reacting") : QString());
  setRowVisible(robot_, frame.robots.size() > 0);
  robot_->setText(tr("%1 m away").arg(nearest, 0, 'f', 2));
  return true;
}

bool NowSection::showRobot(const sim2d::Frame& frame, int id, const sim2d::Robot& robot) {
  const sim2d::RobotColumns& robots = frame.robots;
  const std::optional<std::size_t> index = showBody(robots, id);
  if (index) {
    const base::Vec2 at(robots.x[*index], robots.y[*index]);
    goal_->setText(goalOfRobot(robot, robots.goal[*index], at));
  }
  setNote({});
  setRowVisible(robot_, false);
  setRowVisible(drive_, drive_->defaultAction() != nullptr && drive_->defaultAction()->isEnabled());
  return index.has_value();
}

}  // namespace editor
