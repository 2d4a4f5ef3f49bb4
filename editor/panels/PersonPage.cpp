#include "editor/panels/PersonPage.h"

#include <algorithm>

#include "editor/document/BehaviorValues.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/GoalAssignment.h"
#include "editor/panels/PersonKeys.h"
#include "editor/panels/Skins.h"

namespace editor {

using sim2d::BehaviorType;
using sim2d::Human;
using sim2d::ResolvedHuman;

PersonPage::PersonPage(ScenarioDocument& document, const Theme& theme, QWidget* parent)
    : PropertyPage(document, parent), theme_(theme) {
  addPersonSection();
  addBodySection();
  addGoalSection();
  addReactionSection();
  addForceSection();
  addGroupSection();
  addAppearanceSection();
  addMoreSection();
  finish();
  setTheme(theme);
}

void PersonPage::addPersonSection() {
  FormSection* section = addSection(tr("Person"));
  addName(section);
  ChoiceKey behavior;
  behavior.label = tr("Behaviour");
  for (int i = 1; i <= 6; ++i) {
    behavior.words.push_back(lookName(lookOf(static_cast<BehaviorType>(i))));
  }
  behavior.get = [](const Entity& entity) { return static_cast<int>(behaviorOf(entity)) - 1; };
  behavior.set = [this](Entity& entity, int index) {
    personOf(entity).behavior.type = static_cast<BehaviorType>(index + 1);
    completeReaction(document().scenario(), personOf(entity));
  };
  behavior.hint = tr("How the person reacts to the robot");
  behavior_ = addChoice(section, behavior);
  ChoiceKey kind;
  kind.label = tr("Body");
  kind.words =
      QStringList{tr("Adult"), tr("Child"), tr("Elderly"), tr("Wheelchair"), tr("With luggage")};
  kind.get = [](const Entity& entity) {
    return static_cast<int>(personOf(entity).ours.kind.value_or(sim2d::PersonKind::Adult));
  };
  kind.set = [](Entity& entity, int index) {
    const auto value = static_cast<sim2d::PersonKind>(index);
    personOf(entity).ours.kind =
        value == sim2d::PersonKind::Adult ? std::nullopt : std::optional(value);
  };
  kind.hint = tr("Gives the mass and the figure on the map");
  addChoice(section, kind);
  addSwitch(section, listedKey());
}

void PersonPage::addBodySection() {
  FormSection* section = addSection(tr("Pose and body"));
  addNumberPair(section, tr("Position"), xKey(), yKey());
  addNumber(section, headingKey());
  NumberKey radius = numberKey(tr("Radius"), tr("m"), {0.1, 1.0, 2, 0.01}, &Human::radius, 0.0);
  radius.fallback = resolvedOf(document(), &ResolvedHuman::radius);
  radius.sliderTo = 0.8;
  addNumber(section, radius);
  NumberKey speed = numberKey(tr("Top speed"), tr("m/s"), {0.0, 3.0, 2, 0.05}, &Human::maxVel, 0.0);
  speed.fallback = resolvedOf(document(), &ResolvedHuman::desiredSpeed);
  speed.sliderTo = 2.0;
  speed.hint = tr("The speed the person wants to walk at");
  addNumber(section, speed);
}

void PersonPage::addGoalSection() {
  goals_ = addSection(tr("Goals"));
  route_ = new RouteEditor(document(), this);
  goals_->addRow(tr("Route"), route_);
  connect(route_, &RouteEditor::edited, this,
          [this](const std::vector<int>& goals) { pushRoute(document(), targets(), goals); });
  QToolButton* assign = linkButton(tr("Assign goals…"), this);
  assign->setToolTip(tr("Goals of several people at once, in order by drag (Ctrl+G)"));
  goals_->addRow(QString(), assign);
  connect(assign, &QToolButton::clicked, this,
          [this] { openGoalAssignment(document(), theme_, this); });
  addRefresh([this](const std::vector<Entity>& shown) {
    const std::vector<int>& first = personOf(shown.front()).goals;
    const bool same = std::all_of(shown.begin(), shown.end(), [&](const Entity& value) {
      return personOf(value).goals == first;
    });
    route_->show(same ? first : std::vector<int>());
    goals_->setNote(!same              ? tr("different routes")
                    : first.size() > 1 ? tr("visited in order")
                                       : QString());
  });
  SwitchKey repeat;
  repeat.label = tr("Repeat");
  repeat.words = tr("Start again after the last");
  repeat.get = [](const Entity& entity) { return personOf(entity).cyclicGoals.value_or(true); };
  repeat.set = [](Entity& entity, bool on) { personOf(entity).cyclicGoals = on; };
  addSwitch(goals_, repeat);
  NumberKey radius =
      numberKey(tr("Arrival radius"), tr("m"), {0.05, 5.0, 2, 0.05}, &Human::goalRadius, 0.0);
  radius.fallback = resolvedOf(document(), &ResolvedHuman::goalRadius);
  radius.hint = tr("A goal is reached when the person is this near");
  addNumber(goals_, radius);
  TextKey waits;
  waits.label = tr("Waits");
  waits.placeholder = tr("seconds at each goal");
  waits.hint = tr("One time for each goal of the route, such as 0, 5, 2.5");
  waits.get = [](const Entity& entity) { return listText(personOf(entity).ours.wait); };
  waits.set = [](Entity& entity, const QString& text) {
    personOf(entity).ours.wait = listFromText(text).value_or(std::vector<double>());
  };
  waits.check = [this](const QString& text) {
    const auto times = listFromText(text);
    const std::vector<Entity> shown = values();
    const bool fits = times && (times->empty() ||
                                std::all_of(shown.begin(), shown.end(), [&](const Entity& each) {
                                  return personOf(each).goals.size() == times->size();
                                }));
    return fits && std::all_of(times->begin(), times->end(), [](double t) { return t >= 0.0; })
               ? QString()
               : tr("One time in seconds for each goal, with commas between them");
  };
  addText(goals_, waits);
}

void PersonPage::showRowsOf(BehaviorType type) {
  const bool reacts = type != BehaviorType::Regular && type != BehaviorType::Impassive;
  reaction_->setVisible(reacts);
  reaction_->setNote(lookName(lookOf(type)));
  for (const auto& [field, types] : reactionRows_) {
    reaction_->setRowVisible(field, std::find(types.begin(), types.end(), type) != types.end());
  }
}

void PersonPage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  if (shown.empty()) {
    return;
  }
  showRowsOf(behaviorOf(shown.front()));
  const auto mode =
      personOf(shown.front()).behavior.configuration.value_or(sim2d::Configuration::Default);
  static const char* const kNotes[] = {QT_TR_NOOP("Default mix"), QT_TR_NOOP("Own mix"),
                                       QT_TR_NOOP("Drawn by the seed"),
                                       QT_TR_NOOP("Drawn by the seed")};
  forces_->setNote(tr(kNotes[static_cast<std::size_t>(mode)]));
  for (QWidget* field : forceFields_) {
    field->setEnabled(mode == sim2d::Configuration::Custom);
  }
  showDraws(shown);
}

void PersonPage::setTheme(const Theme& theme) {
  theme_ = theme;
  const FigurePainter painter(theme_);
  for (int i = 0; i < behavior_->count(); ++i) {
    behavior_->setItemIcon(i, painter.markIcon(lookOf(static_cast<BehaviorType>(i + 1))));
  }
}

}  // namespace editor
