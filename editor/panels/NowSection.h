#pragma once

#include <optional>

#include <QLabel>

#include "editor/look/Form.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// How a person or robot is doing in the frame that is shown: place, heading, speed, goal and the
/// distance to the robot. Hidden while there is no run.
class NowSection : public QWidget {
  Q_OBJECT
 public:
  explicit NowSection(QWidget* parent = nullptr);
  /// `agent` as in frames: people by id, robots negative.
  void show(const sim2d::Frame* frame, std::optional<int> agent);

 private:
  void showPerson(const sim2d::Frame& frame, std::size_t index);
  void showRobot(const sim2d::Frame& frame, std::size_t index);
  FormSection* section_;
  QLabel *position_, *heading_, *speed_, *goal_, *robot_;
};

}  // namespace editor
