#pragma once

#include <vector>

#include <QtWidgets>

#include "app/run/RunSpec.h"
#include "editor/look/Fields.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Trace.h"

namespace editor {

/// Options of a new branch: planners and speeds of robots, and a new random seed; all may be
/// unchanged.
class BranchDialog : public QDialog {
  Q_OBJECT
 public:
  BranchDialog(const sim2d::TraceHeader& header, double time, const QString& name,
               const Theme& theme, QWidget* parent = nullptr);

  app::RunSpec changes() const;
  QString name() const { return name_->text().trimmed(); }

 private:
  struct RobotRow {
    std::string name;
    double maxVel = 1.0;  // Current value [m/s].
    QComboBox* planner = nullptr;
    NumberField* speed = nullptr;
  };
  std::vector<RobotRow> robots_;
  QLineEdit* name_;
  QCheckBox* drawsNewSeed_;
  QSpinBox* seed_;
};

}  // namespace editor
