#include "editor/document/FreeNames.h"

#include <type_traits>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

std::string stemOf(const Entity& entity) {
  switch (kindOf(entity)) {
    case EntityKind::Human:
      return "agent";
    case EntityKind::Obstacle:
      return "obstacle";
    default:
      return kindName(kindOf(entity)).toStdString();
  }
}

/// "Ana2" -> "Ana": a copy counts on from there.
std::string withoutNumber(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

}  // namespace

FreeNames::FreeNames(const sim2d::Scenario& scenario) {
  const auto collect = [this](const auto& list) {
    for (const auto& value : list) {
      names_.insert(value.name);
    }
  };
  collect(scenario.humans);
  collect(scenario.robots);
  collect(scenario.obstacles);
  collect(scenario.doors);
  collect(scenario.areas);
  for (const sim2d::GlobalGoal& goal : scenario.goals) {
    goals_.insert(goal.id);
  }
  for (const sim2d::Human& human : scenario.humans) {
    humans_.insert(human.id);
  }
}

std::string FreeNames::name(const std::string& stem) {
  for (int& number = next_.emplace(stem, 1).first->second;; ++number) {
    std::string candidate = stem + std::to_string(number);
    if (names_.insert(candidate).second) {
      return candidate;
    }
  }
}

void FreeNames::give(Entity& value) {
  if (auto* goal = std::get_if<sim2d::GlobalGoal>(&value)) {
    if (goal->id < 1 || goals_.count(goal->id) > 0) {
      goal->id = nextGoal();
    }
    goals_.insert(goal->id);
    return;
  }
  if (auto* human = std::get_if<sim2d::Human>(&value)) {
    if (human->id < 0 || humans_.count(human->id) > 0) {
      human->id = nextHuman();
    }
    humans_.insert(human->id);
  }
  const std::string wanted = nameOf(value);
  if (wanted.empty() || isTaken(wanted)) {
    setName(value, name(wanted.empty() ? stemOf(value) : withoutNumber(wanted)));
  } else {
    names_.insert(wanted);
  }
}

void setName(Entity& entity, const std::string& name) {
  std::visit(
      [&name](auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (!std::is_same_v<Value, sim2d::GlobalGoal> &&
                      !std::is_same_v<Value, ScenarioSettings>) {
          value.name = name;
        }
      },
      entity);
}

std::string freeName(const sim2d::Scenario& scenario, const std::string& stem) {
  return FreeNames(scenario).name(stem);
}

int freeGoalId(const sim2d::Scenario& scenario) {
  return FreeNames(scenario).nextGoal();
}

int freeHumanId(const sim2d::Scenario& scenario) {
  return FreeNames(scenario).nextHuman();
}

bool isNameTaken(const sim2d::Scenario& scenario, const std::string& name) {
  return FreeNames(scenario).isTaken(name);
}

}  // namespace editor
