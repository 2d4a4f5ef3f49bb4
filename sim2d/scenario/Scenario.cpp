#include "sim2d/scenario/Scenario.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <type_traits>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"

namespace sim2d {
namespace {

const std::vector<std::string>& behaviorWords() {
  static const std::vector<std::string>& kWords = fieldOf<Behavior>("type")->spec.choices;
  return kWords;
}

/// Compares all keys of the field table.
template <class T>
bool haveSameKeys(const T& a, const T& b) {
  const Fields<T>& all = fieldsOf<T>();
  return std::all_of(all.begin(), all.end(), [&](const auto& each) { return each.equal(a, b); });
}
bool haveSameKeys(const GlobalGoal& /*a*/, const GlobalGoal& /*b*/) {
  return true;
}
bool haveSameKeys(const Scenario& a, const Scenario& b) {
  return haveSameKeys<ScenarioSettings>(a, b);
}

/// Members that are compared in addition to the table.
template <class T>
auto restOf(const T& of) {
  if constexpr (std::is_base_of_v<NamedEntity, T>) {
    return std::tie(of.name, of.listed);
  } else {
    return std::tuple<>();
  }
}
auto restOf(const GlobalGoal& of) {
  return std::tie(of.id, of.position);
}
auto restOf(const Human& of) {
  return std::tie(of.name, of.listed, of.initPose, of.hasInitPose, of.initZ, of.initPoseUnknown,
                  of.behavior, of.goals, of.ours);
}
auto restOf(const DesktopSettings& of) {
  return std::tie(of.metrics);
}
/// Unknown keys in the map of each quantity.
std::vector<UnknownKeys> restOf(const VariationSettings& of) {
  std::vector<UnknownKeys> unknown;
  std::transform(of.spreads.begin(), of.spreads.end(), std::back_inserter(unknown),
                 [](const SpreadSettings& each) { return each.unknown; });
  return unknown;
}
auto restOf(const Scenario& of) {
  return std::tie(of.goals, of.humans, of.robots, of.obstacles, of.doors, of.areas, of.docks,
                  of.desktop, of.otherNodes);
}

}  // namespace

const char* behaviorName(BehaviorType type) {
  return behaviorWords().at(static_cast<std::size_t>(type) - 1).c_str();
}

std::optional<BehaviorType> behaviorFromName(const std::string& word) {
  const std::string lower = base::toLower(word);
  for (std::size_t i = 0; i < behaviorWords().size(); ++i) {
    if (base::toLower(behaviorWords()[i]) == lower) {
      return static_cast<BehaviorType>(i + 1);
    }
  }
  return std::nullopt;
}

const GlobalGoal* Scenario::goal(int id) const {
  const auto usual = static_cast<std::size_t>(id) - 1;  // usually numbered from 1
  if (id >= 1 && usual < goals.size() && goals[usual].id == id) {
    return &goals[usual];
  }
  return base::findBy(goals, &GlobalGoal::id, id);
}

const Human* Scenario::human(const std::string& name) const {
  return base::findBy(humans, &Human::name, name);
}

const Human* Scenario::humanById(int id) const {
  const auto usual = static_cast<std::size_t>(id) - 1;
  if (id >= 1 && usual < humans.size() && humans[usual].id == id && humans[usual].listed) {
    return &humans[usual];
  }
  const Human* const listed =
      base::findIf(humans, [id](const Human& human) { return human.id == id && human.listed; });
  return listed != nullptr ? listed : base::findBy(humans, &Human::id, id);
}

int Scenario::nextKey() const {
  int largest = 0;
  forEachList(*this, [&largest](base::EntityKind /*kind*/, const auto& all) {
    for (const auto& entity : all) {
      largest = std::max(largest, entity.key.key);
    }
  });
  return largest + 1;
}

template <class T>
auto operator==(const T& a, const T& b) -> decltype(a.unknown == b.unknown) {
  return haveSameKeys(a, b) && restOf(a) == restOf(b) && a.unknown == b.unknown;
}
bool operator==(const ScenarioSettings& a, const ScenarioSettings& b) {
  return haveSameKeys(a, b) && a.desktop == b.desktop;
}
template bool operator==(const GlobalGoal&, const GlobalGoal&);
template bool operator==(const Behavior&, const Behavior&);
template bool operator==(const PersonExtension&, const PersonExtension&);
template bool operator==(const Human&, const Human&);
template bool operator==(const LidarSettings&, const LidarSettings&);
template bool operator==(const DetectorSettings&, const DetectorSettings&);
template bool operator==(const OdometrySettings&, const OdometrySettings&);
template bool operator==(const LocalizationSettings&, const LocalizationSettings&);
template bool operator==(const BatterySettings&, const BatterySettings&);
template bool operator==(const Robot&, const Robot&);
template bool operator==(const Obstacle&, const Obstacle&);
template bool operator==(const Door&, const Door&);
template bool operator==(const Area&, const Area&);
template bool operator==(const Dock&, const Dock&);
template bool operator==(const VariationSettings&, const VariationSettings&);
template bool operator==(const MetricsSettings&, const MetricsSettings&);
template bool operator==(const ScenarioCard&, const ScenarioCard&);
template bool operator==(const DesktopSettings&, const DesktopSettings&);
template bool operator==(const Scenario&, const Scenario&);

}  // namespace sim2d
