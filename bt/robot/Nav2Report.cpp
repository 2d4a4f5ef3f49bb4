#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"
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
    constexpr std::string_view kEnd = ".plugin";
    const bool isPlugin = key.path.size() > kEnd.size() && base::endsWith(key.path, kEnd);
    const bool isOurs = key.path.find('/') == std::string::npos;  // not of another robot
    if (isPlugin && isOurs && key.use != KeyUse::Unknown) {
      plugins[key.path.substr(0, key.path.size() - kEnd.size())] = key.value;
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

namespace {

using base::Diagnostics;

/// Name and class of a controller in the file.
struct Named {
  std::string name, plugin;
};

class ConsistencyChecker {
 public:
  ConsistencyChecker(const Nav2Parameters& parameters, const sim2d::PlannerSetup* setup)
      : parameters_(parameters), setup_(setup) {}

  Diagnostics all() {
    for (const auto& [node, costmap] : {std::pair("local_costmap", &parameters_.localCostmap),
                                        std::pair("global_costmap", &parameters_.globalCostmap)}) {
      checkShape(node, costmap->parameters);
      checkBody(node, costmap->parameters);
    }
    for (const Named& controller : controllers()) {
      checkScaling(controller);
      checkSpeed(controller);
      checkLateral(controller);
      checkReach(controller);
      checkFootprint(controller);
      checkTolerance(controller);
    }
    checkRates();
    return std::move(found_);
  }

 private:
  /// Since Lyrical the keys of the actual controller may also be below `primary_controller` of a
  /// rotation shim.
  template <class T>
  T value(const std::string& key, T otherwise) const {
    T own = controllerValue(parameters_, key, otherwise);
    const std::size_t dot = key.find('.');
    if (parameters_.distro < Distro::Lyrical || dot == std::string::npos) {
      return own;
    }
    return controllerValue(parameters_,
                           key.substr(0, dot) + ".primary_controller" + key.substr(dot), own);
  }

  std::vector<Named> controllers() const {
    std::vector<Named> all;
    for (const std::string& name :
         value<std::vector<std::string>>("controller_plugins", {"FollowPath"})) {
      std::string plugin =
          controllerValue<std::string>(parameters_, name + ".plugin", "dwb_core::DWBLocalPlanner");
      if (plugin.find("RotationShim") != std::string::npos) {
        plugin = primaryOf(name);
      }
      all.push_back({name, normalizedPluginClass(plugin)});
    }
    return all;
  }
  /// The controller class behind a rotation shim; its keys are those of the shim.
  std::string primaryOf(const std::string& name) const {
    const bool isMain = parameters_.distro >= Distro::Lyrical;
    return controllerValue<std::string>(
        parameters_, name + (isMain ? ".primary_controller.plugin" : ".primary_controller"), "");
  }

  /// Adds a problem at the line of the key, otherwise of its plugin.
  void add(const std::string& path, const char* code, base::ProblemValues values,
           base::Severity severity = base::Severity::Warning) {
    base::Diagnostic problem = base::problem(severity, code, std::move(values), parameters_.file);
    const std::string plugin = path.substr(0, path.rfind('.')) + ".plugin";
    for (const std::string& place : {plugin, path}) {
      for (const KeyUsage& key : parameters_.notes.keys) {
        if (key.path == place && key.line > 0) {
          problem.line = key.line;
          problem.column = key.column;
          problem.file = key.file;
        }
      }
    }
    found_.push_back(std::move(problem));
  }
  bool isGiven(const std::string& path) const {
    return std::any_of(parameters_.notes.keys.begin(), parameters_.notes.keys.end(),
                       [&](const KeyUsage& key) { return key.path == path; });
  }

  void checkShape(const std::string& node, const CostmapParameters& costmap) {
    const bool hasFootprint = !costmap.footprint.empty() && costmap.footprint != "[]";
    if (hasFootprint && isGiven(node + ".robot_radius")) {
      add(node + ".robot_radius", "nav2.two-shapes", {});
    }
  }

  /// The simulator computes contacts with the robot's body; Nav2 avoids obstacles with the
  /// costmap's footprint.
  void checkBody(const std::string& node, const CostmapParameters& costmap) {
    constexpr double kAlike = 0.02;  // [m] tolerance
    const bool hasFootprint = !costmap.footprint.empty() && costmap.footprint != "[]";
    const std::string key = node + (hasFootprint ? ".footprint" : ".robot_radius");
    if (setup_ == nullptr || !isGiven(key)) {
      return;
    }
    double reach = costmap.robotRadius;
    if (hasFootprint) {
      const base::Result<Polygon> corners = readPolygon(costmap.footprint);
      if (!corners) {
        return;  // reported by the costmap
      }
      reach = circumscribedRadius(*corners);
    }
    const double body = sim2d::circumscribedRadius(setup_->body.footprint);
    if (std::abs(reach - body) > kAlike) {
      const auto shown = [](double length) { return std::round(1e3 * length) / 1e3; };
      add(key, "nav2.body-differs", {key, shown(reach), setup_->robot, shown(body)});
    }
  }

  const InflationLayerParameters* inflation() const {
    for (const CostmapPlugin& plugin : parameters_.localCostmap.plugins) {
      if (const auto* layer = std::get_if<InflationLayerParameters>(&plugin.parameters)) {
        return layer;
      }
      if (const auto* legacy = std::get_if<LegacyInflationLayerParameters>(&plugin.parameters)) {
        return legacy;
      }
    }
    return nullptr;
  }

  static bool isPursuit(const Named& controller) {
    return controller.plugin.find("RegulatedPurePursuit") != std::string::npos;
  }
  static bool isMppi(const Named& controller) {
    return controller.plugin.find("MPPI") != std::string::npos;
  }
  static bool isDwb(const Named& controller) {
    return controller.plugin.find("DWB") != std::string::npos;
  }

  void checkScaling(const Named& controller) {
    const std::string key = controller.name + ".inflation_cost_scaling_factor";
    const double scaling = value(key, 3.0);
    const InflationLayerParameters* const layer = inflation();
    const bool regulates =
        value(controller.name + ".use_cost_regulated_linear_velocity_scaling", true);
    if (isPursuit(controller) && regulates && layer != nullptr &&
        layer->costScalingFactor != scaling) {
      add("controller_server." + key, "nav2.scaling-differs",
          {controller.name, scaling, layer->costScalingFactor});
    }
  }

  /// Key and value of the controller's maximum speed [m/s].
  std::pair<std::string, double> topSpeed(const Named& controller) const {
    const auto pick = [&](const char* key, double usual) {
      return std::pair(controller.name + "." + key, value(controller.name + "." + key, usual));
    };
    if (isMppi(controller)) {
      return pick("vx_max", 0.5);
    }
    if (isDwb(controller)) {
      return pick("max_vel_x", 0.0);
    }
    if (isPursuit(controller)) {
      return parameters_.distro >= Distro::Lyrical &&
                     !isGiven("controller_server." + controller.name + ".desired_linear_vel")
                 ? pick("max_linear_vel", 0.5)
                 : pick("desired_linear_vel", 0.5);
    }
    const bool isGraceful = controller.plugin.find("Graceful") != std::string::npos;
    return isGraceful ? pick("v_linear_max", 0.5) : std::pair(std::string(), 0.0);
  }

  void checkSpeed(const Named& controller) {
    const auto [key, speed] = topSpeed(controller);
    const std::vector<double>& most = parameters_.velocitySmoother.maxVelocity;
    if (!most.empty() && speed > most.front() + 1e-9) {
      add("controller_server." + key, "nav2.faster-than",
          {key, speed, most.front(), "velocity_smoother (max_velocity)"});
    }
    if (setup_ != nullptr && speed > setup_->body.limits.maxVel + 1e-9) {
      add("controller_server." + key, "nav2.faster-than",
          {key, speed, setup_->body.limits.maxVel, "robot '" + setup_->robot + "' (max_vel)"});
    }
  }

  /// Key and value of a controller's maximum lateral speed [m/s]; 0: none.
  std::pair<std::string, double> lateralSpeed(const Named& controller) const {
    const std::string model = value<std::string>(controller.name + ".motion_model", "");
    const bool isOmni = isMppi(controller) && (model == "Omni" || model == "omni");
    const std::string key = controller.name + (isOmni ? ".vy_max" : ".max_vel_y");
    return {key, isOmni || isDwb(controller) ? value(key, isOmni ? 0.5 : 0.0) : 0.0};
  }

  void checkLateral(const Named& controller) {
    const auto [key, speed] = lateralSpeed(controller);
    if (setup_ != nullptr && speed > 0.0 &&
        setup_->body.kinematics != sim2d::Kinematics::Omnidirectional) {
      add("controller_server." + key, "nav2.not-sideways",
          {key, speed, setup_->robot, kinematicsName(setup_->body.kinematics)});
    }
  }

  /// Look-ahead distance [m] and the keys that define it.
  std::pair<double, std::string> reachOf(const Named& controller) const {
    const std::string& name = controller.name;
    const double speed = topSpeed(controller).second;
    if (isMppi(controller)) {
      return {speed * value(name + ".time_steps", 56) * value(name + ".model_dt", 0.05),
              "vx_max * time_steps * model_dt"};
    }
    if (isDwb(controller)) {
      return {speed * value(name + ".sim_time", 1.7), "max_vel_x * sim_time"};
    }
    if (isPursuit(controller)) {
      const bool isScaled = value(name + ".use_velocity_scaled_lookahead_dist", false);
      return isScaled
                 ? std::pair(value(name + ".max_lookahead_dist", 0.9),
                             std::string("max_lookahead_dist"))
                 : std::pair(value(name + ".lookahead_dist", 0.6), std::string("lookahead_dist"));
    }
    return {0.0, {}};
  }

  void checkReach(const Named& controller) {
    const CostmapParameters& local = parameters_.localCostmap.parameters;
    const double half = 0.5 * std::min(local.width, local.height);
    const auto [reach, what] = reachOf(controller);
    if (local.rollingWindow && reach > half + 1e-9) {
      add("local_costmap.width", "nav2.map-too-small", {half, controller.name, reach, what});
    }
  }

  /// MPPI critics that consider the footprint of a robot that only has a radius.
  void checkFootprint(const Named& controller) {
    const std::string& footprint = parameters_.localCostmap.parameters.footprint;
    if (!isMppi(controller) || !(footprint.empty() || footprint == "[]")) {
      return;
    }
    for (const std::string& critic :
         value<std::vector<std::string>>(controller.name + ".critics", {})) {
      const std::string key = controller.name + "." + critic + ".consider_footprint";
      if (value(key, false)) {
        add("controller_server." + key, "nav2.no-footprint", {key}, base::Severity::Error);
      }
    }
  }

  /// DWB's critic RotateToGoal only rotates near the goal, which must not end farther from it.
  void checkTolerance(const Named& controller) {
    const std::string key = controller.name + ".xy_goal_tolerance";
    const double near = value(key, 0.25), wanted = xyGoalTolerance(parameters_);
    const auto critics = value<std::vector<std::string>>(controller.name + ".critics", {});
    const bool rotates = std::any_of(critics.begin(), critics.end(), [](const std::string& critic) {
      return critic.find("RotateToGoal") != std::string::npos;
    });
    if (isDwb(controller) && rotates && near > wanted + 1e-9) {
      add("controller_server." + key, "nav2.rotates-too-far", {key, near, wanted});
    }
  }

  /// No server runs more than once per step.
  void checkRates() {
    if (setup_ == nullptr) {
      return;
    }
    const double most = 1.0 / setup_->dt;
    for (const auto& [key, rate] :
         {std::pair<std::string, double>("controller_server.controller_frequency",
                                         value("controller_frequency", 20.0)),
          {"behavior_server.cycle_frequency", parameters_.behaviors.server.cycleFrequency},
          {"velocity_smoother.smoothing_frequency",
           parameters_.velocitySmoother.smoothingFrequency}}) {
      if (rate > most + 1e-6) {
        add(key, "nav2.frequency-rounded", {key, rate, setup_->dt, most});
      }
    }
  }

  const Nav2Parameters& parameters_;
  const sim2d::PlannerSetup* setup_;
  Diagnostics found_;
};

}  // namespace

Diagnostics nav2Inconsistencies(const Nav2Parameters& parameters,
                                const sim2d::PlannerSetup* setup) {
  return ConsistencyChecker(parameters, setup).all();
}

Diagnostics nav2Hints(const Nav2Parameters& parameters) {
  Diagnostics remarks;
  std::vector<std::string> reasons = parameters.distroReasons;
  constexpr std::size_t kShown = 4;
  reasons.resize(std::min(reasons.size(), kShown));
  if (parameters.isGuessed) {
    remarks.push_back(base::problem(base::Severity::Info, "nav2.distro-guessed",
                                    {distroName(parameters.distro), base::join(reasons, "; ")},
                                    parameters.file));
  }
  std::map<std::pair<std::string, std::string>, std::vector<const KeyUsage*>> idle;
  for (const KeyUsage& key : parameters.notes.keys) {
    if (key.use == KeyUse::Ignored) {
      idle[{key.path.substr(0, key.path.find('.')), key.why}].push_back(&key);
    } else if (key.use == KeyUse::OtherDistro) {
      remarks.push_back(base::warning("nav2.other-distro",
                                      {key.path, key.why, distroTitle(parameters.distro)}, key.file,
                                      key.line, key.column));
    }
  }
  for (const auto& [group, keys] : idle) {
    std::vector<std::string> names;
    for (const KeyUsage* const key : keys) {
      names.push_back(key->path.substr(key->path.find('.') + 1));
    }
    const std::string count = std::to_string(names.size()) + (names.size() == 1 ? " key" : " keys");
    constexpr std::size_t kNamed = 6;
    const bool isLong = names.size() > kNamed;
    names.resize(std::min(names.size(), kNamed));
    remarks.push_back(base::problem(
        base::Severity::Info, "nav2.idle-keys",
        {group.first, count, base::join(names, ", ") + (isLong ? " …" : ""), group.second},
        keys.front()->file, keys.front()->line, keys.front()->column));
  }
  return remarks;
}

}  // namespace bt
