#include "sim2d/scenario/Export.h"

#include <algorithm>
#include <set>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

namespace {

template <class T>
void setDefault(std::optional<T>& value, T otherwise) {
  if (!value) {
    value = otherwise;
  }
}

template <class T>
std::string namesOf(const std::vector<T>& list) {
  constexpr int kMostNamed = 4;
  std::string names;
  int count = 0;
  for (const T& value : list) {
    if (value.listed && ++count <= kMostNamed) {
      names += (names.empty() ? "" : ", ") + value.name;
    }
  }
  return count > kMostNamed ? names + " and " + std::to_string(count - kMostNamed) + " more"
                            : names;
}

void lose(base::Diagnostics& report, const std::string& what, const std::string& names) {
  if (!names.empty()) {
    report.push_back(base::warning("export.stays-here", {what, names}));
  }
}

/// The keys of one person that no other program reads.
std::string ownKeysOf(const Human& human) {
  const PersonExtension& ours = human.ours;
  std::string keys;
  const auto add = [&keys](bool isSet, const char* key) {
    if (isSet) {
      keys += (keys.empty() ? "" : ", ") + std::string(key);
    }
  };
  add(ours.startTime.value_or(0.0) > 0.0, "start_time");
  add(ours.kind.value_or(PersonKind::Adult) != PersonKind::Adult, "kind");
  add(ours.mass.has_value(), "mass");
  add(ours.model.has_value(), "model");
  add(ours.route.has_value(), "route");
  add(ours.atEnd.value_or(AtEnd::Stop) != AtEnd::Stop, "at_end");
  add(!ours.wait.empty(), "wait");
  return keys;
}

base::Diagnostic about(const Human& human, base::Diagnostic said) {
  said.entity = human.key;
  return base::within(human.name, std::move(said));
}

void checkFactor(const Human& human, const char* key, double value, double low, double high,
                 base::Diagnostics& report) {
  if (value < low || value > high) {
    report.push_back(
        about(human, base::warning("export.factor-out-of-range", {key, value, low, high})));
  }
}

void completeBehavior(Human& human, const ResolvedHuman& counts, bool allKeys) {
  Behavior& behavior = human.behavior;
  setDefault(behavior.type, BehaviorType::Regular);
  setDefault(behavior.configuration, Configuration::Default);
  setDefault(behavior.goalForceFactor, counts.goalFactor);
  setDefault(behavior.obstacleForceFactor, counts.obstacleFactor);
  setDefault(behavior.socialForceFactor, counts.socialFactor);
  setDefault(behavior.otherForceFactor, counts.otherFactor);
  if (allKeys) {
    setDefault(behavior.dist, counts.noticeDistance);
    setDefault(behavior.duration, counts.reactionDuration);
    setDefault(behavior.once, counts.reactionOnce);
    setDefault(behavior.vel, counts.reactionSpeed);
  }
}

/// What only we can express, one line per kind of thing.
void addLosses(const Scenario& scenario, base::Diagnostics& report) {
  lose(report, "the robot", namesOf(scenario.robots));
  lose(report, "what was drawn as obstacle", namesOf(scenario.obstacles));
  lose(report, "the door", namesOf(scenario.doors));
  lose(report, "the area", namesOf(scenario.areas));
  for (const Human& human : scenario.humans) {
    const std::string keys = ownKeysOf(human);
    if (human.listed && !keys.empty()) {
      report.push_back(about(human, base::warning("export.keys-unknown", {keys})));
    }
  }
  const DesktopSettings& desktop = scenario.desktop;
  if (!desktop.wrapX.empty()) {
    report.push_back(base::warning("export.no-ring"));
  }
  if (desktop.model && *desktop.model != "sfm" && *desktop.model != "sfm-hunav2") {
    report.push_back(base::warning("export.own-forces", {*desktop.model}));
  }
}

/// Fills the keys that the wrapper asks for with the values that count, and keeps skins in range.
void complete(const Scenario& scenario, Human& human, const TargetInfo& target,
              base::Diagnostics& report) {
  const ResolvedHuman counts = resolveHuman(scenario, human, scenario.desktop.seed.value_or(1));
  setDefault(human.groupId, -1);
  setDefault(human.maxVel, counts.desiredSpeed);
  setDefault(human.radius, counts.radius);
  setDefault(human.goalRadius, counts.goalRadius);
  setDefault(human.cyclicGoals, counts.cyclicGoals);
  setDefault(human.skin, 0);
  human.hasInitPose = true;
  human.initZ = target.startHeight;
  const int largest = largestSkin(target.simulator);
  if (*human.skin < 0 || *human.skin > largest) {
    const int skin = std::max(0, *human.skin) % (largest + 1);
    report.push_back(about(human, base::problem(base::Severity::Info, "export.skin-changed",
                                                {*human.skin, skin, target.title, largest})));
    human.skin = skin;
  }
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const bool reacts = type != BehaviorType::Regular && type != BehaviorType::Impassive;
  completeBehavior(human, counts, reacts);
  const bool ownFactors = human.behavior.configuration == Configuration::Custom;
  if (target.target == ExportTarget::Isaac && ownFactors) {
    checkFactor(human, "goal_force_factor", *human.behavior.goalForceFactor, 5.0, 10.0, report);
    checkFactor(human, "obstacle_force_factor", *human.behavior.obstacleForceFactor, 0.5, 5.0,
                report);
    checkFactor(human, "social_force_factor", *human.behavior.socialForceFactor, 5.0, 20.0, report);
  }
}

/// Old name -> one that is safe and free.
std::map<std::string, std::string> safeNames(const Scenario& scenario) {
  std::set<std::string> taken;
  for (const Human& human : scenario.humans) {
    if (human.name == safeName(human.name)) {
      taken.insert(human.name);
    }
  }
  std::map<std::string, std::string> names;
  for (const Human& human : scenario.humans) {
    std::string name = safeName(human.name);
    if (name != human.name) {
      const std::string stem = name;
      for (int number = 2; taken.count(name) != 0; ++number) {
        name = stem + "_" + std::to_string(number);
      }
      taken.insert(name);
    }
    names[human.name] = name;
  }
  return names;
}

/// Everything that makes a scenario acceptable to a wrapper, step by step.
class Exporter {
 public:
  Exporter(const Scenario& scenario, const ExportOptions& options, const TargetInfo& target)
      : options_(options), target_(target) {
    result_.scenario = scenario;
  }

  ExportedScenario run() {
    scenario().yamlBaseName = options_.baseName;
    placeFiles();
    if (target_.target != ExportTarget::Native) {
      addLosses(scenario(), report_);
      rename();
      renumberPeople();
      renumberGoals();
      giveGoals();
      for (Human& human : scenario().humans) {
        complete(scenario(), human, target_, report_);
      }
      scenario().simulator = target_.simulator;
      scenario().publishPeople = scenario().publishPeople.value_or(true);
      checkWorld();
    } else {
      keepNumbers();
    }
    write();
    result_.report = std::move(report_);
    return std::move(result_);
  }

 private:
  Scenario& scenario() { return result_.scenario; }
  Dialect dialect() const { return options_.dialect.value_or(target_.dialect); }

  void note(base::Diagnostic said, EntityId entity = {}) {
    said.entity = entity;
    report_.push_back(std::move(said));
  }

  /// Map and trees lie where the search finds them: their keys are not needed.
  void placeFiles() {
    if (!options_.mapName.empty()) {
      scenario().map = options_.mapName;
      scenario().desktop.mapFile.reset();
    }
    for (Human& human : scenario().humans) {
      human.ours.tree.reset();
    }
  }

  void rename() {
    const std::map<std::string, std::string> names = safeNames(scenario());
    for (Human& human : scenario().humans) {
      const std::string name = names.at(human.name);
      if (name != human.name) {
        note(base::problem(base::Severity::Info, "export.renamed", {human.name, name}), human.key);
        human.name = name;
      }
    }
    for (Area& area : scenario().areas) {
      const auto found = area.like ? names.find(*area.like) : names.end();
      if (found != names.end()) {
        area.like = found->second;
      }
    }
  }

  void renumberPeople() {
    int next = 1;
    for (Human& human : scenario().humans) {
      result_.people[human.id] = next;
      if (human.id != next) {
        note(base::within(human.name, base::problem(base::Severity::Info,
                                                    "export.person-renumbered", {human.id, next})),
             human.key);
        human.id = next;
      }
      ++next;
    }
  }

  void renumberGoals() {
    std::vector<GlobalGoal>& goals = scenario().goals;
    std::stable_sort(goals.begin(), goals.end(),
                     [](const GlobalGoal& a, const GlobalGoal& b) { return a.id < b.id; });
    int next = 1;
    for (GlobalGoal& goal : goals) {
      result_.goals[goal.id] = next;
      if (goal.id != next) {
        note(base::problem(base::Severity::Info, "export.goal-renumbered", {goal.id, next}),
             goal.key);
      }
      goal.id = next++;
    }
    const auto renumber = [this](std::vector<int>& list) {
      for (int& goal : list) {
        const auto found = result_.goals.find(goal);
        goal = found == result_.goals.end() ? goal : found->second;
      }
    };
    for (Human& human : scenario().humans) {
      renumber(human.goals);
    }
    for (Robot& robot : scenario().robots) {
      renumber(robot.goal.goals);
    }
  }

  void keepNumbers() {
    for (const Human& human : scenario().humans) {
      result_.people[human.id] = human.id;
    }
    for (const GlobalGoal& goal : scenario().goals) {
      result_.goals[goal.id] = goal.id;
    }
  }

  /// A person without goals makes the loader fail: one at the start keeps them there.
  void giveGoals() {
    for (Human& human : scenario().humans) {
      if (!human.listed || !human.goals.empty()) {
        continue;
      }
      GlobalGoal goal;
      goal.key = {base::EntityKind::Goal, scenario().nextKey()};
      goal.id = static_cast<int>(scenario().goals.size()) + 1;
      goal.position = human.initPose.position;
      human.goals = {goal.id};
      note(base::warning("export.goal-added", {human.name, goal.id}), human.key);
      scenario().goals.push_back(std::move(goal));
    }
  }

  void checkWorld() {
    const std::string map = mapBaseName(scenario().map.value_or(""));
    if (map.empty()) {
      note(target_.worldWithoutMap());
      return;
    }
    if (scenario().map != map) {
      scenario().map = map;  // without folder and extension
    }
    const std::vector<std::string>& worlds = target_.worlds;
    if (std::find(worlds.begin(), worlds.end(), map) == worlds.end()) {
      note(target_.worldOfMap(map));
    }
    const bool isNamed = std::any_of(worlds.begin(), worlds.end(), [&](const std::string& world) {
      return base::lowered(options_.baseName).find(world) != std::string::npos;
    });
    if (target_.target == ExportTarget::Isaac && !isNamed) {
      note(base::warning("export.isaac-world"));
    }
  }

  void write() {
    if (dialect() == Dialect::B) {
      result_.text = writeScenarioB(scenario(), report_);
    } else {
      result_.text = writeScenario(scenario());
    }
    result_.startCommand = target_.startCommand(scenario());
  }

  const ExportOptions& options_;
  const TargetInfo& target_;
  ExportedScenario result_;
  base::Diagnostics report_;
};
}  // namespace

ExportedScenario exportScenario(const Scenario& scenario, const ExportOptions& options) {
  const std::vector<TargetInfo>& all = exportTargets();
  const auto target = std::find_if(all.begin(), all.end(), [&](const TargetInfo& info) {
    return info.target == options.target;
  });
  return Exporter(scenario, options, *target).run();
}

std::string safeName(const std::string& name) {
  std::string safe;
  for (const char letter : name) {
    const bool isDigit = letter >= '0' && letter <= '9';
    const bool isLetter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    const bool isTail = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;  // inside UTF-8
    if (isLetter || isDigit || letter == '_') {
      safe += letter;
    } else if (!isTail) {
      safe += '_';
    }
  }
  const bool begins = !safe.empty() && (safe[0] < '0' || safe[0] > '9') && safe[0] != '_';
  return begins ? safe : "agent_" + safe;
}

}  // namespace sim2d
