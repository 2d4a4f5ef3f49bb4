#pragma once

#include <optional>

#include "editor/look/Form.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/trace/Frame.h"

namespace editor {

/// How a person or robot is doing in the frame that is shown: place, heading, speed, goal and the
/// distance to the robot. Hidden while there is no run.
class NowSection : public FormSection {
 public:
  explicit NowSection(QWidget* parent);
  /// What drives the robot that is shown; its button is there while it can be used.
  void offerDrive(QAction* drive);
  /// `agent` as in frames: people by id, robots negative; `robot`: what it is then.
  void show(const sim2d::Frame* frame, std::optional<int> agent, const sim2d::Robot* robot);

 private:
  template <class Columns>
  std::optional<std::size_t> showBody(const Columns& bodies, int id);
  bool showPerson(const sim2d::Frame& frame, int id);
  bool showRobot(const sim2d::Frame& frame, int id, const sim2d::Robot& robot);

  QLabel* position_ = new QLabel(this);
  QLabel* heading_ = new QLabel(this);
  QLabel* speed_ = new QLabel(this);
  QLabel* goal_ = new QLabel(this);
  QLabel* robot_ = new QLabel(this);
  QToolButton* drive_ = new QToolButton(this);
};

}  // namespace editor
