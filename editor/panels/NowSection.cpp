#include "editor/panels/NowSection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QVBoxLayout>

#include "sim2d/base/Types.h"

namespace editor {

namespace {

QString metres(double x, double y) {
  return QStringLiteral("%1, %2 m").arg(x, 0, 'f', 2).arg(y, 0, 'f', 2);
}

QString degrees(double radians) {
  return QStringLiteral("%1°").arg(radians * 180.0 / base::kPi, 0, 'f', 1);
}

QString metresPerSecond(double vx, double vy) {
  return QStringLiteral("%1 m/s").arg(std::sqrt(vx * vx + vy * vy), 0, 'f', 2);
}

}  // namespace

NowSection::NowSection(QWidget* parent)
    : QWidget(parent), section_(new FormSection(tr("Now"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(section_);
  const auto add = [this](const QString& label) {
    auto* value = new QLabel(this);
    section_->addRow(label, value);
    return value;
  };
  position_ = add(tr("Position"));
  heading_ = add(tr("Heading"));
  speed_ = add(tr("Speed"));
  goal_ = add(tr("Goal"));
  robot_ = add(tr("Robot"));
  hide();
}

void NowSection::show(const sim2d::Frame* frame, std::optional<int> agent) {
  const auto place = [](const std::vector<int>& ids, int id) {
    return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  };
  bool shown = false;
  if (frame != nullptr && agent) {
    const std::size_t human = place(frame->humans.id, *agent);
    const std::size_t robot = place(frame->robots.id, *agent);
    if (human < frame->humans.size()) {
      showPerson(*frame, human);
      shown = true;
    } else if (robot < frame->robots.size()) {
      showRobot(*frame, robot);
      shown = true;
    }
  }
  setVisible(shown);
}

void NowSection::showPerson(const sim2d::Frame& frame, std::size_t index) {
  const sim2d::HumanColumns& people = frame.humans;
  position_->setText(metres(people.x[index], people.y[index]));
  heading_->setText(degrees(people.heading[index]));
  speed_->setText(metresPerSecond(people.vx[index], people.vy[index]));
  const int goal = people.goal[index];
  goal_->setText(goal == sim2d::kNoGoal ? tr("none") : QString::number(goal));
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    const double dx = frame.robots.x[i] - people.x[index];
    const double dy = frame.robots.y[i] - people.y[index];
    nearest = std::min(nearest, std::sqrt(dx * dx + dy * dy));
  }
  section_->setNote(people.state[index] != 0 ? tr("reacting") : QString());
  section_->setRowVisible(robot_, frame.robots.size() > 0);
  robot_->setText(tr("%1 m away").arg(nearest, 0, 'f', 2));
}

void NowSection::showRobot(const sim2d::Frame& frame, std::size_t index) {
  const sim2d::RobotColumns& robots = frame.robots;
  position_->setText(metres(robots.x[index], robots.y[index]));
  heading_->setText(degrees(robots.heading[index]));
  speed_->setText(metresPerSecond(robots.vx[index], robots.vy[index]));
  const int goal = robots.goal[index];
  goal_->setText(goal == sim2d::kNoGoal ? tr("none")
                 : goal == 0            ? tr("its point")
                                        : QString::number(goal));
  section_->setNote({});
  section_->setRowVisible(robot_, false);
}

}  // namespace editor
