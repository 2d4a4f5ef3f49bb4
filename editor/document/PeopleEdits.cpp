#include "editor/document/PeopleEdits.h"

#include "editor/document/EditCommands.h"
#include "sim2d/scenario/Fields.h"

namespace editor {

void addMissingReactionKeys(const sim2d::Scenario& scenario, sim2d::Human& human) {
  const sim2d::ResolvedHuman counts = sim2d::resolveHuman(scenario, human, 0);
  if (!isDrawn(human)) {
    sim2d::fillFields(human.behavior, counts, sim2d::reactionKeys(counts.behavior));
  } else if (reactsToRobot(counts.behavior)) {
    sim2d::fillFields(human.behavior, counts, {"once"});
  }
}

bool isDrawn(const sim2d::Human& human) {
  return isDrawn(human.behavior.configuration.value_or(sim2d::Configuration::Default));
}

sim2d::Behavior frozenBehavior(const sim2d::Scenario& scenario, const sim2d::Human& human,
                               long long seed) {
  sim2d::Behavior frozen = human.behavior;
  if (!isDrawn(human)) {
    return frozen;
  }
  const sim2d::ResolvedHuman drawn = sim2d::resolveHuman(scenario, human, seed);
  frozen.configuration = sim2d::Configuration::Custom;
  sim2d::fillFields(frozen, drawn, sim2d::factorKeys(), true);
  sim2d::fillFields(frozen, drawn, sim2d::reactionKeys(drawn.behavior), true);
  frozen.once = human.behavior.once;  // `once` is not sampled.
  return frozen;
}

namespace {

constexpr int kAlone = -1;
constexpr double kMinContrast = 3.0;  // Minimum contrast of a ring on the map.

void setNameOf(std::vector<std::pair<int, std::string>>& groups, int group,
               const std::string& name) {
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [group](const auto& each) { return each.first == group; }),
               groups.end());
  if (!name.empty()) {
    groups.emplace_back(group, name);
    std::sort(groups.begin(), groups.end());
  }
}

}  // namespace

bool isInGroup(const sim2d::Human& human) {
  return human.groupId.value_or(kAlone) != kAlone;
}

std::map<int, std::vector<EntityId>> groupsOf(const sim2d::Scenario& scenario) {
  std::map<int, std::vector<EntityId>> groups;
  for (const sim2d::Human& human : scenario.humans) {
    if (isInGroup(human)) {
      groups[*human.groupId].push_back(human.key);
    }
  }
  return groups;
}

QString groupName(const sim2d::Scenario& scenario, int group) {
  for (const auto& [number, name] : scenario.desktop.groups) {
    if (number == group) {
      return QString::fromStdString(name);
    }
  }
  return QObject::tr("Group %1").arg(group);
}

QColor groupColor(int group, const Theme& theme) {
  // Golden-angle steps separate neighbouring hues; saturation and value depend on the theme.
  const int hue = static_cast<int>((static_cast<long long>(group) * 137 + 40) % 360);
  const int whole = hue < 0 ? hue + 360 : hue;
  QColor color =
      theme.isDark() ? QColor::fromHsv(whole, 120, 225) : QColor::fromHsv(whole, 190, 165);
  while (contrastRatio(color, theme.color(Role::MapFree)) < kMinContrast) {
    color = theme.isDark() ? color.lighter(105) : color.darker(105);
  }
  return color;
}

int pushGroup(ScenarioDocument& document, const std::vector<EntityId>& people) {
  const auto groups = groupsOf(document.scenario());
  int group = 1;
  while (groups.count(group) > 0) {
    ++group;
  }
  pushJoinGroup(document, people, group);
  return group;
}

void pushJoinGroup(ScenarioDocument& document, const std::vector<EntityId>& people, int group) {
  std::vector<Entity> values;
  for (const EntityId person : people) {
    if (const sim2d::Human* human = document.human(person)) {
      values.emplace_back(*human);
      std::get<sim2d::Human>(values.back()).groupId = group;
    }
  }
  pushEdit(
      document, std::move(values),
      group == kAlone ? QObject::tr("Leave the group") : QObject::tr("Join group %1").arg(group));
}

void pushDissolveGroup(ScenarioDocument& document, int group) {
  Draft draft(document);
  draft.forEach<sim2d::Human>([group](sim2d::Human& human) {
    if (human.groupId == group) {
      human.groupId = kAlone;
    }
  });
  auto settings = std::get<ScenarioSettings>(*document.entity(kSettingsId));
  setNameOf(settings.desktop.groups, group, {});
  draft.set(settings);
  draft.push(QObject::tr("Dissolve group %1").arg(group));
}

void pushGroupName(ScenarioDocument& document, int group, const std::string& name) {
  pushChange<ScenarioSettings>(
      document, kSettingsId, QObject::tr("Name group %1").arg(group),
      [&](ScenarioSettings& settings) { setNameOf(settings.desktop.groups, group, name); });
}

void setGoals(sim2d::Human& human, const std::vector<int>& goals) {
  std::vector<double>& waits = human.ours.wait;
  if (waits.size() != human.goals.size()) {
    waits.clear();
  }
  if (!waits.empty()) {
    std::vector<int> before = human.goals;
    std::vector<double> kept;
    for (const int goal : goals) {
      const auto found = std::find(before.begin(), before.end(), goal);
      const bool known = goal > 0 && found != before.end();
      kept.push_back(known ? waits[static_cast<std::size_t>(found - before.begin())] : 0.0);
      if (known) {
        *found = 0;  // The next visit of the same goal has its own waiting time.
      }
    }
    waits = std::move(kept);
  }
  human.goals = goals;
}

RoutePlan::RoutePlan(const ScenarioDocument& document) {
  for (const sim2d::Human& human : document.scenario().humans) {
    people_.push_back(human.key);
    plannedRoutes_[human.key] = {human.goals, human.cyclicGoals.value_or(true)};
  }
}

void RoutePlan::append(const std::vector<EntityId>& people, const std::vector<int>& goals) {
  for (const EntityId person : people) {
    std::vector<int>& route = plannedRoutes_.at(person).goals;
    route.insert(route.end(), goals.begin(), goals.end());
  }
}

std::vector<EntityId> RoutePlan::push(ScenarioDocument& document) const {
  std::vector<EntityId> changed;
  std::vector<Entity> edited;
  for (const EntityId person : people_) {
    const sim2d::Human* before = document.human(person);
    if (before == nullptr) {
      continue;
    }
    sim2d::Human after = *before;
    const PlannedRoute& round = plannedRoutes_.at(person);
    if (round.goals != after.goals) {
      setGoals(after, round.goals);
    }
    if (round.repeat != after.cyclicGoals.value_or(true)) {
      after.cyclicGoals = round.repeat;
    }
    if (!(after == *before)) {
      edited.emplace_back(std::move(after));
      changed.push_back(person);
    }
  }
  const QString text = edited.size() == 1
                           ? QObject::tr("Assign goals to %1").arg(displayName(edited.front()))
                           : QObject::tr("Assign goals to %1 people").arg(edited.size());
  pushEdit(document, std::move(edited), text);
  return changed;
}

}  // namespace editor
