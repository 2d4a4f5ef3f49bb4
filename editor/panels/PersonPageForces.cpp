#include <algorithm>
#include <random>

#include <QHBoxLayout>

#include "editor/document/BehaviorValues.h"
#include "editor/panels/PersonKeys.h"
#include "editor/panels/PersonPage.h"
#include "sim2d/world/World.h"

namespace editor {

using sim2d::BehaviorType;
using sim2d::ResolvedHuman;

BehaviorType behaviorOf(const Entity& entity) {
  return personOf(entity).behavior.type.value_or(BehaviorType::Regular);
}

NumberKey behaviorKey(const QString& label, const QString& unit, const NumberField::Range& range,
                      std::optional<double> sim2d::Behavior::*member) {
  NumberKey key;
  key.label = label;
  key.unit = unit;
  key.range = range;
  key.get = [member](const Entity& entity) { return personOf(entity).behavior.*member; };
  key.set = [member](Entity& entity, std::optional<double> value) {
    personOf(entity).behavior.*member = value;
  };
  return key;
}

std::function<double(const Entity&)> resolvedOf(const ScenarioDocument& document,
                                                double ResolvedHuman::*member,
                                                std::function<long long()> seed) {
  return [&document, member, seed = std::move(seed)](const Entity& entity) {
    const sim2d::Scenario& scenario = document.scenario();
    const long long count = seed ? seed() : scenario.desktop.seed.value_or(1);
    return sim2d::resolveHuman(scenario, personOf(entity), count).*member;
  };
}

void PersonPage::addReactionNumber(const NumberKey& key, std::vector<BehaviorType> of) {
  reactionRows_.emplace_back(addNumber(reaction_, key), std::move(of));
}

void PersonPage::addReactionSection() {
  using Behavior = sim2d::Behavior;
  const std::vector<BehaviorType> all = {BehaviorType::Surprised, BehaviorType::Scared,
                                         BehaviorType::Curious, BehaviorType::Threatening};
  reaction_ = addSection(tr("Reaction to the robot"));
  const auto add = [this](NumberKey key, double ResolvedHuman::*member, double sliderTo,
                          const QString& hint, const std::vector<BehaviorType>& of) {
    key.fallback = resolvedOf(document(), member, [this] { return seed(); });
    key.get = [own = key.get](const Entity& entity) {
      return isDrawn(personOf(entity)) ? std::nullopt : own(entity);
    };
    key.sliderTo = sliderTo;
    key.hint = hint;
    addReactionNumber(key, of);
    drawnFields_.push_back(reactionRows_.back().first->parentWidget());
  };
  add(behaviorKey(tr("Sees within"), tr("m"), {0.1, 50.0, 2, 0.5}, &Behavior::dist),
      &ResolvedHuman::noticeDistance, 15.0, tr("The robot is noticed within this distance"), all);
  add(behaviorKey(tr("Lasts"), tr("s"), {0.1, 3600.0, 1, 1.0}, &Behavior::duration),
      &ResolvedHuman::reactionDuration, 80.0, tr("How long the reaction goes on"), all);
  add(behaviorKey(tr("Speed"), tr("m/s"), {0.0, 3.0, 2, 0.1}, &Behavior::vel),
      &ResolvedHuman::reactionSpeed, 2.0, tr("Speed while reacting"),
      {BehaviorType::Scared, BehaviorType::Curious});
  add(behaviorKey(tr("Keeps away"), tr("m"), {0.1, 20.0, 2, 0.5}, &Behavior::safeDistance),
      &ResolvedHuman::safeDistance, 10.0, tr("Distance at which the person feels safe again"),
      {BehaviorType::Scared});
  add(behaviorKey(tr("Stops at"), tr("m"), {0.1, 10.0, 2, 0.1}, &Behavior::stopDist),
      &ResolvedHuman::stopDistance, 3.0, tr("How near the person comes to the robot"),
      {BehaviorType::Curious});
  add(behaviorKey(tr("Blocks at"), tr("m"), {0.1, 10.0, 2, 0.1}, &Behavior::frontDist),
      &ResolvedHuman::frontDistance, 3.0, tr("How far before the robot the person stands"),
      {BehaviorType::Threatening});
  SwitchKey once;
  once.label = tr("Only once");
  once.words = tr("Then walks on");
  once.get = [](const Entity& entity) { return personOf(entity).behavior.once.value_or(false); };
  once.set = [](Entity& entity, bool on) { personOf(entity).behavior.once = on; };
  reactionRows_.emplace_back(addSwitch(reaction_, once), all);
}

void PersonPage::addForceSection() {
  using Behavior = sim2d::Behavior;
  forces_ = addSection(tr("Forces"));
  ChoiceKey mode;
  mode.label = tr("Strength");
  mode.words =
      QStringList{tr("Default"), tr("Own numbers"), tr("Random, normal"), tr("Random, uniform")};
  mode.get = [](const Entity& entity) {
    return static_cast<int>(
        personOf(entity).behavior.configuration.value_or(sim2d::Configuration::Default));
  };
  mode.set = [](Entity& entity, int index) {
    personOf(entity).behavior.configuration = static_cast<sim2d::Configuration>(index);
  };
  mode.hint = tr("Random strengths depend on the seed and the person alone");
  addChoice(forces_, mode);
  const auto add = [this](const QString& label, std::optional<double> Behavior::*member,
                          double ResolvedHuman::*what, double sliderTo) {
    NumberKey key = behaviorKey(label, {}, {0.0, 100.0, 2, 0.5}, member);
    key.fallback = resolvedOf(document(), what, [this] { return seed(); });
    key.get = [member](const Entity& entity) -> std::optional<double> {
      const bool own = personOf(entity).behavior.configuration == sim2d::Configuration::Custom;
      return own ? personOf(entity).behavior.*member : std::nullopt;
    };
    key.sliderTo = sliderTo;
    forceFields_.push_back(addNumber(forces_, key)->parentWidget());
  };
  add(tr("Goal"), &Behavior::goalForceFactor, &ResolvedHuman::goalFactor, 10.0);
  add(tr("Obstacles"), &Behavior::obstacleForceFactor, &ResolvedHuman::obstacleFactor, 50.0);
  add(tr("People"), &Behavior::socialForceFactor, &ResolvedHuman::socialFactor, 20.0);
  NumberKey robot = behaviorKey(tr("Robot"), {}, {0.0, 100.0, 2, 1.0}, &Behavior::otherForceFactor);
  robot.fallback = resolvedOf(document(), &ResolvedHuman::otherFactor);
  robot.sliderTo = 25.0;
  robot.hint = tr("Push away from the robot while scared; never drawn");
  addNumber(forces_, robot);
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
  for (QWidget* field : drawnFields_) {
    field->setEnabled(!drawn);
  }
}

}  // namespace editor
