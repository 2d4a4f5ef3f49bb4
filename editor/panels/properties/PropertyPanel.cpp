#include "editor/panels/properties/PropertyPanel.h"

#include <cmath>
#include <limits>
#include <utility>

#include "editor/canvas/Tool.h"
#include "editor/document/EntityModel.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/document/RunValues.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Icons.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/runs/Playback.h"
#include "metrics/Samples.h"
#include "sim2d/base/Find.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

namespace {

constexpr int kPictureSize = 36;
constexpr int kMinPage = 48;
constexpr int kMinBody = 120;

/// "1 → 2 → 3": the first goals.
QString firstGoals(const std::vector<int>& goals) {
  constexpr std::size_t kMaxNamed = 5;
  QStringList words;
  for (std::size_t k = 0; k < std::min(goals.size(), kMaxNamed); ++k) {
    words << QString::number(goals[k]);
  }
  if (goals.size() > kMaxNamed) {
    words << QStringLiteral("…");
  }
  return words.join(QStringLiteral(" → "));
}

QString aboutPerson(const ScenarioDocument& document, const sim2d::Human& human) {
  const sim2d::Scenario& scenario = document.scenario();
  const QString number = QObject::tr("Person %1").arg(human.id);
  if (!human.listed) {
    const sim2d::Area* source = base::findIf(scenario.areas, [&](const sim2d::Area& area) {
      return area.kind == sim2d::AreaKind::Source && area.like == human.name;
    });
    return source == nullptr ? number + QObject::tr(" · switched off")
                             : QObject::tr("Template of people spawned by %1")
                                   .arg(QString::fromStdString(source->name));
  }
  const std::vector<int> goals = walkedGoals(document, human);
  if (!goals.empty()) {
    return number + QObject::tr(" · goals %1").arg(firstGoals(goals));
  }
  return document.hasCustomTree(human) ? number : number + QObject::tr(" · stands still");
}

QString aboutRobot(const sim2d::Robot& robot) {
  const QString planner =
      QObject::tr("Robot · %1").arg(QString::fromStdString(robot.planner.value_or("pursuit")));
  return robot.goal.point ? planner + QObject::tr(" · to %1").arg(placeText(*robot.goal.point))
         : robot.goal.goals.empty()
             ? planner + QObject::tr(" · stands still")
             : planner + QObject::tr(" · goals %1").arg(firstGoals(robot.goal.goals));
}

QString aboutOne(const ScenarioDocument& document, const Entity& entity) {
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    return aboutPerson(document, *human);
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    return aboutRobot(*robot);
  }
  return capitalized(kindName(kindOf(entity)));
}

/// The current goal of a robot: a goal number, or its own goal point.
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

/// The state of a person or robot in the shown frame: position, heading, speed, goal and distance
QString manualPageOf(EntityKind kind) {
  switch (kind) {
    case EntityKind::Human:
      return QStringLiteral("people-and-groups");
    case EntityKind::Robot:
      return QStringLiteral("robots-and-sensors");
    case EntityKind::Dock:
      return QStringLiteral("nav2");
    case EntityKind::Scenario:
      return QStringLiteral("file-formats");
    default:
      return QStringLiteral("your-map");
  }
}

constexpr double kUnknownGap = std::numeric_limits<double>::infinity();

/// The smallest distance from a person to a robot, surface to surface as in the metrics [m]; 0:
/// they touch.
double gapToRobots(const sim2d::Frame& frame, const sim2d::TraceHeader& header,
                   std::size_t person) {
  const metrics::Seam seam = metrics::seamOf(header);
  const sim2d::TraceHuman* const body = header.human(frame.humans.id[person]);
  const base::Vec2 place(frame.humans.x[person], frame.humans.y[person]);
  double nearest = kUnknownGap;
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    const sim2d::TraceRobot* const robot = header.robot(frame.robots.id[i]);
    if (body == nullptr || robot == nullptr) {
      continue;
    }
    const base::Vec2 there = seam.nearest({frame.robots.x[i], frame.robots.y[i]}, place);
    const double gap = (there - place).norm() - body->radius - robot->radius;
    nearest = std::min(nearest, std::max(gap, 0.0));
  }
  return nearest;
}

/// The state of the selected person or robot in the run, and the distance of a person to the robot.
/// Hidden without a run.
class RunStateSection : public FormSection {
  Q_DECLARE_TR_FUNCTIONS(editor::RunStateSection)
 public:
  explicit RunStateSection(QWidget* parent) : FormSection(tr("Now"), parent) {
    addRow(tr("Position"), position_);
    addRow(tr("Heading"), heading_);
    addRow(tr("Speed"), speed_);
    addRow(tr("Goal"), goal_);
    addRow(tr("Robot"), robot_);
    drive_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    addRow(tr("Manual drive"), drive_);
    setRowVisible(drive_, false);
    hide();
  }
  /// The action that drives the shown robot; its button is visible while the action is enabled.
  void setDriveAction(QAction* drive) { drive_->setDefaultAction(drive); }
  /// `agent` as in frames: people by id, robots negative; `robot`: the settings of that robot.
  /// `header` may be null.
  void show(const sim2d::Frame* frame, const sim2d::TraceHeader* header, std::optional<int> agent,
            const sim2d::Robot* robot) {
    setVisible(frame != nullptr && agent &&
               (robot != nullptr ? showRobot(*frame, *agent, *robot)
                                 : showPerson(*frame, header, *agent)));
  }

 private:
  /// Shows the values common to people and robots. Returns the row in the columns; none = not in
  /// the frame.
  template <typename Columns>  // lupdate takes "class" for a class with texts
  std::optional<std::size_t> showBody(const Columns& bodies, int id) {
    const auto found = std::find(bodies.id.begin(), bodies.id.end(), id);
    if (found == bodies.id.end()) {
      return std::nullopt;
    }
    const auto i = static_cast<std::size_t>(found - bodies.id.begin());
    const double speed = std::sqrt(bodies.vx[i] * bodies.vx[i] + bodies.vy[i] * bodies.vy[i]);
    position_->setText(placeText({bodies.x[i], bodies.y[i]}));
    heading_->setText(headingText(bodies.heading[i]));
    speed_->setText(QStringLiteral("%1 m/s").arg(speed, 0, 'f', 2));
    goal_->setText(bodies.goal[i] == sim2d::kNoGoal ? tr("none") : goalName(bodies.goal[i]));
    return i;
  }

  bool showPerson(const sim2d::Frame& frame, const sim2d::TraceHeader* header, int id) {
    const sim2d::HumanColumns& people = frame.humans;
    const std::optional<std::size_t> index = showBody(people, id);
    if (!index) {
      return false;
    }
    const double nearest = header == nullptr ? kUnknownGap : gapToRobots(frame, *header, *index);
    setRowVisible(drive_, false);
    setNote(people.state[*index] != 0 ? tr("reacting") : QString());
    setRowVisible(robot_, nearest < kUnknownGap);
    robot_->setText(tr("%1 m, surface to surface").arg(nearest, 0, 'f', 2));
    robot_->setToolTip(tr("Distance between the bodies, not their centres, as in the metrics"));
    return true;
  }

  bool showRobot(const sim2d::Frame& frame, int id, const sim2d::Robot& robot) {
    const sim2d::RobotColumns& robots = frame.robots;
    const std::optional<std::size_t> index = showBody(robots, id);
    if (index) {
      const base::Vec2 at(robots.x[*index], robots.y[*index]);
      goal_->setText(goalOfRobot(robot, robots.goal[*index], at));
    }
    setNote({});
    setRowVisible(robot_, false);
    setRowVisible(drive_,
                  drive_->defaultAction() != nullptr && drive_->defaultAction()->isEnabled());
    return index.has_value();
  }

  QLabel* position_ = new QLabel(this);
  QLabel* heading_ = new QLabel(this);
  QLabel* speed_ = new QLabel(this);
  QLabel* goal_ = new QLabel(this);
  QLabel* robot_ = new QLabel(this);
  QToolButton* drive_ = new QToolButton(this);
};

PropertyPanel::PropertyPanel(ScenarioDocument& document, const Theme& theme)
    : document_(document), theme_(theme), runState_(new RunStateSection(this)) {
  setMinimumWidth(300);
  picture_->setFixedSize(kPictureSize, kPictureSize);
  name_->setFont(theme_.font(12.0, QFont::DemiBold));
  about_->setTextFormat(Qt::PlainText);
  auto* restart = linkButton(tr("Restart"), tr("Restart the run with the current settings"), this,
                             [this] { Q_EMIT restartRequested(); });
  restart->setObjectName(QStringLiteral("restart"));
  auto* hint = secondaryLabel(tr("Changes take effect at the next start."), later_);
  hint->setToolTip(tr("A dot marks values that differ from those of the run"));
  hint->setWordWrap(true);
  configuredLayout(new QHBoxLayout(later_), {12, 2, 12, 3}, 8, {hint, restart})->setStretch(0, 1);
  later_->hide();
  auto* top = configuredLayout(new QHBoxLayout, {12, 12, 12, 12}, 12, {picture_});
  top->addLayout(configuredLayout(new QVBoxLayout, {}, 0, {name_, about_}), 1);
  stack_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // The pages scroll.
  stack_->setMinimumHeight(kMinPage);
  auto* body = new QWidget(this);
  configuredLayout(new QVBoxLayout(body), {}, 0, {runState_, later_})->addWidget(stack_, 1);
  auto* low = scrollArea(body, this);  // In low windows the run state uses all of the height.
  low->setMinimumHeight(kMinBody);
  low->setFocusPolicy(Qt::NoFocus);  // the areas of the pages have the focus
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0);
  layout->addLayout(top);
  layout->addWidget(kinds_);
  layout->addWidget(dividerLine(this));
  layout->addWidget(low, 1);
  pages_ = entityPages(document, theme);
  for (const auto& [kind, page] : pages_) {
    page->setProperty(kManualPageProperty, manualPageOf(kind));
    stack_->addWidget(scrollArea(page, stack_));
    connect(page, &PropertyPage::panelRequested, this, &PropertyPanel::panelRequested);
    stack_->widget(stack_->count() - 1)->setMinimumHeight(kMinPage);  // Low windows scroll here.
  }
  stack_->addWidget(spawnedPersonPage_);
  connect(kinds_, &KindSwitch::chosen, this, &PropertyPanel::follow);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &PropertyPanel::follow);
  connect(&document_, &ScenarioDocument::pathChanged, this, &PropertyPanel::refresh);
  connect(&document_, &ScenarioDocument::runChanged, this, &PropertyPanel::refresh);
  connect(&document_, &ScenarioDocument::changed, this, [this](const Change& change) {
    isSame_ = isSame_ && change.what == Change::What::Edited;
  });
  connect(&document_, &ScenarioDocument::stepFinished, this,
          [this] { std::exchange(isSame_, true) ? refresh() : follow(); });
  follow();
}

void PropertyPanel::setSpawnedAgent(std::optional<sim2d::TraceHuman> spawnedAgent) {
  spawnedAgent_ = std::move(spawnedAgent);
  follow();
}

/// The section reflects whether the robot can be driven.
void PropertyPanel::setDriveAction(QAction* drive) {
  runState_->setDriveAction(drive);
  connect(drive, &QAction::changed, this, &PropertyPanel::showRunState);
}

void PropertyPanel::showSpawnedPerson() {
  const Look look = lookOf(*spawnedAgent_);
  std::vector<int> goals;
  for (const sim2d::TraceGoal& goal : spawnedAgent_->goals) {
    goals.push_back(goal.id);
  }
  const QString about = tr("Person %1 · %2").arg(spawnedAgent_->id).arg(lookName(look));
  name_->setFullText(QString::fromStdString(spawnedAgent_->name));
  about_->setText(goals.empty() ? about : about + tr(" · goals %1").arg(firstGoals(goals)));
  picture_->setPixmap(FigurePainter(theme_)
                          .personIcon(look, kPictureSize)
                          .pixmap(window()->windowHandle(), QSize(kPictureSize, kPictureSize)));
  stack_->setCurrentWidget(spawnedPersonPage_);
  showRunState();
}

void PropertyPanel::follow() {
  if (spawnedAgent_) {
    kinds_->hide();
    showSpawnedPerson();
    return;
  }
  std::vector<EntityId> ids = document_.selection();
  if (ids.empty()) {
    ids = {kSettingsId};
  }
  const EntityKind kind = kinds_->setSelection(ids);
  ids.erase(std::remove_if(ids.begin(), ids.end(), [kind](EntityId id) { return id.kind != kind; }),
            ids.end());
  current_ = pages_.at(kind);
  current_->setTargets(ids);  // First, to commit typed text on the previous page.
  stack_->setCurrentIndex(static_cast<int>(std::distance(pages_.begin(), pages_.find(kind))));
  showHeading(ids);
  showRunState();
}

void PropertyPanel::refresh() {
  current_->refresh();
  if (!spawnedAgent_) {
    showHeading(current_->targets());
  }
}

void PropertyPanel::showHeading(const std::vector<EntityId>& ids) {
  std::optional<Entity> first = document_.entity(ids.front());
  if (!first) {
    return;
  }
  first = withRunValues(document_, *std::move(first));
  picture_->setPixmap(picture(*first));
  // A selection may contain several kinds; the page shows one of them.
  const std::size_t all = document_.selection().size();
  const std::size_t others = all > ids.size() ? all - ids.size() : 0;
  const QString rest = counted(others, tr("other"), tr("others"));
  if (ids.size() > 1) {
    name_->setFullText(kindText(ids.front().kind, ids.size()));
    about_->setText(others == 0 ? tr("Changes apply to all of them")
                                : tr("Changes apply to these, not to %1").arg(rest));
  } else if (ids.front() == kSettingsId) {
    name_->setFullText(document_.displayName());
    about_->setText(tr("Scenario · nothing selected"));
  } else {
    name_->setFullText(displayName(*first));
    Entity inRun = document_.entityInRun(ids.front()).value_or(*first);
    if (auto* human = std::get_if<sim2d::Human>(&inRun)) {
      human->key = ids.front();  // Of its tree.
    }
    const QString one = aboutOne(document_, inRun);
    about_->setText(others == 0 ? one : tr("%1 · and %2").arg(one, rest));
  }
}

QPixmap PropertyPanel::picture(const Entity& entity) const {
  const FigurePainter painter(theme_);
  const QSize size(kPictureSize, kPictureSize);
  const auto icon = [&] {
    switch (kindOf(entity)) {
      case EntityKind::Human:
        return painter.personIcon(shownLookOf(document_, std::get<sim2d::Human>(entity)),
                                  kPictureSize);
      case EntityKind::Robot:
        return painter.robotIcon(kPictureSize);
      case EntityKind::Goal:
        return painter.goalIcon(QString::fromStdString(nameOf(entity)), kPictureSize);
      case EntityKind::Obstacle:
      case EntityKind::Door:
      case EntityKind::Dock:
        return themedIcon(shapeIcon(entity), theme_);
      case EntityKind::Area:
        return themedIcon(QStringLiteral("tool-area"), theme_);
      case EntityKind::Scenario:
      case EntityKind::None:
        break;
    }
    return themedIcon(QStringLiteral("file"), theme_);
  };
  return icon().pixmap(window()->windowHandle(), size);
}

void PropertyPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  for (const auto& [kind, page] : pages_) {
    page->setTheme(theme);
  }
  follow();
}

void PropertyPanel::showFrame(const FramePtr& frame, bool isRecorded,
                              std::shared_ptr<const sim2d::TraceHeader> header) {
  frame_ = frame;
  header_ = std::move(header);
  isRecorded_ = isRecorded;
  for (const auto& [kind, page] : pages_) {
    page->setEnabled(!isRecorded);
  }
  showRunState();
}

std::optional<int> PropertyPanel::agentOf(EntityId id) const {
  if (const sim2d::Human* human = document_.human(id)) {
    return human->id;
  }
  int number = 0;  // Counts the active robots.
  for (const sim2d::Robot& robot : document_.scenario().robots) {
    number -= robot.listed ? 1 : 0;
    if (robot.key == id && robot.listed) {
      return number;
    }
  }
  return std::nullopt;
}

void PropertyPanel::showRunState() {
  later_->setVisible(frame_ != nullptr && !isRecorded_ && !spawnedAgent_);  // Guests are read-only.
  const std::vector<EntityId>& ids = document_.selection();
  if (spawnedAgent_) {
    runState_->show(frame_.get(), header_.get(), spawnedAgent_->id, nullptr);
    return;
  }
  const std::optional<Entity> one =
      ids.size() == 1 && frame_ ? document_.entity(ids.front()) : std::nullopt;
  runState_->show(frame_.get(), header_.get(), one ? agentOf(ids.front()) : std::nullopt,
                  one ? std::get_if<sim2d::Robot>(&*one) : nullptr);
}

void addPropertyPanel(PanelRegistry& to) {
  to.add({30, QObject::tr("Properties"), Qt::RightDockWidgetArea, false},
         [](PanelContext& context) {
           auto* panel = new PropertyPanel(context.document, context.theme());
           QObject::connect(&context, &PanelContext::themeChanged, panel, &PropertyPanel::setTheme);
           QObject::connect(panel, &PropertyPanel::panelRequested, &context,
                            &PanelContext::panelRequested);
           if (context.drive != nullptr) {
             panel->setDriveAction(context.drive);
           }
           QObject::connect(&context.runner, &SimulationRunner::frameShown, panel,
                            [panel, &runner = context.runner](const FramePtr& frame) {
                              const RecordingPtr recording = runner.recording();
                              panel->showFrame(frame, runner.isRecorded(),
                                               recording ? recording->header() : nullptr);
                            });
           QObject::connect(panel, &PropertyPanel::restartRequested, &context.runner,
                            [panel, &runner = context.runner] {
                              if (confirmDiscardOfBranches(runner, panel)) {
                                runner.reset();
                                runner.play();
                              }
                            });
           const MapScene& scene = context.view.mapScene();
           QObject::connect(
               &scene, &MapScene::spawnedAgentChanged, panel,
               [panel, &scene, &runner = context.runner] {
                 const auto header = runner.recording() && scene.spawnedAgent()
                                         ? runner.recording()->header()
                                         : nullptr;
                 const auto* spawnedAgent = header ? header->human(*scene.spawnedAgent()) : nullptr;
                 panel->setSpawnedAgent(spawnedAgent ? std::optional(*spawnedAgent) : std::nullopt);
               });
           return panel;
         });
}

}  // namespace editor
