#include "editor/document/FreeNames.h"

#include <algorithm>
#include <type_traits>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

std::string usualStem(EntityKind kind) {
  return kind == EntityKind::Human ? "agent" : kindName(kind).toStdString();
}

/// "Ana2" -> "Ana": a copy counts on from there.
std::string withoutNumber(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

}  // namespace

FreeNames::FreeNames(const sim2d::Scenario& scenario) {
  forEachList(scenario, [this](EntityKind /*kind*/, const auto& list) {
    for (const auto& value : list) {
      if constexpr (kIsNamed<std::decay_t<decltype(value)>>) {
        names_.insert(value.name);
      } else {
        goals_.insert(value.id);
      }
    }
  });
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
    setName(value, name(wanted.empty() ? usualStem(kindOf(value)) : withoutNumber(wanted)));
  } else {
    names_.insert(wanted);
  }
}

Places::Places(const sim2d::Scenario& scenario) {
  forEachList(scenario, [this](EntityKind kind, const auto& list) {
    for (const auto& value : list) {
      if constexpr (kIsNamed<std::decay_t<decltype(value)>>) {
        ++countOf(kind, value.listed);
      } else {
        ++countOf(kind, true);
      }
    }
  });
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed) {
      people_.push_back(human.id);
    }
  }
}

int Places::ofNew(const Entity& value) {
  const auto* human = std::get_if<sim2d::Human>(&value);
  if (human != nullptr && human->listed) {
    people_.push_back(human->id);
  }
  return place(kindOf(value), isListed(value));
}

int Places::ofSwitched(const Entity& value) {
  --countOf(kindOf(value), !isListed(value));
  const int last = place(kindOf(value), isListed(value));
  const auto* human = std::get_if<sim2d::Human>(&value);
  return human == nullptr ? last : placeOfPerson(human->id, human->listed).value_or(last);
}

std::optional<int> Places::placeOfPerson(int number, bool listed) {
  if (!listed) {
    people_.erase(std::remove(people_.begin(), people_.end(), number), people_.end());
    return std::nullopt;
  }
  const auto next =
      std::find_if(people_.begin(), people_.end(), [number](int each) { return each > number; });
  const auto index = static_cast<int>(next - people_.begin());
  people_.insert(next, number);
  return index;
}

int Places::place(EntityKind kind, bool listed) {
  const int before = countOf(kind, true) + (listed ? 0 : countOf(kind, false));
  ++countOf(kind, listed);
  return before;
}

void setName(Entity& entity, const std::string& name) {
  std::visit(
      [&name](auto& value) {
        if constexpr (kIsNamed<std::decay_t<decltype(value)>>) {
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
