#include "editor/document/Groups.h"

#include <algorithm>

#include "editor/document/EditCommands.h"

namespace editor {

namespace {

constexpr int kAlone = -1;
constexpr double kLeastContrast = 3.0;  // of a ring on the map

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
  // Steps of the golden angle keep neighbours apart; the strengths fit the theme.
  const int hue = static_cast<int>((static_cast<long long>(group) * 137 + 40) % 360);
  const int whole = hue < 0 ? hue + 360 : hue;
  QColor color =
      theme.isDark() ? QColor::fromHsv(whole, 120, 225) : QColor::fromHsv(whole, 190, 165);
  while (contrastRatio(color, theme.color(Role::MapFree)) < kLeastContrast) {
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
  pushJoin(document, people, group);
  return group;
}

void pushJoin(ScenarioDocument& document, const std::vector<EntityId>& people, int group) {
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

void pushDissolve(ScenarioDocument& document, int group) {
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

}  // namespace editor
