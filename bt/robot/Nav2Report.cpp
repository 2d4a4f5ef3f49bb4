#include "bt/robot/Nav2Report.h"

#include <cmath>
#include <string>
#include <variant>

#include <nlohmann/json.hpp>

#include "sim2d/base/Problems.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"

namespace bt {
namespace {

using Json = nlohmann::ordered_json;
using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2

/// Commits of github.com/ros-navigation/navigation2 from which the formulas are taken. Lyrical uses
/// those of main.
const char* commitOf(Distro distro) {
  static constexpr const char* kCommits[] = {"3c3db59", "f4108e5", "71a1d84", "a3a9704", "a3a9704"};
  return kCommits[static_cast<std::size_t>(distro)];
}

/// Requested and actual rate [Hz].
Json rate(double wanted, double dt) {
  return {{"wanted", wanted}, {"got", std::fmin(wanted, 1.0 / dt)}};
}

Json keysJson(const ParameterNotes& notes) {
  Json keys = Json::array();
  for (const KeyUsage& key : notes.keys) {
    Json json = {{"key", key.path}, {"value", key.value}, {"use", keyUseName(key.use)}};
    if (!key.why.empty()) {
      json["why"] = key.why;
    }
    keys.push_back(std::move(json));
  }
  return keys;
}

Json defaultsJson(const ParameterNotes& notes) {
  Json defaults = Json::object();
  for (const DefaultedKey& each : notes.defaults) {
    defaults[each.path] = each.value;
  }
  return defaults;
}

Json pluginsJson(const Nav2Parameters& parameters) {
  Json plugins = Json::object();
  for (const KeyUsage& key : parameters.notes.keys) {
    const std::string end = ".plugin";
    const bool isPlugin = key.path.size() > end.size() &&
                          key.path.compare(key.path.size() - end.size(), end.size(), end) == 0;
    const bool isOurs = key.path.find('/') == std::string::npos;  // not of another robot
    if (isPlugin && isOurs && key.use != KeyUse::Unknown) {
      plugins[key.path.substr(0, key.path.size() - end.size())] = key.value;
    }
  }
  return plugins;
}

/// Layers that differ from their Nav2 counterparts.
Json replacedJson(const Nav2Parameters& parameters) {
  Json replaced = Json::array();
  for (const auto& [node, costmap] : {std::pair("local_costmap", &parameters.localCostmap),
                                      std::pair("global_costmap", &parameters.globalCostmap)}) {
    for (const CostmapPlugin& plugin : costmap->plugins) {
      if (std::holds_alternative<VoxelLayerParameters>(plugin.parameters)) {
        replaced.push_back(
            {{"layer", std::string(node) + "." + plugin.name},
             {"is", "an obstacle layer whose rays end two cells before the obstacle"}});
      }
    }
  }
  return replaced;
}

/// Replaced, omitted and default parts of files and tree, with position and replacement.
Json substitutionsJson(const base::Diagnostics& problems) {
  Json substitutions = Json::array();
  for (const base::Diagnostic& problem : problems) {
    const base::ProblemText* const text = base::problemText(problem.code);
    if (text == nullptr || !text->isSubstitution) {
      continue;
    }
    Json json = {{"kind", std::string(problem.code)},
                 {"file", problem.file},
                 {"line", problem.line},
                 {"column", problem.column}};
    for (const auto& [hole, value] : problem.values) {
      json[std::string(hole)] = value;
    }
    json["message"] = problem.message;
    substitutions.push_back(std::move(json));
  }
  return substitutions;
}

/// Final states of binary filters and the number of their changes.
Json binaryJson(const Nav2Statistics& counts) {
  Json filters = Json::object();
  for (const auto& [name, filter] : counts.binaryFilters) {
    filters[name] = {{"state", filter.state}, {"changes", filter.changes}};
  }
  return filters;
}

Json ratesJson(const Nav2Parameters& parameters, double dt) {
  return {{"controller", rate(controllerValue(parameters, "controller_frequency", 20.0), dt)},
          {"behaviors", rate(parameters.behaviors.server.cycleFrequency, dt)},
          {"velocity_smoother", rate(parameters.velocitySmoother.smoothingFrequency, dt)},
          {"local_costmap", rate(parameters.localCostmap.parameters.updateFrequency, dt)},
          {"global_costmap", rate(parameters.globalCostmap.parameters.updateFrequency, dt)},
          {"tree", rate(1.0 / dt, dt)}};
}

}  // namespace

std::string nav2Report(const Nav2Loaded& loaded, const Nav2Statistics& counts,
                       const Nav2Latencies& latencies, const sim2d::PlannerSetup& setup) {
  const Nav2Parameters& parameters = loaded.parameters;
  Json json;
  json["distro"] = distroName(parameters.distro);
  json["navigation2_commit"] = commitOf(parameters.distro);
  json["distro_guessed"] = parameters.isGuessed;
  json["distro_reasons"] = parameters.distroReasons;
  json["params"] = parameters.file;
  json["params_files"] = loaded.paramsFiles;
  json["params_overrides"] = loaded.overrides;
  json["tree"] = loaded.treeFile;
  json["plugins"] = pluginsJson(parameters);
  json["treated_as"] = replacedJson(parameters);
  json["substitutions"] = substitutionsJson(loaded.problems);
  json["binary_filters"] = binaryJson(counts);
  json["collision_monitor"] = parameters.collisionMonitor.has_value();
  json["frequencies"] = ratesJson(parameters, setup.dt);
  json["latency_steps"] = {
      {"scan", latencies.scan}, {"planner", latencies.planner}, {"command", latencies.command}};
  json["noise"] = {{"seed", setup.seed}, {"robot", setup.robotId}};
  json["counts"] = {{"replans", counts.replans},
                    {"plan_failures", counts.planFailures},
                    {"no_valid_control", counts.noValidControl},
                    {"progress_failures", counts.progressFailures},
                    {"tree_failures", counts.treeFailures},
                    {"recoveries", counts.recoveries},
                    {"costmap_clears", counts.clears},
                    {"commands_cut_by_the_robot", counts.limitedCommands}};
  json["plan_failure_reasons"] = Json(counts.planReasons);
  json["action_failure_reasons"] = Json(counts.actionReasons);
  if (!loaded.graph.file.empty()) {
    Json events = Json::array();
    for (const RouteEvent& event : counts.routeEvents) {
      events.push_back({{"time", event.time}, {"event", event.what}});
    }
    json["route"] = {{"graph", loaded.graph.file}, {"events", std::move(events)}};
  }
  json["keys"] = keysJson(parameters.notes);
  json["code_defaults"] = defaultsJson(parameters.notes);
  return json.dump();
}

}  // namespace bt
