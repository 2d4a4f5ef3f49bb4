#include "editor/panels/PropertyPanel.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/canvas/Tool.h"
#include "editor/document/EntityModel.h"
#include "editor/document/Groups.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Icons.h"
#include "editor/panels/EntityPages.h"
#include "editor/panels/NowSection.h"
#include "editor/panels/PanelRegistry.h"

namespace editor {

namespace {

constexpr int kPictureSize = 36;
constexpr int kLeastPage = 48;
constexpr int kLeastBody = 120;

/// "1 → 2 → 3": the first ones.
QString firstGoals(const std::vector<int>& goals) {
  constexpr std::size_t kMostNamed = 5;
  QStringList words;
  for (std::size_t k = 0; k < std::min(goals.size(), kMostNamed); ++k) {
    words << QString::number(goals[k]);
  }
  if (goals.size() > kMostNamed) {
    words << QStringLiteral("…");
  }
  return words.join(QStringLiteral(" → "));
}

QString aboutPerson(const sim2d::Scenario& scenario, const sim2d::Human& human) {
  const QString number = QObject::tr("Person %1").arg(human.id);
  if (!human.listed) {
    const auto source =
        std::find_if(scenario.areas.begin(), scenario.areas.end(), [&](const sim2d::Area& area) {
          return area.kind == sim2d::AreaKind::Source && area.like == human.name;
        });
    return source == scenario.areas.end() ? number + QObject::tr(" · switched off")
                                          : QObject::tr("Pattern of those who come from %1")
                                                .arg(QString::fromStdString(source->name));
  }
  if (human.goals.empty()) {
    return number + QObject::tr(" · stands still");
  }
  return number + QObject::tr(" · goals %1").arg(firstGoals(human.goals));
}

QString aboutRobot(const sim2d::Robot& robot) {
  const QString planner =
      QObject::tr("Robot · %1").arg(QString::fromStdString(robot.planner.value_or("pursuit")));
  return robot.goal.point ? planner + QObject::tr(" · to %1").arg(placeText(*robot.goal.point))
         : robot.goal.goals.empty()
             ? planner + QObject::tr(" · stands still")
             : planner + QObject::tr(" · goals %1").arg(firstGoals(robot.goal.goals));
}

QString aboutOne(const sim2d::Scenario& scenario, const Entity& entity) {
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    return aboutPerson(scenario, *human);
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    return aboutRobot(*robot);
  }
  return capitalized(kindName(kindOf(entity)));
}

}  // namespace

PropertyPanel::PropertyPanel(ScenarioDocument& document, const Theme& theme)
    : document_(document),
      theme_(theme),
      picture_(new QLabel(this)),
      name_(new ElidedLabel(this)),
      about_(secondaryLabel({}, this)),
      now_(new NowSection(this)),
      later_(new QWidget(this)),
      stack_(new QStackedWidget(this)),
      guestPage_(emptyState(tr("Came in by a source in this run. To change such people, select the "
                               "person that the source copies."),
                            stack_)) {
  setMinimumWidth(300);
  picture_->setFixedSize(kPictureSize, kPictureSize);
  name_->setFont(theme_.font(12.0, QFont::DemiBold));
  about_->setTextFormat(Qt::PlainText);
  auto* restart = linkButton(tr("Restart"), tr("Begin the run anew with what is set now"), this,
                             [this] { Q_EMIT restartWanted(); });
  restart->setObjectName(QStringLiteral("restart"));
  auto* hint = secondaryLabel(tr("Changes count from the next start."), later_);
  hint->setWordWrap(true);
  arranged(new QHBoxLayout(later_), {12, 2, 12, 3}, 8, {hint, restart})->setStretch(0, 1);
  later_->hide();
  auto* top = arranged(new QHBoxLayout, {12, 12, 12, 12}, 12, {picture_});
  top->addLayout(arranged(new QVBoxLayout, {}, 0, {name_, about_}), 1);
  stack_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // its pages scroll
  stack_->setMinimumHeight(kLeastPage);
  auto* body = new QWidget(this);
  arranged(new QVBoxLayout(body), {}, 0, {now_, later_})->addWidget(stack_, 1);
  auto* low = scrollArea(body, this);  // in windows so low that the moment of a run needs all of it
  low->setMinimumHeight(kLeastBody);
  auto* layout = arranged(new QVBoxLayout(this), {}, 0);
  layout->addLayout(top);
  layout->addWidget(dividerLine(this));
  layout->addWidget(low, 1);
  pages_ = entityPages(document, theme);
  for (const auto& [kind, page] : pages_) {
    stack_->addWidget(scrollArea(page, stack_));
    stack_->widget(stack_->count() - 1)->setMinimumHeight(kLeastPage);  // low windows scroll here
  }
  stack_->addWidget(guestPage_);
  connect(&document_, &ScenarioDocument::selectionChanged, this, &PropertyPanel::follow);
  connect(&document_, &ScenarioDocument::pathChanged, this, &PropertyPanel::refresh);
  connect(&document_, &ScenarioDocument::changed, this, [this](const Change& change) {
    isSame_ = isSame_ && change.what == Change::What::Edited;
  });
  connect(&document_, &ScenarioDocument::settled, this,
          [this] { std::exchange(isSame_, true) ? refresh() : follow(); });
  follow();
}

void PropertyPanel::setGuest(std::optional<sim2d::TraceHuman> guest) {
  guest_ = std::move(guest);
  follow();
}

/// The section follows what can be driven.
void PropertyPanel::offerDrive(QAction* drive) {
  now_->offerDrive(drive);
  connect(drive, &QAction::changed, this, &PropertyPanel::showNow);
}

void PropertyPanel::showGuest() {
  const Look look = lookOf(static_cast<sim2d::BehaviorType>(guest_->behavior));
  std::vector<int> goals;
  for (const sim2d::TraceGoal& goal : guest_->goals) {
    goals.push_back(goal.id);
  }
  const QString about = tr("Person %1 · %2").arg(guest_->id).arg(lookName(look));
  name_->setWords(QString::fromStdString(guest_->name));
  about_->setText(goals.empty() ? about : about + tr(" · goals %1").arg(firstGoals(goals)));
  picture_->setPixmap(FigurePainter(theme_)
                          .personIcon(look, kPictureSize)
                          .pixmap(window()->windowHandle(), QSize(kPictureSize, kPictureSize)));
  stack_->setCurrentWidget(guestPage_);
  showNow();
}

void PropertyPanel::follow() {
  if (guest_) {
    showGuest();
    return;
  }
  std::vector<EntityId> ids = document_.selection();
  if (ids.empty()) {
    ids = {kSettingsId};
  }
  // Several kinds at once: the page of the kind selected last.
  const EntityKind kind = ids.back().kind;
  ids.erase(std::remove_if(ids.begin(), ids.end(), [kind](EntityId id) { return id.kind != kind; }),
            ids.end());
  current_ = pages_.at(kind);
  current_->setTargets(ids);  // first: what is being typed on the page before is taken now
  stack_->setCurrentIndex(static_cast<int>(std::distance(pages_.begin(), pages_.find(kind))));
  showHeading(ids);
  showNow();
}

void PropertyPanel::refresh() {
  current_->refresh();
  if (!guest_) {
    showHeading(current_->targets());
  }
}

void PropertyPanel::showHeading(const std::vector<EntityId>& ids) {
  const std::optional<Entity> first = document_.entity(ids.front());
  if (!first) {
    return;
  }
  picture_->setPixmap(picture(*first));
  // A selection may have several kinds; the page has one of them.
  const std::size_t all = document_.selection().size();
  const std::size_t others = all > ids.size() ? all - ids.size() : 0;
  const QString rest = counted(others, tr("other"), tr("others"));
  if (ids.size() > 1) {
    name_->setWords(ids.front().kind == EntityKind::Human
                        ? tr("%1 people").arg(ids.size())
                        : counted(ids.size(), kindName(ids.front().kind),
                                  kindName(ids.front().kind) + QLatin1Char('s')));
    about_->setText(others == 0 ? tr("Changes go to all of them")
                                : tr("Changes go to these, not to %1").arg(rest));
  } else if (ids.front() == kSettingsId) {
    name_->setWords(document_.displayName());
    about_->setText(tr("Scenario · nothing selected"));
  } else {
    name_->setWords(displayName(*first));
    const QString one = aboutOne(document_.scenario(), *first);
    about_->setText(others == 0 ? one : tr("%1 · and %2").arg(one, rest));
  }
}

QPixmap PropertyPanel::picture(const Entity& entity) const {
  const FigurePainter painter(theme_);
  const QSize size(kPictureSize, kPictureSize);
  const auto icon = [&] {
    switch (kindOf(entity)) {
      case EntityKind::Human:
        return painter.personIcon(lookOfPerson(document_, std::get<sim2d::Human>(entity)),
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

void PropertyPanel::showFrame(const FramePtr& frame, bool isRecorded) {
  frame_ = frame;
  isRecorded_ = isRecorded;
  for (const auto& [kind, page] : pages_) {
    page->setEnabled(!isRecorded);
  }
  showNow();
}

std::optional<int> PropertyPanel::agentOf(EntityId id) const {
  if (const sim2d::Human* human = document_.human(id)) {
    return human->id;
  }
  int number = 0;  // of those that take part
  for (const sim2d::Robot& robot : document_.scenario().robots) {
    number -= robot.listed ? 1 : 0;
    if (robot.key == id && robot.listed) {
      return number;
    }
  }
  return std::nullopt;
}

void PropertyPanel::showNow() {
  later_->setVisible(frame_ != nullptr && !isRecorded_ && !guest_);  // nothing of a guest is edited
  const std::vector<EntityId>& ids = document_.selection();
  if (guest_) {
    now_->show(frame_.get(), guest_->id, nullptr);
    return;
  }
  const std::optional<Entity> one =
      ids.size() == 1 && frame_ ? document_.entity(ids.front()) : std::nullopt;
  now_->show(frame_.get(), one ? agentOf(ids.front()) : std::nullopt,
             one ? std::get_if<sim2d::Robot>(&*one) : nullptr);
}

void addPropertyPanel(PanelRegistry& to) {
  to.add({30, QObject::tr("Properties"), Qt::RightDockWidgetArea, false},
         [](PanelContext& context) {
           auto* panel = new PropertyPanel(context.document, context.theme());
           QObject::connect(&context, &PanelContext::themeChanged, panel, &PropertyPanel::setTheme);
           if (context.drive != nullptr) {
             panel->offerDrive(context.drive);
           }
           QObject::connect(&context.runner, &SimulationRunner::frameShown, panel,
                            [panel, &runner = context.runner](const FramePtr& frame) {
                              panel->showFrame(frame, runner.isRecorded());
                            });
           QObject::connect(panel, &PropertyPanel::restartWanted, &context.runner,
                            [&runner = context.runner] {
                              runner.reset();
                              runner.play();
                            });
           const MapScene& scene = context.view.mapScene();
           QObject::connect(
               &scene, &MapScene::guestChanged, panel, [panel, &scene, &runner = context.runner] {
                 const auto header =
                     runner.recording() && scene.guest() ? runner.recording()->header() : nullptr;
                 const auto* guest = header ? header->human(*scene.guest()) : nullptr;
                 panel->setGuest(guest ? std::optional(*guest) : std::nullopt);
               });
           return panel;
         });
}

}  // namespace editor
