#include "editor/panels/runs/BranchDialog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/run/Nav2Robots.h"
#include "app/run/RunBranch.h"
#include "editor/panels/runs/Playback.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

namespace {

constexpr double kFastestRobot = 10.0;      // [m/s]
constexpr double kFarthestPlace = 10000.0;  // [m]
constexpr double kDegrees = 180.0 / base::kPi;
constexpr int kWidth = 448;
constexpr int kLabelWidth = 60;
constexpr int kBesideFigure = 18;  // [px]

/// In cm and whole degrees, as the fields show them.
base::Pose2 roundedPose(const base::Pose2& pose) {
  const auto rounded = [](double value, double unit) { return std::round(value / unit) * unit; };
  return {{rounded(pose.position.x(), 0.01), rounded(pose.position.y(), 0.01)},
          rounded(pose.heading * kDegrees, 1.0) / kDegrees};
}

}  // namespace

std::string moveText(const std::string& person, const base::Pose2& pose) {
  return person + ' ' + base::formatDouble(pose.position.x()) + ' ' +
         base::formatDouble(pose.position.y()) + ' ' + base::formatDouble(pose.heading);
}

BranchState branchStateOf(const SimulationRunner& run) {
  const sim2d::Frame& frame = *run.shownFrame();
  const std::shared_ptr<const sim2d::TraceHeader> header = run.recording()->header();
  BranchState state;
  state.time = frame.time;
  state.seed = header->seed;
  for (const sim2d::TraceRobot& robot : header->robots) {
    state.robots.push_back({robot.name, robot.planner, robot.maxVel});
  }
  if (const std::shared_ptr<const sim2d::Scenario>& scenario = run.scenarios().now) {
    state.seed = scenario->desktop.seed.value_or(state.seed);
    for (BranchState::RobotState& robot : state.robots) {  // The header is that of the start.
      if (const auto* own = base::findBy(scenario->robots, &sim2d::Robot::name, robot.name)) {
        const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(*scenario, *own, -1);
        robot.planner = resolved.planner;
        robot.maxVel = resolved.maxVel;
      }
    }
  }
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    if (const sim2d::TraceHuman* human = header->human(frame.humans.id[k])) {
      state.people.push_back(
          {human->name, {{frame.humans.x[k], frame.humans.y[k]}, frame.humans.heading[k]}});
    }
  }
  return state;
}

BranchDialog::BranchDialog(BranchState state, const QString& name, const Theme& theme, Check check,
                           QWidget* parent)
    : QDialog(parent),
      state_(std::move(state)),
      check_(std::move(check)),
      theme_(theme),
      name_(new QLineEdit(name, this)) {
  setWindowTitle(tr("Branch at %1").arg(clockText(state_.time)));
  setFont(theme.font());
  auto* layout = configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 12);
  layout->setSizeConstraint(QLayout::SetFixedSize);  // As high as its rows.
  QLabel* says = secondaryLabel(
      tr("The branch repeats the run up to %1 and pauses there.").arg(clockText(state_.time)),
      this);
  says->setWordWrap(true);
  layout->addWidget(says);
  auto* section = new FormSection(tr("From then on"), this);
  section->setFixedWidth(kWidth);
  name_->setAccessibleName(tr("Branch name"));
  section->addRow(tr("Name"), name_);
  addRobots(*section);
  addPeople(*section);
  addSeed(*section);
  values_->setPlaceholderText(tr("PATH = VALUE, one per line: robot1.goal_radius = 0.4"));
  values_->setAccessibleName(tr("Other values"));
  values_->setTabChangesFocus(true);
  values_->setFixedHeight(3 * values_->fontMetrics().lineSpacing() + 12);
  section->addRow(tr("Other values"), values_);
  layout->addWidget(section);
  connect(values_, &QPlainTextEdit::textChanged, this, &BranchDialog::showChanges);
  note_->setWordWrap(true);
  layout->addWidget(note_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Create branch"));
  connect(buttons, &QDialogButtonBox::accepted, this, &BranchDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
  showChanges();
  name_->setFocus();
  name_->selectAll();
}

void BranchDialog::addRobots(FormSection& section) {
  const std::vector<std::string> planners = app::listedPlanners(app::builtinRegistries());
  for (const BranchState::RobotState& robot : state_.robots) {
    RobotRow row{robot.name, robot.maxVel, new ChoiceField(&section),
                 new NumberField({0.0, kFastestRobot, 2, 0.1, true}, tr("m/s"), &section)};
    for (const std::string& planner : planners) {
      if (planner != "external" || planner == robot.planner) {
        row.planner->addItem(QString::fromStdString(planner));
      }
    }
    const QString label = QString::fromStdString(robot.name);
    row.planner->setCurrentText(QString::fromStdString(robot.planner));
    row.planner->setAccessibleName(tr("Planner of %1").arg(label));
    row.planner->setProperty("before", row.planner->currentText());
    row.speed->show(robot.maxVel, false);
    row.speed->setAccessibleName(tr("Top speed of %1").arg(label));
    section.addRow(label, row.planner, row.speed);
    connect(row.planner, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &BranchDialog::showChanges);
    connect(row.speed, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &BranchDialog::showChanges);
    robots_.push_back(row);
  }
}

void BranchDialog::addPeople(FormSection& section) {
  if (state_.people.empty()) {
    return;
  }
  auto* box = new QWidget(&section);
  moveRows_ = configuredLayout(new QVBoxLayout(box), {}, 4);
  people_ = new ChoiceField(box);
  people_->setAccessibleName(tr("Move a person"));
  moveRows_->addWidget(people_);
  connect(people_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    const std::string person = people_->itemData(index).toString().toStdString();
    if (const auto* known = base::findBy(state_.people, &BranchState::PersonState::name, person)) {
      addMove(person, roundedPose(known->pose));
      moves_.back().x->setFocus();
      moves_.back().x->selectAll();
    }
  });
  section.addRow(tr("Positions"), box);
  fillPeople();
}

/// Lists the people without a row.
void BranchDialog::fillPeople() {
  people_->clear();
  people_->addItem(tr("Move a person…"));
  for (const BranchState::PersonState& person : state_.people) {
    if (base::findBy(moves_, &MoveRow::person, person.name) == nullptr) {
      people_->addItem(QString::fromStdString(person.name), QString::fromStdString(person.name));
    }
  }
  people_->setCurrentIndex(0);
  people_->setVisible(people_->count() > 1);
}

void BranchDialog::addMove(const std::string& person, const base::Pose2& pose) {
  MoveRow move;
  move.person = person;
  move.row = new QWidget(this);
  const QString label = QString::fromStdString(person);
  auto* named = new ElidedLabel(move.row);
  named->setFullText(label);
  named->setFixedWidth(kLabelWidth);
  const auto number = [&](double value, const NumberField::Range& range, const QString& unit,
                          const QString& says) {
    auto* field = new NumberField(range, unit, move.row);
    field->show(value, false);
    field->setAccessibleName(says.arg(label));
    return field;
  };
  const NumberField::Range place{-kFarthestPlace, kFarthestPlace, 2, 0.1};
  move.x = number(pose.position.x(), place, tr("m"), tr("X of %1"));
  move.y = number(pose.position.y(), place, tr("m"), tr("Y of %1"));
  move.heading = number(pose.heading * kDegrees, {-180.0, 180.0, 0, 15.0}, QStringLiteral("°"),
                        tr("Heading of %1"));
  auto* remove = new QToolButton(move.row);
  remove->setText(QStringLiteral("×"));
  remove->setAutoRaise(true);
  remove->setToolTip(tr("Leave %1 in place").arg(label));
  remove->setAccessibleName(remove->toolTip());
  connect(remove, &QToolButton::clicked, this, [this, row = move.row] { removeMove(row); });
  configuredLayout(new QHBoxLayout(move.row), {}, 4, {named, move.x, move.y, move.heading, remove});
  moveRows_->insertWidget(moveRows_->count() - 1, move.row);
  moves_.push_back(move);
  fillPeople();
  showChanges();
}

void BranchDialog::removeMove(const QWidget* row) {
  const auto found = std::find_if(moves_.begin(), moves_.end(),
                                  [row](const MoveRow& move) { return move.row == row; });
  found->row->hide();
  found->row->deleteLater();
  moves_.erase(found);
  fillPeople();
  showChanges();
}

void BranchDialog::addSeed(FormSection& section) {
  seed_->setRange(0, std::numeric_limits<int>::max());
  const long long next = std::min<long long>(state_.seed + 1, std::numeric_limits<int>::max());
  seed_->setValue(static_cast<int>(next));
  seed_->setEnabled(false);
  seed_->setAccessibleName(tr("Seed"));
  connect(drawsNewSeed_, &QCheckBox::toggled, seed_, &QSpinBox::setEnabled);
  connect(drawsNewSeed_, &QCheckBox::toggled, this, &BranchDialog::showChanges);
  section.addRow(tr("Seed"), drawsNewSeed_, seed_);
}

void BranchDialog::propose(const app::RunSpec& changes) {
  for (const std::string& text : changes.moves) {
    const std::size_t space = text.find(' ');
    const auto pose = app::parseNumbers(text.substr(std::min(space, text.size())), 3);
    if (pose && people_ != nullptr) {
      addMove(text.substr(0, space), {{(*pose)[0], (*pose)[1]}, (*pose)[2]});
    }
  }
  for (const std::string& pair : changes.set) {
    values_->appendPlainText(QString::fromStdString(pair));
  }
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
  for (const QString& line : values_->toPlainText().split(QLatin1Char('\n'))) {
    if (!line.trimmed().isEmpty()) {
      const QString path = line.section(QLatin1Char('='), 0, 0).trimmed();
      const QString value = line.section(QLatin1Char('='), 1).trimmed();
      const bool isPair = line.contains(QLatin1Char('='));  // Else the check reports it.
      options.set.push_back((isPair ? path + QLatin1Char('=') + value : path).toStdString());
    }
  }
  for (const MoveRow& move : moves_) {
    const base::Pose2 pose{{move.x->value(), move.y->value()}, move.heading->value() / kDegrees};
    options.moves.push_back(moveText(move.person, pose));
  }
  if (drawsNewSeed_->isChecked()) {
    options.seed = seed_->value();
  }
  return options;
}

void BranchDialog::accept() {
  const base::Diagnostics problems = check_ ? check_(changes()) : base::Diagnostics();
  if (problems.empty()) {
    QDialog::accept();
    return;
  }
  showNote(QString::fromStdString(problems.front().message),
           Role::Error);  // May begin with a name.
}

void BranchDialog::showNote(const QString& text, Role role) {
  QPalette colors = note_->palette();
  colors.setColor(QPalette::WindowText, theme_.color(role));
  note_->setPalette(colors);
  note_->setText(text);
}

/// "Changes: robot1.planner, Ana, seed"
void BranchDialog::showChanges() {
  const app::RunSpec now = changes();
  QStringList names;
  for (const std::string& pair : now.set) {
    names << QString::fromStdString(pair.substr(0, pair.find('=')));
  }
  for (const MoveRow& move : moves_) {
    names << QString::fromStdString(move.person);
  }
  if (now.seed) {
    names << tr("seed");
  }
  showNote(names.isEmpty()
               ? tr("No changes yet: the branch will be identical to the displayed run.")
               : tr("Changes: %1").arg(names.join(QStringLiteral(", "))),
           Role::TextSecondary);
}

BranchCommand::BranchCommand(SimulationRunner& runner, MapView& view, QAction& action,
                             QObject* parent)
    : QObject(parent), runner_(runner), view_(view), scene_(view.mapScene()), action_(action) {
  describe(action_, tr("Continue the run from the displayed step with changes: another planner, "
                       "other positions, another seed; the run itself is kept"));
  connect(&action_, &QAction::triggered, this, [this] { branchHere(); });
  connect(&runner_, &SimulationRunner::stateChanged, this, &BranchCommand::follow);
  connect(&runner_, &SimulationRunner::lookingBackChanged, this, &BranchCommand::follow);
  connect(&runner_, &SimulationRunner::branchesChanged, this, &BranchCommand::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &BranchCommand::follow);
  connect(&scene_, &MapScene::placed, this, &BranchCommand::offerMove);
  follow();
}

void BranchCommand::follow() {
  const bool isRun = runner_.state() != SimulationRunner::State::Editing;
  const bool isPossible = isRun && runner_.canBranchFromShown();
  const bool isFull = runner_.branches().size() >= SimulationRunner::kMaxBranches;
  const QString why = !isRun   ? tr("Start a run first: Space")
                      : isFull ? tr("The maximum number of branches is reached: remove one first")
                      : runner_.again() == nullptr
                          ? tr("The inputs of this run are unknown, so it cannot be repeated")
                          : tr("A branch starts at an earlier step: go back on the timeline first");
  if (action_.isEnabled() != isPossible || why_ != why) {
    why_ = why;
    setEnabled(action_, isPossible, why);
  }
  scene_.setPlaceable(isPossible && runner_.state() == SimulationRunner::State::Paused);
}

void BranchCommand::branchHere(const app::RunSpec& proposal) {
  if (!runner_.canBranchFromShown()) {
    return;
  }
  runner_.pause();
  const auto number = static_cast<int>(runner_.branches().size());
  BranchDialog dialog(
      branchStateOf(runner_), tr("Branch %1").arg(number), scene_.theme(),
      [this](const app::RunSpec& changes) { return runner_.branchProblems(changes); },
      view_.window());
  dialog.propose(proposal);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const app::RunSpec changes = dialog.changes();
  if (runner_.branchFromShown(changes, dialog.name()) && !changes.moves.empty()) {
    runner_.stepOnce();  // Moves take effect in the first step of the branch.
  }
}

/// Kept, because the dialog opens while the menu handles an event.
QMenu& BranchCommand::emptyMenu() {
  if (menu_ == nullptr) {
    menu_ = new QMenu(&view_);
    menu_->setToolTipsVisible(true);
  }
  menu_->clear();
  return *menu_;
}

void BranchCommand::offerMove(int person, const base::Pose2& pose) {
  const sim2d::TraceHuman* human =
      runner_.recording() != nullptr ? runner_.recording()->header()->human(person) : nullptr;
  if (human == nullptr || !runner_.canBranchFromShown()) {
    scene_.clearPlacement();
    return;
  }
  app::RunSpec proposal;
  proposal.moves = {moveText(human->name, roundedPose(pose))};
  QMenu& menu = emptyMenu();
  QAction* branch = menu.addAction(tr("Branch with this change…"), this,
                                   [this, proposal] { branchHere(proposal); });
  describe(*branch, tr("Continue the run with %1 here").arg(QString::fromStdString(human->name)));
  menu.addAction(tr("Cancel"));
  connect(&menu, &QMenu::aboutToHide, &scene_, &MapScene::clearPlacement, Qt::UniqueConnection);
  menu.setActiveAction(branch);
  const QPoint beside(kBesideFigure, kBesideFigure);
  menu.popup(view_.viewport()->mapToGlobal(view_.viewportFrom(pose.position) + beside));
}

void BranchCommand::offerIn(double time, QMenu* menu) {
  const RecordingPtr recording = runner_.recording();
  if (recording != nullptr && recording->size() > 0) {
    runner_.seek(recording->stepOf(recording->indexAtTime(time)));
    menu->addAction(&action_);
  }
}

}  // namespace editor
