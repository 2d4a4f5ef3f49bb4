#include "editor/panels/nav2/Nav2Panel.h"

#include <algorithm>

#include "app/run/DataPaths.h"
#include "app/run/Nav2Save.h"
#include "editor/document/EditCommands.h"
#include "sim2d/nav/Planner.h"

namespace editor {

namespace {

constexpr int kHeight = 340;  // [px]
constexpr int kLeastFile = 80;

bool isDrivenByNav2(const sim2d::Robot& robot) {
  return robot.planner == std::string(sim2d::kNav2Planner);
}

}  // namespace

Nav2Panel::Nav2Panel(PanelContext& context) : context_(context) {
  stack_->addWidget(emptyState(tr("No robot is driven by Nav2. Select a robot and choose the "
                                  "planner nav2 in its properties."),
                               this));
  stack_->addWidget(form_);
  makeHead();
  form_->setTheme(context.theme());
  connect(&context, &PanelContext::themeChanged, form_, &Nav2Form::setTheme);
  connect(&context.document, &ScenarioDocument::selectionChanged, this,
          &Nav2Panel::followSelection);
  connect(&context.document, &ScenarioDocument::stepFinished, this, &Nav2Panel::refresh);
  connect(&context.document, &ScenarioDocument::pathChanged, this, &Nav2Panel::refresh);
  connect(&context.document, &ScenarioDocument::runChanged, this, &Nav2Panel::refresh);
  connect(robots_, qOverload<int>(&QComboBox::activated), this, [this](int row) {
    robot_ = EntityId{EntityKind::Robot, robots_->itemData(row).toInt()};
    refresh();
  });
  connect(
      form_, &Nav2Form::edited, this,
      [this](const app::Nav2Parameter& parameter, const std::optional<std::string>& yaml) {
        apply(tr("Change %1").arg(QString::fromStdString(parameter.path)),
              [&](sim2d::Robot& edited) { edited = app::withNav2Value(edited, parameter, yaml); });
      });
  followSelection();
}

void Nav2Panel::makeHead() {
  robots_->setAccessibleName(tr("Robot"));
  robots_->setToolTip(tr("The robot whose parameters are shown"));
  file_->setMinimumWidth(kLeastFile);
  file_->setForegroundRole(QPalette::PlaceholderText);
  file_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  other_ = linkButton(tr("Choose file…"), tr("Use another parameter file (nav2_params.yaml)"), this,
                      [this] { askOtherFile(); });
  resetAll_ =
      linkButton(tr("Reset all"), tr("Reset all values to those in the file"), this, [this] {
        apply(tr("Reset Nav2 parameters"), [](sim2d::Robot& edited) { edited.nav2Values.clear(); });
      });
  save_ = linkButton(tr("Save as a new file…"),
                     tr("Write the changed values into a copy of the parameter file, with its "
                        "comments and order, and use that file"),
                     this, [this] { askFile(); });
  QHBoxLayout& head = form_->head();
  head.insertWidget(0, robots_);
  head.addWidget(file_, 2);
  head.addWidget(other_);
  head.addWidget(resetAll_);
  head.addWidget(save_);
}

const sim2d::Robot* Nav2Panel::robot() const {
  const auto& robots = context_.document.scenario().robots;
  const auto found = std::find_if(robots.begin(), robots.end(), [this](const sim2d::Robot& each) {
    return robot_ && each.key == *robot_ && isDrivenByNav2(each);
  });
  if (found != robots.end()) {
    return &*found;
  }
  const auto any = std::find_if(robots.begin(), robots.end(), isDrivenByNav2);
  return any == robots.end() ? nullptr : &*any;
}

/// A selected robot is shown; the selection of anything else changes nothing.
void Nav2Panel::followSelection() {
  const std::vector<EntityId>& selection = context_.document.selection();
  if (selection.size() == 1 && selection.front().kind == EntityKind::Robot) {
    robot_ = selection.front();
  }
  refresh();
}

void Nav2Panel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

/// Reading the files takes time, so a hidden panel is not updated.
void Nav2Panel::refresh() {
  if (!isVisible()) {
    return;
  }
  const sim2d::Robot* const shown = robot();
  stack_->setCurrentIndex(shown == nullptr ? 0 : 1);
  fillRobots();
  const std::optional<Entity> inRun =
      shown == nullptr ? std::nullopt : context_.document.entityInRun(shown->key);
  form_->show(shown == nullptr ? std::nullopt : std::optional(*shown), context_.document.path(),
              inRun ? std::optional(std::get<sim2d::Robot>(*inRun)) : std::nullopt);
  const int changed = form_->changedCount();
  file_->setFullText(QFileInfo(form_->file()).fileName());
  file_->setToolTip(form_->file());
  resetAll_->setEnabled(changed > 0);
  save_->setEnabled(shown != nullptr && !form_->file().isEmpty());
  Q_EMIT context_.counted(this, changed);
}

void Nav2Panel::fillRobots() {
  const QSignalBlocker quiet(robots_);
  const sim2d::Robot* const shown = robot();
  robots_->clear();
  for (const sim2d::Robot& each : context_.document.scenario().robots) {
    if (isDrivenByNav2(each)) {
      robots_->addItem(QString::fromStdString(each.name), each.key.key);
      if (&each == shown) {
        robots_->setCurrentIndex(robots_->count() - 1);
      }
    }
  }
}

void Nav2Panel::apply(const QString& text, const std::function<void(sim2d::Robot&)>& change) {
  if (const sim2d::Robot* const shown = robot()) {
    pushChange<sim2d::Robot>(context_.document, shown->key, text, change);
  }
}

/// Beside the file of the robot, unless it is one of the program's own files.
void Nav2Panel::askFile() {
  const QFileInfo present(form_->file().section(QStringLiteral(", "), -1));
  const QString shipped =
      QFileInfo(QString::fromStdString(app::shippedResources("nav2_params"))).absoluteFilePath();
  const bool isShipped =
      present.absolutePath() == shipped || context_.document.isShipped(present.absoluteFilePath());
  QFileDialog dialog(window(), tr("Save the Nav2 parameters as a new file"),
                     isShipped ? context_.folder() : present.absolutePath(),
                     tr("Nav2 parameters (*.yaml *.yml)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("yaml"));
  dialog.selectFile(present.completeBaseName() + QStringLiteral("_changed.yaml"));
  const QString path = chosenFiles(dialog, true).value(0);
  if (!path.isEmpty()) {
    saveAs(path);
  }
}

/// The file as the scenario names it: relative to the scenario if it is near.
QString Nav2Panel::entryOf(const QString& path) const {
  const QString scenario = context_.document.path();
  const QString entry =
      scenario.isEmpty() ? path : QFileInfo(scenario).absoluteDir().relativeFilePath(path);
  return entry.startsWith(QLatin1String("../..")) ? path : entry;
}

void Nav2Panel::askOtherFile() {
  QFileDialog dialog(window(), tr("Choose Nav2 parameters"), context_.folder(),
                     tr("Nav2 parameters (*.yaml *.yml)"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  const QString path = chosenFiles(dialog, false).value(0);
  if (!path.isEmpty()) {
    useFile(path);
  }
}

void Nav2Panel::useFile(const QString& path) {
  apply(tr("Choose Nav2 parameters"),
        [this, &path](sim2d::Robot& edited) { edited.nav2Params = {entryOf(path).toStdString()}; });
}

bool Nav2Panel::saveAs(const QString& path) {
  const sim2d::Robot* const shown = robot();
  if (shown == nullptr) {
    return false;
  }
  const base::Result<app::SavedNav2Parameters> saved =
      app::saveNav2Parameters(*shown, context_.document.path().toStdString(), path.toStdString(),
                              entryOf(path).toStdString());
  if (!saved) {
    Q_EMIT context_.problemsFound(saved.diagnostics());
    return false;
  }
  apply(tr("Save Nav2 parameters"), [&](sim2d::Robot& edited) { edited = saved->robot; });
  return true;
}

void addNav2Panel(PanelRegistry& to) {
  PanelInfo info = closedBottomPanel(95, QObject::tr("Nav2"));
  info.initialHeight = kHeight;
  to.add(info, [](PanelContext& context) { return new Nav2Panel(context); });
}

}  // namespace editor
