#include "editor/panels/runs/BranchDialog.h"

#include <limits>

#include "app/run/ProgramRegistries.h"
#include "editor/look/Form.h"
#include "editor/panels/runs/Playback.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr double kFastestRobot = 10.0;  // [m/s]

}  // namespace

BranchDialog::BranchDialog(const sim2d::TraceHeader& header, double time, const QString& name,
                           const Theme& theme, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(name, this)),
      drawsNewSeed_(new QCheckBox(tr("New random seed"), this)),
      seed_(new QSpinBox(this)) {
  setWindowTitle(tr("Branch from %1").arg(clockText(time)));
  auto* layout = configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 12);
  QLabel* says = secondaryLabel(
      tr("Creates a branch that repeats the run up to this moment and pauses. Without changes, the "
         "branch is identical to the displayed run."),
      this);
  says->setWordWrap(true);
  layout->addWidget(says);
  auto* section = new FormSection(tr("From then on"), this);
  name_->setAccessibleName(tr("Branch name"));
  section->addRow(tr("Name"), name_);
  const std::vector<std::string> planners = app::builtinRegistries().planners.names();
  for (const sim2d::TraceRobot& robot : header.robots) {
    RobotRow row{robot.name, robot.maxVel, new ChoiceField(section),
                 new NumberField({0.0, kFastestRobot, 2, 0.1, true}, tr("m/s"), section)};
    for (const std::string& planner : planners) {
      if (planner != "external") {
        row.planner->addItem(QString::fromStdString(planner));
      }
    }
    row.planner->setCurrentText(QString::fromStdString(robot.planner));
    row.planner->setAccessibleName(tr("Planner of %1").arg(QString::fromStdString(robot.name)));
    row.planner->setProperty("before", row.planner->currentText());
    row.speed->show(robot.maxVel, false);
    row.speed->setAccessibleName(tr("Top speed of %1").arg(QString::fromStdString(robot.name)));
    section->addRow(QString::fromStdString(robot.name), row.planner, row.speed);
    robots_.push_back(row);
  }
  seed_->setRange(0, std::numeric_limits<int>::max());
  seed_->setValue(static_cast<int>(header.seed) + 1);
  seed_->setEnabled(false);
  seed_->setAccessibleName(tr("Seed"));
  connect(drawsNewSeed_, &QCheckBox::toggled, seed_, &QSpinBox::setEnabled);
  section->addRow(QString(), drawsNewSeed_);
  section->addRow(tr("Seed"), seed_);
  layout->addWidget(section);
  layout->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Create"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  setFont(theme.font());
  resize(440, sizeHint().height());
  name_->setFocus();
  name_->selectAll();
}

app::RunSpec BranchDialog::changes() const {
  app::RunSpec options;
  for (const RobotRow& row : robots_) {
    if (row.planner->currentText() != row.planner->property("before").toString()) {
      options.set.push_back(row.name + ".planner=" + row.planner->currentText().toStdString());
    }
    if (row.speed->value() != row.maxVel) {
      options.set.push_back(row.name + ".max_vel=" + base::formatDouble(row.speed->value()));
    }
  }
  if (drawsNewSeed_->isChecked()) {
    options.seed = seed_->value();
  }
  return options;
}

}  // namespace editor
