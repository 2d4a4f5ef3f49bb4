#pragma once

#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include "app/run/RunOptions.h"
#include "editor/look/Fields.h"
#include "editor/look/Theme.h"
#include "sim2d/trace/Trace.h"

namespace editor {

/// How a run goes on from a moment: with other planners and speeds of robots, and another seed of
/// what is drawn, or with nothing changed.
class ForkDialog : public QDialog {
  Q_OBJECT
 public:
  ForkDialog(const sim2d::TraceHeader& header, double time, const QString& name, const Theme& theme,
             QWidget* parent = nullptr);

  app::RunOptions changes() const;
  QString name() const { return name_->text().trimmed(); }

 private:
  struct RobotRow {
    std::string name;
    double maxVel = 1.0;  // as it is [m/s]
    QComboBox* planner = nullptr;
    NumberField* speed = nullptr;
  };
  std::vector<RobotRow> robots_;
  QLineEdit* name_;
  QCheckBox* draws_;
  QSpinBox* seed_;
};

}  // namespace editor
