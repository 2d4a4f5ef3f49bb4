#include <algorithm>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

constexpr double kLargestId = 2147483647.0;
constexpr double kShortestRing = 1.0;  // [m]

void readWrap(YamlMap& view, DesktopSettings& to) {
  to.wrapX = view.numbers("wrap_x", base::kWithinReach);
  if (!to.wrapX.empty() && (to.wrapX.size() != 2 || to.wrapX[1] - to.wrapX[0] < kShortestRing)) {
    view.error("wrap_x", "scenario.bad-wrap");
    to.wrapX.clear();
  }
}

void readGroups(YamlMap& view, DesktopSettings& to) {
  YamlMap groups = view.map("groups");
  std::set<long long> ids;  // 3 and 03 are one group
  for (const YamlNode& item : groups.node().items) {
    const auto id = base::parseInt(item.key);
    const auto name = groups.text(item.key);
    if (!id || *id < 0 || static_cast<double>(*id) > kLargestId) {
      groups.error(item.key, "scenario.group-no-number");
    } else if (!ids.insert(*id).second) {
      groups.error(item.key, "scenario.group-twice", {*id});
    } else if (name) {
      to.groups.emplace_back(static_cast<int>(*id), *name);
    }
  }
}

void writeGroups(YamlNode& tree, const DesktopSettings& desktop) {
  for (const auto& group : desktop.groups) {
    setChild(tree.child("groups"), std::to_string(group.first), stringNode(group.second));
  }
}

void readModelParameters(YamlMap& view, DesktopSettings& to) {
  YamlMap models = view.map("model_parameters");
  for (const YamlNode& item : models.node().items) {
    ParameterTexts parameters = readParameters(models, item.key);
    if (!parameters.empty()) {
      to.modelParameters.emplace_back(item.key, std::move(parameters));
    }
  }
}

void writeModelParameters(YamlNode& tree, const DesktopSettings& desktop) {
  for (const auto& [model, parameters] : desktop.modelParameters) {
    writeParameters(tree.child("model_parameters"), model, parameters);
  }
}

/// "goal", "time 5.0", "event contact": one of `words`, or one of these two with its argument.
std::optional<std::string> readMoment(YamlMap& view, const std::string& key,
                                      const std::vector<std::string>& words) {
  const auto written = view.text(key);
  if (!written) {
    return std::nullopt;
  }
  const std::string text = base::trimmed(*written);
  const std::size_t space = text.find(' ');
  const std::string argument =
      space == std::string::npos ? std::string() : base::trimmed(text.substr(space + 1));
  const std::string first = text.substr(0, space);
  const bool simple =
      argument.empty() && std::find(words.begin(), words.end(), first) != words.end();
  const double time = base::parseDouble(argument).value_or(-1.0);
  const bool timed = first == "time" && time >= 0.0 && time < 1e9;
  const bool event = first == "event" && !argument.empty();
  if (simple || event || timed) {
    return text;
  }
  view.error(key, "scenario.unknown-moment", {*written, base::join(words, ", ")});
  return std::nullopt;
}

FieldOf<MetricsSettings> moment(const std::string& key,
                                std::optional<std::string> MetricsSettings::*member,
                                const std::vector<std::string>& words, std::string help,
                                std::string label) {
  return field(key, member, std::move(help), {std::move(label)})
      .orElse(words.front())
      .with(&Field<MetricsSettings>::read, [key, member, words](YamlMap& view, auto& to) {
        to.*member = readMoment(view, key, words);
      });
}

void readThresholds(YamlMap& view, MetricsSettings& to) {
  YamlMap parameters = view.map("parameters");
  for (const YamlNode& item : parameters.node().items) {
    if (const auto value = parameters.number(item.key, base::kFactor)) {
      to.parameters.emplace_back(item.key, *value);
    }
  }
}

void writeThresholds(YamlNode& tree, const MetricsSettings& metrics) {
  for (const auto& parameter : metrics.parameters) {
    setChild(tree.child("parameters"), parameter.first, decimals(parameter.second));
  }
}

}  // namespace

const std::vector<std::string>& routeWords() {
  static const std::vector<std::string> kWords = {"planned", "direct"};
  return kWords;
}

Fields<ScenarioSettings> scenarioFields() {
  return {field("yaml_base_name", &ScenarioSettings::yamlBaseName,
                "The file's name; trees are found by it"),
          field("simulator", &ScenarioSettings::simulator,
                "The simulator that HuNavSim runs the file in", {"Simulator"}),
          field("map", &ScenarioSettings::map, "Name of the map, no folder, no extension",
                {"Map name"}),
          field("publish_people", &ScenarioSettings::publishPeople, "Publish people as ROS topics",
                {"ROS topics"})
              .orElse(true)};
}

Fields<DesktopSettings> settingsFields() {
  using Settings = DesktopSettings;
  return {
      field("map_file", &Settings::mapFile,
            "Relative to the scenario, `none` is the open plane; absent: searched", {"Map file"}),
      field("map_rule", &Settings::mapRule, "Which nav2 decides how grey pixels are read",
            {"Map rule"})
          .words({"humble", "main"})
          .orElse(std::string("humble")),
      field("seed", &Settings::seed, "The same seed gives the same run", {"Seed", 0, 1.0}, {},
            base::kNotNegative)
          .orElse(1),
      field("duration", &Settings::duration,
            "Length of a run; absent: until the robot has arrived plus 1 s, at most 120 s",
            {"Duration", 1, 5.0}, "s", {0.0, base::kTime.high, true}),
      field("stop_on_collision", &Settings::stopOnCollision,
            "What a robot must touch on its way for the run to end: `any` is people, robots, walls",
            {"End on contact"})
          .words({"none", "people", "any"})
          .orElse(StopOnCollision::None),
      field("stuck_after", &Settings::stuckAfter,
            "A robot that has come no nearer for so long is stuck, and ends the run when no other "
            "gets on; 0 is never",
            {"Stuck after", 1, 5.0}, "s", base::kTime)
          .orElse(0.0),
      field("dt", &Settings::dt, "Time step", {"Time step", 3, 0.005}, "s", {0.001, 0.1})
          .orElse(0.05),
      field("record_every", &Settings::recordEvery, "Steps from one recorded sample to the next",
            {"Record every", 0, 1.0}, {}, {1.0, kLargestId})
          .orElse(1),
      field("model", &Settings::model, "How people move among others, see `list models`", {"Model"})
          .orElse(ResolvedHuman().model),
      FieldOf<Settings>("model_parameters",
                        "Of models, below the name of each: see `list models --format json`")
          .madeBy(readModelParameters, writeModelParameters, &Settings::modelParameters),
      field("route", &Settings::route, "Ways round walls, or straight on as the original",
            {"Routes"})
          .words(routeWords())
          .orElse(Route::Planned),
      field("obstacle_points", &Settings::obstaclePoints,
            "People feel nearest points of walls, or rays as of a laser", {"Feel walls by"})
          .words({"boundary", "rays"})
          .orElse(ObstaclePoints::Boundary),
      field("loop_trees", &Settings::loopTrees, "A tree that has ended starts again", {"Trees"})
          .orElse(true),
      field("wrap_x", &Settings::wrapX,
            "A corridor that closes on itself: who passes the second x comes in at the first",
            {"Corridor"}, "m", base::kWithinReach)
          .with(&Field<Settings>::read, readWrap),
      FieldOf<Settings>("groups", "Names of groups by their numbers")
          .madeBy(readGroups, writeGroups, &Settings::groups),
      FieldOf<Settings>("variation", "How people differ from seed to seed")
          .madeBy(readVariation, writeVariation, &Settings::variation)};
}

Fields<MetricsSettings> metricsFields() {
  using Settings = MetricsSettings;
  return {
      moment("from", &Settings::from, {"begin", "goal", "motion"},
             "begin, goal, motion, time 5.0 or event contact", "From"),
      moment("until", &Settings::until, {"end", "arrival"},
             "end, arrival, time 20.0 or event contact", "Until"),
      field("frequency", &Settings::frequency, "0 takes every recorded sample",
            {"Frequency", 1, 1.0}, "Hz", base::kRate)
          .orElse(0.0),
      field("tag", &Settings::tag, "Of the experiment, in the results", {"Tag"})
          .orElse(std::string("exp_1")),
      field("run_id", &Settings::runId, "Number of the run, in the results", {"Run number", 0, 1.0})
          .orElse(0),
      field("file", &Settings::file,
            "Which metrics are measured; relative to the scenario; absent: all", {"Metrics file"}),
      FieldOf<Settings>("parameters", "Thresholds of metrics: name and number of each",
                        {"Thresholds"})
          .madeBy(readThresholds, writeThresholds, &Settings::parameters)};
}

}  // namespace sim2d
