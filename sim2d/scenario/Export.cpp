#include "sim2d/scenario/Export.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {

namespace {

/// The names of the first listed objects, and the number of the others.
template <class T>
std::string namesOf(const std::vector<T>& list) {
  constexpr std::size_t kMaxNamed = 4;
  std::vector<std::string> names;
  forEachListed(list, [&](const T& each) { names.push_back(each.name); });
  const std::size_t more = std::max(names.size(), kMaxNamed) - kMaxNamed;
  names.resize(names.size() - more);
  return base::join(names, ", ") + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

/// The keys of one agent that only hunavsim reads and that differ from their default.
std::string extensionKeysOf(const Human& human) {
  std::vector<std::string> keys;
  for (const Field<PersonExtension>& field : fieldsOf<PersonExtension>()) {
    const ParameterValue value = field.value(human.ours);
    if (value != ParameterValue() && value != field.spec.fallback) {
      keys.push_back(field.spec.key);
    }
  }
  return base::join(keys, ", ");
}

/// Maps each name to a safe and unique one.
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

/// Converts a scenario step by step until the wrapper accepts it.
class Exporter {
 public:
  Exporter(const Scenario& scenario, const TargetInfo& target, const ExportOptions& options)
      : options_(options), target_(target) {
    result_.scenario = scenario;
  }

  ExportedScenario run() {
    scenario().yamlBaseName = options_.baseName;
    placeFiles();
    if (!isNative()) {
      reportLosses();
      rename();
      renumberPeople();
      closeGoalNumberGaps();
      addMissingGoals();
      for (Human& human : scenario().humans) {
        complete(human);
      }
      scenario().simulator = target_.title;
      scenario().publishPeople = scenario().publishPeople.value_or(true);
      checkWorld();
    } else {
      keepNumbers();
    }
    if (isDialectB()) {
      numberGoalsForDialectB();
    }
    result_.text =
        isDialectB() ? writeScenarioB(scenario(), result_.report) : writeScenario(scenario());
    result_.startCommand = target_.startCommand(scenario());
    return std::move(result_);
  }

 private:
  Scenario& scenario() { return result_.scenario; }
  bool isNative() const { return target_.target == ExportTarget::Native; }
  bool isDialectB() const { return options_.dialect.value_or(target_.dialect) == Dialect::B; }

  void numberGoalsForDialectB() {
    const GoalNumbers counted = dialectBGoalNumbers(scenario());
    if (!isNative()) {
      reportDialectBLimits();
    }
    renumberGoals(scenario(), counted);
    result_.goals = composed(result_.goals, counted);
  }

  /// Reports what HuNavSim 1.5 does not read, with the user's goal numbers.
  void reportDialectBLimits() {
    std::set<int> apart;
    for (const GlobalGoal& goal : unusedGoals(scenario())) {
      apart.insert(goal.id);
    }
    std::vector<std::string> numbers;
    for (const auto& [old, now] : result_.goals) {
      if (apart.count(now) != 0) {
        numbers.push_back(std::to_string(old));
      }
    }
    if (!numbers.empty()) {
      note(base::warning("export.goals-apart", {base::join(numbers, ", ")}));
    }
    if (std::any_of(scenario().humans.begin(), scenario().humans.end(),
                    [](const Human& human) { return human.listed; })) {
      note(base::warning("export.trees-not-read"));
    }
  }

  void note(base::Diagnostic said, EntityId entity = {}) {
    said.entity = entity;
    result_.report.push_back(std::move(said));
  }
  void note(const Human& human, base::Diagnostic said) {
    note(base::withContext(human.name, std::move(said)), human.key);
  }
  void noteChange(EntityId entity, const char* code, base::ProblemValues values) {
    note(base::problem(base::Severity::Info, code, std::move(values)), entity);
  }

  /// Reports what the target cannot express, one line per kind of object.
  void reportLosses() {
    forEachEntityList(scenario(), [this](const char* key, base::EntityKind, const auto& list) {
      if (const std::string names = namesOf(list); !names.empty()) {
        note(base::warning("export.stays-here", {key, names}));
      }
    });
    for (const Human& human : scenario().humans) {
      const std::string keys = extensionKeysOf(human);
      if (human.listed && !keys.empty()) {
        note(human, base::warning("export.keys-unknown", {keys}));
      }
    }
    const DesktopSettings& desktop = scenario().desktop;
    if (!desktop.wrapX.empty()) {
      note(base::warning("export.no-ring"));
    }
    if (desktop.model && *desktop.model != "sfm" && *desktop.model != "sfm-hunav2") {
      note(base::warning("export.own-forces", {*desktop.model}));
    }
  }

  /// Fills the keys that the wrapper requires with the effective values; keeps skins in range.
  void complete(Human& human) {
    const ResolvedHuman counts =
        resolveHuman(scenario(), human, scenario().desktop.seed.value_or(1));
    fillFields(human, counts, {"group_id", "max_vel", "radius", "goal_radius", "cyclic_goals"});
    human.hasInitPose = true;
    human.initZ = target_.startHeight;
    const int largest = largestSkin(target_.title);
    const int skin = human.skin.value_or(0);
    human.skin = skin;
    if (skin < 0 || skin > largest) {
      human.skin = std::max(0, skin) % (largest + 1);
      note(human, base::problem(base::Severity::Info, "export.skin-changed",
                                {skin, *human.skin, target_.title, largest}));
    }
    Behavior& behavior = human.behavior;
    behavior.type = counts.behavior;
    behavior.configuration = counts.configuration;
    fillFields(behavior, counts, factorKeys());
    if (reactsToRobot(counts.behavior)) {
      fillFields(behavior, counts, {"dist", "duration", "once", "vel"});
    }
    if (target_.target == ExportTarget::Isaac && counts.configuration == Configuration::Custom) {
      checkFactor(human, "goal_force_factor", *behavior.goalForceFactor, {5.0, 10.0});
      checkFactor(human, "obstacle_force_factor", *behavior.obstacleForceFactor, {0.5, 5.0});
      checkFactor(human, "social_force_factor", *behavior.socialForceFactor, {5.0, 20.0});
    }
  }

  void checkFactor(const Human& human, const char* key, double value, base::Range range) {
    if (!range.contains(value)) {
      note(human, base::warning("export.factor-out-of-range", {key, value, range.low, range.high}));
    }
  }

  /// Map and trees are exported to where they are searched for, so their keys are removed.
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
      const std::string& name = names.at(human.name);
      if (name != human.name) {
        noteChange(human.key, "export.renamed", {human.name, name});
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
        note(human,
             base::problem(base::Severity::Info, "export.person-renumbered", {human.id, next}));
        human.id = next;
      }
      ++next;
    }
  }

  void closeGoalNumberGaps() {
    result_.goals = contiguousGoalNumbers(scenario());
    for (const GlobalGoal& goal : scenario().goals) {
      const int number = result_.goals.at(goal.id);
      if (goal.id != number && !isDialectB()) {
        noteChange(goal.key, "export.goal-renumbered", {goal.id, number});
      }
    }
    renumberGoals(scenario(), result_.goals);
  }

  void keepNumbers() {
    for (const Human& human : scenario().humans) {
      result_.people[human.id] = human.id;
    }
    for (const GlobalGoal& goal : scenario().goals) {
      result_.goals[goal.id] = goal.id;
    }
  }

  /// The loader fails for an agent without goals: adds a goal at its start.
  void addMissingGoals() {
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
    scenario().map = map;  // without folder and extension
    const std::vector<std::string>& worlds = target_.worlds;
    if (std::find(worlds.begin(), worlds.end(), map) == worlds.end()) {
      note(target_.worldOfMap(map));
    }
    const bool isNamed = std::any_of(worlds.begin(), worlds.end(), [&](const std::string& world) {
      return base::toLower(options_.baseName).find(world) != std::string::npos;
    });
    if (target_.target == ExportTarget::Isaac && !isNamed) {
      note(base::warning("export.isaac-world"));
    }
  }

  const ExportOptions& options_;
  const TargetInfo& target_;
  ExportedScenario result_;
};

constexpr const char* kIsaacPlane = "empty_world";

TargetInfo wrapper(ExportTarget target, const std::array<std::string, 4>& words, Dialect dialect,
                   double startHeight, std::vector<std::string> worlds) {
  const auto& [name, title, package, launch] = words;
  return {target, name, title, package, launch, dialect, startHeight, std::move(worlds)};
}

}  // namespace

ExportedScenario exportScenario(const Scenario& scenario, const TargetInfo& target,
                                const ExportOptions& options) {
  return Exporter(scenario, target, options).run();
}

std::string safeName(const std::string& name) {
  std::string safe;
  for (const char letter : name) {
    const bool isTail = (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U;  // in UTF-8
    if (base::isLetter(letter) || base::isDigit(letter) || letter == '_') {
      safe += letter;
    } else if (!isTail) {
      safe += '_';
    }
  }
  return isEntityName(safe) ? safe : "agent_" + safe;
}

GoalNumbers contiguousGoalNumbers(const Scenario& scenario) {
  GoalNumbers numbers;
  for (const GlobalGoal& goal : scenario.goals) {
    numbers[goal.id] = 0;
  }
  int next = 1;
  for (auto& [old, now] : numbers) {
    now = next++;
  }
  return numbers;
}

GoalNumbers dialectBGoalNumbers(const Scenario& scenario) {
  GoalNumbers numbers;
  int next = 1;
  for (const GlobalGoal& goal : unusedGoals(scenario)) {
    numbers.emplace(goal.id, next++);
  }
  for (const bool listed : {true, false}) {  // in file order
    for (const Human& human : scenario.humans) {
      for (const int goal : human.listed == listed ? human.goals : std::vector<int>()) {
        if (scenario.goal(goal) != nullptr) {
          numbers.emplace(goal, next++);  // counts also for a goal that already has a number
        }
      }
    }
  }
  return numbers;
}

void renumberGoals(Scenario& scenario, const GoalNumbers& numbers) {
  const auto renumber = [&numbers](int& goal) {
    const auto found = numbers.find(goal);
    goal = found == numbers.end() ? goal : found->second;
  };
  for (GlobalGoal& goal : scenario.goals) {
    renumber(goal.id);
  }
  std::stable_sort(scenario.goals.begin(), scenario.goals.end(),
                   [](const GlobalGoal& a, const GlobalGoal& b) { return a.id < b.id; });
  for (Human& human : scenario.humans) {
    std::for_each(human.goals.begin(), human.goals.end(), renumber);
  }
  for (Robot& robot : scenario.robots) {
    std::for_each(robot.goal.goals.begin(), robot.goal.goals.end(), renumber);
  }
}

GoalNumbers composed(const GoalNumbers& first, const GoalNumbers& second) {
  GoalNumbers numbers = first;
  for (auto& [old, now] : numbers) {
    const auto found = second.find(now);
    now = found == second.end() ? now : found->second;
  }
  return numbers;
}

const std::vector<TargetInfo>& exportTargets() {
  static const std::vector<TargetInfo> kTargets = {
      wrapper(ExportTarget::GazeboClassic,
              {"gazebo-classic", "Gazebo Classic", "hunav_gazebo_wrapper", "simulation.launch.py"},
              Dialect::C, 1.25, {"cafe", "house", "warehouse"}),
      wrapper(ExportTarget::GazeboFortress,
              {"gazebo-fortress", "Gazebo Fortress", "hunav_gazebo_fortress_wrapper",
               "cafe_fortress_test.launch.py"},
              Dialect::B, 0.03, {"cafe"}),
      wrapper(ExportTarget::Isaac, {"isaac", "Isaac Sim", "hunav_isaac_wrapper", ""}, Dialect::C,
              0.0, {"warehouse", "hospital", "office", kIsaacPlane}),
      wrapper(ExportTarget::Webots,
              {"webots", "Webots", "hunav_webots_wrapper", "hunavsim_webots.launch.py"}, Dialect::B,
              0.01, {"factory", "hall", "office"}),
      {ExportTarget::Native, "native", "HuNavSim 2.0", "", "", Dialect::C, std::nullopt, {}}};
  return kTargets;
}

const TargetInfo* exportTarget(const std::string& name) {
  return base::findBy(exportTargets(), &TargetInfo::name, name);
}

std::string TargetInfo::startCommand(const Scenario& scenario) const {
  const std::string map = mapBaseName(scenario.map.value_or(""));
  const std::string file = scenario.yamlBaseName.value_or("") + ".yaml";
  if (target == ExportTarget::Isaac) {
    return "ros2 run " + package + " hunav_isaac_launcher --config " + base::shellWord(file) +
           " --world " + (hasWorld(map) ? map : std::string(kIsaacPlane)) + " --batch";
  }
  const bool hasChoice = !map.empty() && worlds.size() > 1;  // else its default world
  const std::string world = hasChoice ? " " + base::shellWord("environment_name:=" + map) : "";
  return launch.empty() ? std::string()
                        : "ros2 launch " + package + " " + launch + world + " " +
                              base::shellWord("configuration_file:=" + file) + robotStart(scenario);
}

bool TargetInfo::hasWorld(const std::string& map) const {
  return std::find(worlds.begin(), worlds.end(), map) != worlds.end();
}

/// Only the Gazebo Classic launch file takes the robot's start.
std::string TargetInfo::robotStart(const Scenario& scenario) const {
  const Robot* const robot = base::findBy(scenario.robots, &Robot::listed, true);
  if (target != ExportTarget::GazeboClassic || robot == nullptr) {
    return {};
  }
  const base::Pose2& start = robot->start;
  return " gzpose_x:=" + base::formatDecimals(start.position.x(), 3) +
         " gzpose_y:=" + base::formatDecimals(start.position.y(), 3) +
         " gzpose_Y:=" + base::formatDecimals(start.heading, 3);
}

base::Diagnostic TargetInfo::worldOfMap(const std::string& map) const {
  if (target == ExportTarget::GazeboFortress) {
    return base::warning("export.fixed-world", {title, worlds.front(), map});
  }
  return base::warning("export.world-needed", {map, package, base::join(worlds, ", ")});
}

base::Diagnostic TargetInfo::worldWithoutMap() const {
  if (target == ExportTarget::Isaac) {
    return base::warning("export.no-map", {title, kIsaacPlane});
  }
  return worlds.size() == 1
             ? base::warning("export.no-map", {title, worlds.front()})
             : base::warning("export.no-map-other-worlds",
                             {title, worlds.front(), worlds[1], base::join(worlds, ", ")});
}

std::optional<std::string> suggestedSimulator(const Scenario& scenario) {
  for (const Human& human : scenario.humans) {
    for (const TargetInfo& target : exportTargets()) {
      if (human.initZ && human.initZ == target.startHeight) {
        return target.title;
      }
    }
  }
  return std::nullopt;
}

}  // namespace sim2d
