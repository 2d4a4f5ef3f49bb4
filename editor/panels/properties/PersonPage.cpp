#include <random>

#include <QHBoxLayout>

#include "app/run/Nav2Robots.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/PersonTree.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/behavior/BehaviorDialogs.h"
#include "editor/panels/behavior/GoalAssignment.h"
#include "editor/panels/properties/EntityPages.h"
#include "editor/panels/properties/PageWidgets.h"
#include "sim2d/base/Find.h"
#include "sim2d/world/World.h"

namespace editor {

using sim2d::BehaviorType;
using sim2d::Human;
using sim2d::PersonExtension;

namespace {

template <class AnyEntity>
auto& personOf(AnyEntity& entity) {
  return std::get<Human>(entity);
}

BehaviorType behaviorOf(const Entity& entity) {
  return personOf(entity).behavior.type.value_or(BehaviorType::Regular);
}

bool isAnyDrawn(const std::vector<Entity>& shown) {
  return std::any_of(shown.begin(), shown.end(),
                     [](const Entity& each) { return isDrawn(personOf(each)); });
}

}  // namespace

PersonPage::PersonPage(ScenarioDocument& document, const Theme& theme)
    : PropertyPage(document), theme_(theme) {
  addPersonSection();
  FormSection* body = addSection(tr("Pose and body"));
  addPosition(body);
  addRow(body, headingField());
  addField<Human>(body, "radius");
  addField<Human>(body, "max_vel");
  addGoalSection();
  addReactionSection();
  addForceSection();
  addGroupSection();
  addAppearanceSection();
  addMoreSection();
  addRemainingFields<Human>({"id", "group_id", "skin"});
  addRemainingFields<sim2d::Behavior>();
  addRemainingFields<PersonExtension>();
  addRefresh([this](const std::vector<Entity>& shown) { showBehavior(shown); });
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
    addMissingReactionKeys(document().scenario(), personOf(entity));
  };
  QStringList looks;
  for (int i = 1; i <= 6; ++i) {
    looks.push_back(lookName(lookOf(static_cast<BehaviorType>(i))));
  }
  behavior_ = static_cast<ChoiceField*>(addRow(section, behavior, withLabels(looks)));
  auto* mix = linkButton(tr("Mix…"), tr("Set the shares of behaviours among these people"), this,
                         [this] { openMixDialog(document(), theme_, this); });
  section->addRow(QString(), mix);
  addRefresh([section, mix](const std::vector<Entity>& shown) {
    section->setRowVisible(mix, shown.size() > 1);
  });
  addTreeRow(section);
  addField<PersonExtension>(
      section, "kind",
      withLabels({tr("Adult"), tr("Child"), tr("Elderly"), tr("Wheelchair"), tr("With luggage")}));
  addListedRow(section);
}

void PersonPage::addGoalSection() {
  FormSection* section = addSection(tr("Goals"));
  auto* editor = new RouteEditor(document(), this);
  section->addRow(tr("Route"), editor);
  connect(editor, &RouteEditor::edited, this,
          [this](const std::vector<int>& goals) { pushRoute(document(), targets(), goals); });
  section->addRow(QString(), linkButton(tr("Assign goals…"),
                                        tr("Assign ordered goals to several people (Ctrl+G)"), this,
                                        [this] { openGoalAssignment(document(), theme_, this); }));
  addRefresh([=](const std::vector<Entity>& shown) {
    const auto route =
        commonValue(shown, [](const Entity& value) { return personOf(value).goals; });
    editor->show(route.value_or(std::vector<int>()));
    section->setNote(!route              ? tr("different routes")
                     : route->size() > 1 ? tr("visited in order")
                                         : QString());
  });
  addField<Human>(section, "cyclic_goals", withLabels({tr("Repeat after the last")}));
  addField<Human>(section, "goal_radius");
  addField<PersonExtension>(
      section, "wait", withPlaceholder(tr("one per goal: 2, 0"), [this](const QString& text) {
        const auto times = listFromText(text);
        const std::vector<Entity> shown = values();
        const bool fits =
            times &&
            (times->empty() || std::all_of(shown.begin(), shown.end(), [&](const Entity& each) {
               return personOf(each).goals.size() == times->size();
             }));
        return fits && std::all_of(times->begin(), times->end(), [](double t) { return t >= 0.0; })
                   ? QString()
                   : tr("One time in seconds per goal, separated by commas");
      }));
}

void PersonPage::showBehavior(const std::vector<Entity>& shown) {
  const BehaviorType type = behaviorOf(shown.front());
  reaction_->setVisible(type != BehaviorType::Regular && type != BehaviorType::Impassive);
  reaction_->setNote(lookName(lookOf(type)));
  const auto mode =
      personOf(shown.front()).behavior.configuration.value_or(sim2d::Configuration::Default);
  static const char* const kNotes[] = {QT_TR_NOOP("Default"), QT_TR_NOOP("Custom"),
                                       QT_TR_NOOP("Random, by seed"),
                                       QT_TR_NOOP("Random, by seed")};
  forces_->setNote(tr(kNotes[static_cast<std::size_t>(mode)]));
  const bool drawn = isAnyDrawn(shown);
  forces_->setRowVisible(seed_, drawn);
  forces_->setRowVisible(drawLinks_, drawn);
  seed_->show(static_cast<double>(seed()), !ownSeed_);
  keepSeed_->setVisible(drawn && ownSeed_.has_value());
}

void PersonPage::setTheme(const Theme& theme) {
  theme_ = theme;
  const FigurePainter painter(theme_);
  for (int i = 0; i < behavior_->count(); ++i) {
    behavior_->setItemIcon(i, painter.markIcon(lookOf(static_cast<BehaviorType>(i + 1))));
  }
}

void PersonPage::addReactionSection() {
  const std::vector<BehaviorType> all = {BehaviorType::Surprised, BehaviorType::Scared,
                                         BehaviorType::Curious, BehaviorType::Threatening};
  reaction_ = addSection(tr("Reaction to the robot"));
  FieldOptions drawn;  // Values that are sampled.
  drawn.counts = [](const Entity& entity) { return !isDrawn(personOf(entity)); };
  drawn.enabled = std::not_fn(isAnyDrawn);
  const auto add = [this](const char* key, std::vector<BehaviorType> types, FieldOptions look) {
    look.visible = [types = std::move(types)](const std::vector<Entity>& shown) {
      return std::count(types.begin(), types.end(), behaviorOf(shown.front())) > 0;
    };
    addField<sim2d::Behavior>(reaction_, key, look);
  };
  add("dist", all, drawn);
  add("duration", all, drawn);
  add("vel", {BehaviorType::Scared, BehaviorType::Curious}, drawn);
  add("safe_distance", {BehaviorType::Scared}, drawn);
  add("stop_dist", {BehaviorType::Curious}, drawn);
  add("front_dist", {BehaviorType::Threatening}, drawn);
  add("once", all, withLabels({tr("Then continues")}));
}

void PersonPage::addForceSection() {
  forces_ = addSection(tr("Forces"));
  EntityField mode;
  mode.spec.form.label = tr("Strength").toStdString();
  mode.spec.help = tr("Random strengths depend only on the seed and the person").toStdString();
  mode.spec.choices = {"Default", "Custom values", "Random, normal", "Random, uniform"};
  mode.get = [choices = mode.spec.choices](const Entity& entity) {
    const auto own = personOf(entity).behavior.configuration;
    return choices[static_cast<std::size_t>(own.value_or(sim2d::Configuration::Default))];
  };
  mode.set = [choices = mode.spec.choices](Entity& entity, const base::ParameterValue& value) {
    const auto word = std::find(choices.begin(), choices.end(), std::get<std::string>(value));
    personOf(entity).behavior.configuration =
        static_cast<sim2d::Configuration>(word - choices.begin());
  };
  mode.spec.type = base::ParameterType::Choice;
  addRow(forces_, mode,
         withLabels(
             {tr("Default"), tr("Custom values"), tr("Random, normal"), tr("Random, uniform")}));
  FieldOptions factor;
  factor.counts = [](const Entity& entity) {
    return personOf(entity).behavior.configuration == sim2d::Configuration::Custom;
  };
  factor.enabled = [counts = factor.counts](const std::vector<Entity>& shown) {
    return counts(shown.front());
  };
  for (const char* key : {"goal_force_factor", "obstacle_force_factor", "social_force_factor"}) {
    addField<sim2d::Behavior>(forces_, key, factor);
  }
  addField<sim2d::Behavior>(forces_, "other_force_factor");
  addDrawRows();
}

/// Sampled values can be tried out with other seeds and written to the scenario.
void PersonPage::addDrawRows() {
  seed_ = new NumberField({0.0, 2147483647.0, 0, 1.0}, {}, this);
  seed_->setToolTip(
      tr("Show the random values of a run with this seed; the scenario keeps its "
         "seed"));
  auto* sample = linkButton(tr("Sample"), tr("Sample with another seed"), this, [this] {
    ownSeed_ = static_cast<long long>(std::random_device{}() & 0x7fffffffU) % 1000000;
    refresh();
  });
  forces_->addRow(tr("Seed"), sample, seed_);
  drawLinks_ = new QWidget(this);
  auto* freezing =
      linkButton(tr("Freeze"), tr("Store these numbers as custom values"), drawLinks_, [this] {
        const sim2d::Scenario scenario = document().scenario();
        apply(tr("Freeze random values"), [&](Entity& entity) {
          personOf(entity).behavior = frozenBehavior(scenario, personOf(entity), seed());
        });
      });
  keepSeed_ =
      linkButton(tr("Use this seed"), tr("Set it as the seed of the scenario"), drawLinks_, [this] {
        const long long wanted = seed();
        ownSeed_.reset();
        pushChange<ScenarioSettings>(
            document(), kSettingsId, tr("Change seed"),
            [wanted](ScenarioSettings& settings) { settings.desktop.seed = wanted; });
        refresh();
      });
  configuredLayout(new QHBoxLayout(drawLinks_), {}, 8, {freezing, keepSeed_})->addStretch();
  forces_->addRow(QString(), drawLinks_);
  connect(seed_, &NumberField::edited, this, [this](double value) {
    ownSeed_ = static_cast<long long>(value);
    refresh();
  });
}

long long PersonPage::seed() const {
  return ownSeed_.value_or(PropertyPage::seed());
}

void PersonPage::addMoreSection() {
  FormSection* section = addSection(tr("More"));
  using Ours = PersonExtension;
  addField<Ours>(section, "start_time");
  addField<Ours>(section, "mass");
  addField<Ours>(section, "model",
                 withNames(app::builtinRegistries().models.names(), tr("As in scenario")));
  addField<Ours>(section, "route",
                 withLabels({tr("Around walls"), tr("Straight")}, tr("As in scenario")));
  addField<Ours>(section, "at_end", withLabels({tr("Stops"), tr("Leaves"), tr("Starts over")}));
  // Keys that only the file and the simulators of HuNavSim use.
  addUniqueNumber(
      section, tr("Id of the person; part of the name of the tree file"), 0,
      [](const Entity& entity) { return personOf(entity).id; },
      [this](int wanted) {
        const bool free = document().scenario().humanById(wanted) == nullptr;
        if (free) {
          apply(tr("Change number"), [wanted](Entity& entity) { personOf(entity).id = wanted; });
        }
        return free;
      });
  EntityField height = numberField(
      tr("Height z"), tr("m"), [](const Entity& entity) { return personOf(entity).initZ; },
      [](Entity& entity, std::optional<double> z) { personOf(entity).initZ = z; });
  height.spec.form.decimals = 3;
  height.spec.help = tr("Height of the model in a 3D simulator; not used here").toStdString();
  addRow(section, height);
  addField<Ours>(section, "tree", withPlaceholder(tr("automatic")));
}

void PersonPage::addGroupSection() {
  FormSection* section = addSection(tr("Group"));
  auto* choice = new ChoiceField(this);
  choice->setToolTip(tr("People in a group stay together while they walk"));
  section->addRow(tr("Walks with"), choice);
  constexpr int kNewGroup = -2;
  connect(choice, qOverload<int>(&QComboBox::activated), this, [this, choice](int index) {
    const int group = choice->itemData(index).toInt();
    group == kNewGroup ? (void)pushGroup(document(), targets())
                       : pushJoinGroup(document(), targets(), group);
  });
  auto* name = new TextField(this);
  name->setPlaceholderText(tr("name of the group"));
  section->addRow(tr("Group name"), name);
  connect(name, &TextField::edited, this, [this, choice](const QString& text) {
    pushGroupName(document(), choice->currentData().toInt(), text.trimmed().toStdString());
  });
  auto* members = secondaryLabel({}, this);
  members->setWordWrap(true);
  section->addRow(tr("Members"), members);
  auto* dissolve =
      linkButton(tr("Dissolve"), tr("Remove all people from the group"), this,
                 [this, choice] { pushDissolveGroup(document(), choice->currentData().toInt()); });
  section->addRow(QString(), dissolve);
  addRefresh([=](const std::vector<Entity>& shown) {
    const sim2d::Scenario& scenario = document().scenario();
    const auto groups = groupsOf(scenario);
    choice->clear();
    choice->addItem(tr("None"), -1);
    for (const auto& [number, people] : groups) {
      QPixmap swatch(12, 12);
      swatch.fill(groupColor(number, theme_));
      choice->addItem(QIcon(swatch), groupName(scenario, number), number);
    }
    choice->addItem(shown.size() > 1 ? tr("Each other (new group)") : tr("New group"), kNewGroup);
    const std::optional<int> group =
        commonValue(shown, [](const Entity& each) { return personOf(each).groupId.value_or(-1); });
    choice->setCurrentIndex(group ? choice->findData(*group) : -1);
    const bool grouped = group.value_or(-1) >= 0;
    QStringList names;
    for (const EntityId id : grouped ? groups.at(*group) : std::vector<EntityId>()) {
      names << QString::fromStdString(document().human(id)->name);
    }
    members->setText(names.join(QStringLiteral(", ")));
    const auto& named = scenario.desktop.groups;
    const auto* own =
        base::findIf(named, [group](const auto& each) { return each.first == group; });
    name->show(own == nullptr ? QString() : QString::fromStdString(own->second));
    for (QWidget* widget : std::initializer_list<QWidget*>{name, members, dissolve}) {
      section->setRowVisible(widget, grouped);
    }
    section->setNote(!group ? tr("different groups") : QString());
  });
}

void PersonPage::addAppearanceSection() {
  FormSection* section = addSection(tr("Appearance"));
  auto* choice = new ChoiceField(this);
  choice->setIconSize(QSize(20, 20));
  choice->setToolTip(tr("Appearance in the simulator of the scenario"));
  section->addRow(tr("Figure"), choice);
  auto* elsewhere = secondaryLabel({}, this);
  elsewhere->setWordWrap(true);
  section->addRow(tr("Elsewhere"), elsewhere);
  connect(choice, qOverload<int>(&QComboBox::activated), this, [this, choice](int index) {
    const int skin = choice->itemData(index).toInt();
    apply(tr("Change appearance"), [skin](Entity& entity) { personOf(entity).skin = skin; });
  });
  addRefresh([=](const std::vector<Entity>& shown) {
    const std::string simulator = document().scenario().simulator.value_or(std::string());
    choice->clear();
    for (const Skin& skin : skinsOf(simulator)) {
      choice->addItem(skinIcon(skin, theme_), skinName(skin), skin.number);
    }
    const std::optional<int> worn =
        commonValue(shown, [](const Entity& each) { return personOf(each).skin.value_or(0); });
    choice->setCurrentIndex(worn ? choice->findData(skinFor(simulator, *worn).number) : -1);
    section->setNote(simulator.empty() ? tr("as in Gazebo") : QString::fromStdString(simulator));
    QStringList others;
    for (const char* other : {"Gazebo Classic", "Isaac Sim", "Webots"}) {
      if (worn && &skinsOf(other) != &skinsOf(simulator)) {
        others << QStringLiteral("%1: %2").arg(QLatin1String(other),
                                               skinName(skinFor(other, *worn)));
      }
    }
    elsewhere->setText(others.join(QLatin1Char('\n')));
  });
}

// The part of PersonPage for custom trees.

namespace {

/// Removes people with generated trees and blocks, which are updated automatically and keep their
/// blocks.
std::vector<EntityId> withoutBlocks(const ScenarioDocument& document,
                                    std::vector<EntityId> people) {
  const auto follows = [&document](EntityId id) { return hasAutoUpdatedTree(document, id); };
  people.erase(std::remove_if(people.begin(), people.end(), follows), people.end());
  return people;
}

}  // namespace

/// Reports custom trees, which changes of behaviour, reaction and goals do not affect, and offers
/// to regenerate them; trees generated with blocks are excluded.
void PersonPage::addTreeRow(FormSection* section) {
  customTreeLabel_ = secondaryLabel({}, this);
  customTreeLabel_->setWordWrap(true);
  section->addRow(QString(), customTreeLabel_);
  regenerateTree_ = linkButton(
      tr("Regenerate tree"),
      tr("Generate the tree from behaviour, reaction and goals; Ctrl+Z restores the custom tree"),
      this, [this] { pushRegeneratedTrees(document(), withoutBlocks(document(), targets())); });
  section->addRow(QString(), regenerateTree_);
  addRefresh([this, section](const std::vector<Entity>&) { showTreeRow(*section); });
}

void PersonPage::showTreeRow(FormSection& section) {
  constexpr std::size_t kMaxAsked = 200;  // Checking whether a tree is outdated is slow.
  std::size_t asked = 0, own = 0, behind = 0;
  for (const EntityId id : targets()) {
    if (!document().tree(id)) {
      continue;
    }
    const bool isAsked = ++asked <= kMaxAsked;  // The others are assumed to be equal.
    const bool isCustom = isAsked ? !hasAutoUpdatedTree(document(), id) : own > 0;
    own += isCustom ? 1 : 0;
    behind += isCustom && isAsked && document().isTreeOutdated(id) ? 1 : 0;
  }
  const bool isOne = targets().size() == 1;
  const QString who =
      isOne ? tr("Uses a custom tree.")
            : tr("%1 with custom trees.").arg(counted(own, tr("person"), tr("people")));
  const QString what = behind > 0 ? isOne ? tr("Changes made here do not affect it.")
                                          : tr("Changes made here do not affect custom trees.")
                       : isOne ? tr("Behaviour, reaction and goals do not affect it.")
                                  : tr("Behaviour, reaction and goals do not affect these trees.");
  customTreeLabel_->setText(who + QLatin1Char(' ') + what);
  section.setRowVisible(customTreeLabel_, own > 0);
  section.setRowVisible(regenerateTree_, own > 0);
}

}  // namespace editor
