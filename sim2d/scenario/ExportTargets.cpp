#include <algorithm>
#include <array>
#include <string_view>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Export.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {
namespace {

constexpr const char* kIsaacPlane = "empty_world";

TargetInfo wrapper(ExportTarget target, const std::array<std::string, 4>& words, Dialect dialect,
                   double startHeight, std::vector<std::string> worlds) {
  const auto& [name, title, package, launch] = words;
  return {target, name, title, package, launch, dialect, startHeight, std::move(worlds)};
}

}  // namespace

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
