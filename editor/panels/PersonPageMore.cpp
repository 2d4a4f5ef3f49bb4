#include <algorithm>

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
                                                double ResolvedHuman::*member) {
  return [&document, member](const Entity& entity) {
    const sim2d::Scenario& scenario = document.scenario();
    return sim2d::resolveHuman(scenario, personOf(entity), scenario.desktop.seed.value_or(1)).*
           member;
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
    key.fallback = resolvedOf(document(), member);
    key.sliderTo = sliderTo;
    key.hint = hint;
    addReactionNumber(key, of);
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
  add(behaviorKey(tr("Pushed by robot"), {}, {0.0, 100.0, 1, 1.0}, &Behavior::otherForceFactor),
      &ResolvedHuman::otherFactor, 25.0, tr("Strength of the push away from the robot"),
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
    key.fallback = resolvedOf(document(), what);
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
}

void PersonPage::addMoreSection() {
  FormSection* section = addSection(tr("More"));
  NumberKey group;
  group.label = tr("Group");
  group.range = {-1.0, 9999.0, 0, 1.0};
  group.hint = tr("People of one group keep together; -1 is alone");
  group.get = [](const Entity& entity) -> std::optional<double> {
    const std::optional<int> id = personOf(entity).groupId;
    return id ? std::optional<double>(*id) : std::nullopt;
  };
  group.set = [](Entity& entity, std::optional<double> value) {
    personOf(entity).groupId = value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  };
  group.fallback = [](const Entity&) { return -1.0; };
  addNumber(section, group);
  NumberKey start;
  start.label = tr("Comes at");
  start.unit = tr("s");
  start.range = {0.0, 86400.0, 1, 1.0};
  start.hint = tr("Enters the world at this time");
  start.get = [](const Entity& entity) { return personOf(entity).ours.startTime; };
  start.set = [](Entity& entity, std::optional<double> value) {
    personOf(entity).ours.startTime = value;
  };
  addNumber(section, start);
  NumberKey mass;
  mass.label = tr("Mass");
  mass.unit = tr("kg");
  mass.range = {1.0, 500.0, 1, 1.0};
  mass.get = [](const Entity& entity) { return personOf(entity).ours.mass; };
  mass.set = [](Entity& entity, std::optional<double> value) {
    personOf(entity).ours.mass = value;
  };
  mass.fallback = resolvedOf(document(), &ResolvedHuman::mass);
  addNumber(section, mass);
  ChoiceKey model = nameChoice(
      tr("Model"), tr("The scenario's"), sim2d::modelNames(),
      [](Entity & entity) -> auto& { return personOf(entity).ours.model; });
  model.hint = tr("How the person moves among others");
  addChoice(section, model);
  ChoiceKey end;
  end.label = tr("At the end");
  end.words = QStringList{tr("Stops"), tr("Leaves"), tr("Starts over")};
  end.get = [](const Entity& entity) {
    return static_cast<int>(personOf(entity).ours.atEnd.value_or(sim2d::AtEnd::Stop));
  };
  end.set = [](Entity& entity, int index) {
    personOf(entity).ours.atEnd = static_cast<sim2d::AtEnd>(index);
  };
  end.hint = tr("After the last goal of a route that does not repeat");
  addChoice(section, end);
}

}  // namespace editor
