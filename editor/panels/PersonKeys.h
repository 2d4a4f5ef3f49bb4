#pragma once

#include "editor/panels/KeyAccess.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

/// Keys over the properties of a person.
inline const sim2d::Human& personOf(const Entity& entity) {
  return std::get<sim2d::Human>(entity);
}
inline sim2d::Human& personOf(Entity& entity) {
  return std::get<sim2d::Human>(entity);
}
sim2d::BehaviorType behaviorOf(const Entity& entity);  // Regular when left out

NumberKey behaviorKey(const QString& label, const QString& unit, const NumberField::Range& range,
                      std::optional<double> sim2d::Behavior::*member);
/// What counts for the person when the key is left out; `seed` draws, else that of the scenario.
std::function<double(const Entity&)> resolvedOf(const ScenarioDocument& document,
                                                double sim2d::ResolvedHuman::*member,
                                                std::function<long long()> seed = {});

}  // namespace editor
