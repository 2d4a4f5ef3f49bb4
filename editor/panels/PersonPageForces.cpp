#include <algorithm>
#include <random>

#include <QHBoxLayout>

#include "editor/document/BehaviorValues.h"
#include "editor/panels/PersonPage.h"
#include "sim2d/world/World.h"

namespace editor {

using sim2d::BehaviorType;

BehaviorType behaviorOf(const Entity& entity) {
  return personOf(entity).behavior.type.value_or(BehaviorType::Regular);
}

void PersonPage::addReactionSection() {
  const std::vector<BehaviorType> all = {BehaviorType::Surprised, BehaviorType::Scared,
                                         BehaviorType::Curious, BehaviorType::Threatening};
  reaction_ = addSection(tr("Reaction to the robot"));
  const auto add = [this](const char* key, std::vector<BehaviorType> types) {
    FieldLook look;
    look.visible = [types = std::move(types)](const std::vector<Entity>& shown) {
      return std::count(types.begin(), types.end(), behaviorOf(shown.front())) > 0;
    };
    if (key == std::string("once")) {
      look.words = QStringList{tr("Then walks on")};
    } else {  // a number that a random mix draws
      look.counts = [](const Entity& entity) { return !isDrawn(personOf(entity)); };
      look.enabled = [](const std::vector<Entity>& shown) {
        return std::none_of(shown.begin(), shown.end(),
                            [](const Entity& each) { return isDrawn(personOf(each)); });
      };
    }
    addField<sim2d::Behavior>(reaction_, key, look);
  };
  add("dist", all);
  add("duration", all);
  add("vel", {BehaviorType::Scared, BehaviorType::Curious});
  add("safe_distance", {BehaviorType::Scared});
  add("stop_dist", {BehaviorType::Curious});
  add("front_dist", {BehaviorType::Threatening});
  add("once", all);
}

void PersonPage::addForceSection() {
  forces_ = addSection(tr("Forces"));
  EntityField mode;
  mode.spec.form.label = "Strength";
  mode.spec.help = "Random strengths depend on the seed and the person alone";
  mode.spec.choices = {"Default", "Own numbers", "Random, normal", "Random, uniform"};
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
  addRow(forces_, mode);
  FieldLook factor;
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

/// What a random mix draws can be tried out with other seeds, and written down.
void PersonPage::addDrawRows() {
  seed_ = new NumberField({0.0, 2147483647.0, 0, 1.0}, {}, this);
  seed_->setToolTip(tr("The draws of a run with this seed; the scenario keeps its own"));
  QToolButton* sample = linkButton(tr("Sample"), this);
  sample->setToolTip(tr("Draw again with another seed"));
  forces_->addRow(tr("Seed"), sample, seed_);
  drawLinks_ = new QWidget(this);
  auto* links = new QHBoxLayout(drawLinks_);
  links->setContentsMargins(0, 0, 0, 0);
  links->setSpacing(8);
  QToolButton* freezing = linkButton(tr("Freeze"), drawLinks_);
  freezing->setToolTip(tr("Write these numbers down as own numbers"));
  keepSeed_ = linkButton(tr("Use this seed"), drawLinks_);
  keepSeed_->setToolTip(tr("Make it the seed of the scenario"));
  links->addWidget(freezing);
  links->addWidget(keepSeed_);
  links->addStretch();
  forces_->addRow(QString(), drawLinks_);
  connect(seed_, &NumberField::edited, this, [this](double value) {
    ownSeed_ = static_cast<long long>(value);
    refresh();
  });
  connect(sample, &QToolButton::clicked, this, [this] {
    ownSeed_ = static_cast<long long>(std::random_device{}() & 0x7fffffffU) % 1000000;
    refresh();
  });
  connect(freezing, &QToolButton::clicked, this, &PersonPage::freeze);
  connect(keepSeed_, &QToolButton::clicked, this, [this] {
    const long long wanted = seed();
    ownSeed_.reset();
    pushChange<ScenarioSettings>(
        document(), kSettingsId, tr("Change seed"),
        [wanted](ScenarioSettings& settings) { settings.desktop.seed = wanted; });
    refresh();
  });
}

long long PersonPage::seed() const {
  return ownSeed_.value_or(document().scenario().desktop.seed.value_or(1));
}

void PersonPage::freeze() {
  const long long wanted = seed();
  const sim2d::Scenario scenario = document().scenario();
  apply(tr("Freeze drawn numbers"), [&](Entity& entity) {
    personOf(entity).behavior = frozenBehavior(scenario, personOf(entity), wanted);
  });
}

void PersonPage::showDraws(const std::vector<Entity>& shown) {
  const bool drawn = std::any_of(shown.begin(), shown.end(),
                                 [](const Entity& each) { return isDrawn(personOf(each)); });
  forces_->setRowVisible(seed_, drawn);
  forces_->setRowVisible(drawLinks_, drawn);
  seed_->show(static_cast<double>(seed()), !ownSeed_);
  keepSeed_->setVisible(drawn && ownSeed_.has_value());
}

}  // namespace editor
