#include "editor/document/UniqueNames.h"

#include <type_traits>

#include "editor/document/Entity.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

std::string defaultStem(EntityKind kind) {
  return kind == EntityKind::Human ? "agent" : kindName(kind).toStdString();
}

/// "Ana2" -> "Ana": numbering of copies continues from there.
std::string withoutNumber(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

}  // namespace

std::string sanitizedName(const Entity& entity) {
  std::string stem;
  for (const char letter : nameOf(entity)) {
    const bool fine = base::isLetter(letter) || base::isDigit(letter) || letter == '_';
    stem += fine ? letter : '_';
  }
  const bool startsWell = !stem.empty() && base::isLetter(stem[0]);
  return startsWell ? stem : kindName(kindOf(entity)).toStdString() + stem;
}

UniqueNames::UniqueNames(const sim2d::Scenario& scenario) {
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

std::string UniqueNames::name(const std::string& stem) {
  for (int& number = next_.emplace(stem, 1).first->second;; ++number) {
    std::string candidate = stem + std::to_string(number);
    if (names_.insert(candidate).second) {
      return candidate;
    }
  }
}

void UniqueNames::assignTo(Entity& value) {
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
    setName(value, name(wanted.empty() ? defaultStem(kindOf(value)) : withoutNumber(wanted)));
  } else {
    names_.insert(wanted);
  }
}

}  // namespace editor
