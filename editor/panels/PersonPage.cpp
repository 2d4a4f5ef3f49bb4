#include "editor/panels/PersonPage.h"

#include <algorithm>

#include "editor/document/BehaviorValues.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/GoalAssignment.h"
#include "editor/panels/ListText.h"
#include "editor/panels/Skins.h"

namespace editor {

using sim2d::BehaviorType;
using sim2d::Human;
using sim2d::PersonExtension;

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
  addNewFields<Human>({"id", "group_id", "skin"});
  addNewFields<sim2d::Behavior>();
  addNewFields<PersonExtension>();
  finish();
  setTheme(theme);
}

void PersonPage::addPersonSection() {
  FormSection* section = addSection(tr("Person"));
  addName(section);
  EntityField behavior;
  behavior.spec = sim2d::fieldOf<sim2d::Behavior>("type")->spec;
  behavior.get = [](const Entity& entity) { return sim2d::behaviorName(behaviorOf(entity)); };
  behavior.set = [this](Entity& entity, const base::ParameterValue& value) {
    personOf(entity).behavior.type = sim2d::behaviorFromName(std::get<std::string>(value));
    completeReaction(document().scenario(), personOf(entity));
  };
  QStringList looks;
  for (int i = 1; i <= 6; ++i) {
    looks.push_back(lookName(lookOf(static_cast<BehaviorType>(i))));
  }
  behavior_ = static_cast<ChoiceField*>(addRow(section, behavior, inWords(looks)));
  addField<PersonExtension>(
      section, "kind",
      inWords({tr("Adult"), tr("Child"), tr("Elderly"), tr("Wheelchair"), tr("With luggage")}));
  addListed(section);
}

void PersonPage::addBodySection() {
  FormSection* section = addSection(tr("Pose and body"));
  addNumberPair(section, tr("Position"), xField(), yField());
  addRow(section, headingField());
  addField<Human>(section, "radius");
  addField<Human>(section, "max_vel");
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
  addField<Human>(goals_, "cyclic_goals", inWords({tr("Start again after the last")}));
  addField<Human>(goals_, "goal_radius");
  addField<PersonExtension>(
      goals_, "wait", emptyAs(tr("seconds at each goal"), [this](const QString& text) {
        const auto times = listFromText(text);
        const std::vector<Entity> shown = values();
        const bool fits =
            times &&
            (times->empty() || std::all_of(shown.begin(), shown.end(), [&](const Entity& each) {
               return personOf(each).goals.size() == times->size();
             }));
        return fits && std::all_of(times->begin(), times->end(), [](double t) { return t >= 0.0; })
                   ? QString()
                   : tr("One time in seconds for each goal, with commas between them");
      }));
}

void PersonPage::refresh() {
  PropertyPage::refresh();
  const std::vector<Entity> shown = values();
  if (shown.empty()) {
    return;
  }
  const BehaviorType type = behaviorOf(shown.front());
  reaction_->setVisible(type != BehaviorType::Regular && type != BehaviorType::Impassive);
  reaction_->setNote(lookName(lookOf(type)));
  const auto mode =
      personOf(shown.front()).behavior.configuration.value_or(sim2d::Configuration::Default);
  static const char* const kNotes[] = {QT_TR_NOOP("Default mix"), QT_TR_NOOP("Own mix"),
                                       QT_TR_NOOP("Drawn by the seed"),
                                       QT_TR_NOOP("Drawn by the seed")};
  forces_->setNote(tr(kNotes[static_cast<std::size_t>(mode)]));
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
