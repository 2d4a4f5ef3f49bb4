#include "sim2d/scenario/Export.h"

#include <algorithm>
#include <set>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ExportParts.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

namespace {

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
      addExportLosses(scenario(), report_);
      rename();
      renumberPeople();
      renumberGoals();
      giveGoals();
      for (Human& human : scenario().humans) {
        completeExported(scenario(), human, target_, report_);
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
      note(worldWithoutMap(target_));
      return;
    }
    if (scenario().map != map) {
      scenario().map = map;  // without folder and extension
    }
    const std::vector<std::string>& worlds = target_.worlds;
    if (std::find(worlds.begin(), worlds.end(), map) == worlds.end()) {
      note(worldOfMap(map, target_));
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
    result_.startCommand = exportStartCommand(scenario(), target_);
  }

  const ExportOptions& options_;
  const TargetInfo& target_;
  ExportedScenario result_;
  base::Diagnostics report_;
};

}  // namespace

const std::vector<TargetInfo>& exportTargets() {
  static const std::vector<TargetInfo> kTargets = {
      {ExportTarget::GazeboClassic,
       "gazebo-classic",
       "Gazebo Classic",
       "Gazebo Classic",
       "hunav_gazebo_wrapper",
       Dialect::C,
       1.25,
       {"cafe", "house", "warehouse"}},
      {ExportTarget::GazeboFortress,
       "gazebo-fortress",
       "Gazebo Fortress",
       "Gazebo Fortress",
       "hunav_gazebo_fortress_wrapper",
       Dialect::B,
       0.03,
       {"cafe"}},
      {ExportTarget::Isaac,
       "isaac",
       "Isaac Sim",
       "Isaac Sim",
       "hunav_isaac_wrapper",
       Dialect::C,
       0.0,
       {"warehouse", "hospital", "office", "empty_world"}},
      {ExportTarget::Webots,
       "webots",
       "Webots",
       "Webots",
       "hunav_webots_wrapper",
       Dialect::B,
       0.01,
       {"factory", "hall", "office"}},
      {ExportTarget::Native, "native", "HuNavSim 2.0", "", "", Dialect::C, std::nullopt, {}}};
  return kTargets;
}

const TargetInfo* exportTarget(const std::string& name) {
  const std::vector<TargetInfo>& all = exportTargets();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const TargetInfo& target) { return target.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<std::string> suggestedSimulator(const Scenario& scenario) {
  for (const Human& human : scenario.humans) {
    for (const TargetInfo& target : exportTargets()) {
      if (human.initZ && human.initZ == target.startHeight) {
        return target.simulator;
      }
    }
  }
  return std::nullopt;
}

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
