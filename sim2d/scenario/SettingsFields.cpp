#include <algorithm>
#include <map>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"
#include "sim2d/scenario/Variation.h"

namespace sim2d {
namespace {

constexpr double kLargestId = 2147483647.0;
constexpr double kShortestRing = 1.0;  // [m]

void readWrap(YamlMap& view, DesktopSettings& to) {
  to.wrapX = view.numbers("wrap_x", base::kCoordinateRange);
  if (!to.wrapX.empty() && (to.wrapX.size() != 2 || to.wrapX[1] - to.wrapX[0] < kShortestRing)) {
    view.error("wrap_x", "scenario.bad-wrap");
    to.wrapX.clear();
  }
}

void readGroups(YamlMap& view, DesktopSettings& to) {
  YamlMap groups = view.map("groups");
  std::set<long long> ids;  // 3 and 03 are the same group
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

/// "goal", "time 5.0", "event contact": one of `words`, or `time` or `event` with an argument.
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

FieldBuilder<MetricsSettings> moment(const std::string& key,
                                     std::optional<std::string> MetricsSettings::*member,
                                     const std::vector<std::string>& words, std::string help,
                                     std::string label) {
  return field(key, member, std::move(help), {std::move(label)})
      .defaultsTo(words.front())
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

/// Limit for offsets from the centre and for widths.
double widestOf(VariationQuantity quantity) {
  switch (quantity) {
    case VariationQuantity::StartTime:
      return base::kTime.high;
    case VariationQuantity::Start:
      return 1000.0;  // [m]
    case VariationQuantity::Heading:
      return base::kAngleWidth.high;
    case VariationQuantity::Speed:
    case VariationQuantity::ReactionTime:
      return 100.0;  // factor of the given value
    case VariationQuantity::FirstGoal:
      break;
  }
  return base::kMaxValue;
}

/// Splits "speed.sd" into map and key; no dot: the map is empty.
std::pair<std::string, std::string> partsOf(const std::string& key) {
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? std::pair(std::string(), key)
                                  : std::pair(key.substr(0, dot), key.substr(dot + 1));
}

/// The description with the key inside its map.
ParameterSpec innerSpec(const ParameterSpec& spec) {
  ParameterSpec inner = spec;
  inner.key = partsOf(spec.key).second;
  return inner;
}

template <class M>
FieldBuilder<VariationSettings> spreadField(VariationQuantity quantity, const char* key,
                                            M SpreadSettings::*member, std::string help,
                                            base::FormHints form, Range range) {
  const VariationInfo& facts = variationInfo(quantity);
  form.label = std::string(facts.label) + ": " + form.label;
  constexpr bool kIsNumber = std::is_same_v<M, std::optional<double>>;
  return FieldBuilder<VariationSettings>(std::string(facts.key) + "." + key, std::move(help),
                                         std::move(form), kIsNumber ? facts.unit : "", range)
      .storedAt([ quantity, member ](auto& of) -> auto& { return of.of(quantity).*member; });
}

/// The ranges of min and max are on opposite sides of the centre, so they cannot conflict.
void addSpread(VariationQuantity quantity, const std::string& help, Fields<VariationSettings>& to) {
  const VariationInfo& facts = variationInfo(quantity);
  const double centre = facts.isFactor ? 1.0 : 0.0;
  const double widest = widestOf(quantity);
  const double least = facts.isFactor ? facts.least : -widest;
  const double most = facts.isFactor ? facts.most : widest;
  const Range width{0.0, widest};
  using S = SpreadSettings;
  to.push_back(
      spreadField(quantity, "kind", &S::kind, help + "; absent: that of the preset", {"kind"}, {})
          .words({"none", "normal", "uniform"}));
  to.push_back(spreadField(quantity, "sd", &S::sd, "Normal: standard deviation",
                           {"deviation", 2, 0.05}, width));
  to.push_back(spreadField(quantity, "half_width", &S::halfWidth, "Uniform: half of the width",
                           {"half width", 2, 0.05}, width));
  to.push_back(
      spreadField(quantity, "min", &S::min, "Lower limit", {"minimum", 2, 0.1}, {least, centre}));
  to.push_back(
      spreadField(quantity, "max", &S::max, "Upper limit", {"maximum", 2, 0.1}, {centre, most}));
}

/// Warns about keys without effect: each width belongs to one kind of distribution.
void warnUnused(YamlMap& view, const SpreadSettings& own, SpreadKind kind) {
  static const std::vector<std::string> kWords = {"none", "normal", "uniform"};
  const auto warn = [&](const char* key, bool isGiven, bool isUsed) {
    if (isGiven && !isUsed) {
      view.warning(key, "scenario.spread-unused", {key, kWords[static_cast<std::size_t>(kind)]});
    }
  };
  const bool isDrawn = kind != SpreadKind::None;
  warn("sd", own.sd.has_value(), kind == SpreadKind::Normal);
  warn("half_width", own.halfWidth.has_value(), kind == SpreadKind::Uniform);
  warn("min", own.min.has_value(), isDrawn);
  warn("max", own.max.has_value(), isDrawn);
}

Field<DesktopSettings> stopOnCollisionField() {
  return field("stop_on_collision", &DesktopSettings::stopOnCollision,
               "Contacts of a robot on its route that end the run; `any`: with people, robots or "
               "walls",
               {"End on contact"})
      .words({"none", "people", "any"})
      .defaultsTo(StopOnCollision::None);
}

}  // namespace

const std::vector<std::string>& routeWords() {
  static const std::vector<std::string> kWords = {"planned", "direct"};
  return kWords;
}

Fields<ScenarioSettings> scenarioFields() {
  return {field("yaml_base_name", &ScenarioSettings::yamlBaseName,
                "Base name of the file; part of the names of tree files"),
          field("simulator", &ScenarioSettings::simulator,
                "Simulator in which HuNavSim runs the file", {"Simulator"}),
          field("map", &ScenarioSettings::map, "Name of the map, without folder and extension",
                {"Map name"}),
          field("publish_people", &ScenarioSettings::publishPeople, "Publish people on ROS topics",
                {"ROS topics"})
              .defaultsTo(true)};
}

Fields<DesktopSettings> settingsFields() {
  using Settings = DesktopSettings;
  return {
      FieldBuilder<Settings>("card", "Description of the scenario: what it tests, with its source")
          .withCustomIo(readCard, writeCard, &Settings::card),
      field("map_file", &Settings::mapFile,
            "Map file, relative to the scenario; `none`: open plane; absent: the file of `map` is "
            "searched",
            {"Map file"}),
      field("map_rule", &Settings::mapRule, "Nav2 branch whose rule for grey pixels is used",
            {"Map rule"})
          .words({"humble", "main"})
          .defaultsTo(std::string("humble")),
      field("seed", &Settings::seed, "Random seed; the same seed reproduces the run",
            {"Seed", 0, 1.0}, {}, base::kNotNegative)
          .defaultsTo(1),
      field("duration", &Settings::duration,
            "Time limit; absent: the run ends 1 s after the robot has arrived, at most 120 s; 60 s "
            "without a robot that has a goal",
            {"Duration", 1, 5.0}, "s", {0.0, base::kTime.high, true}),
      stopOnCollisionField(),
      field("stuck_after", &Settings::stuckAfter,
            "A robot is stuck if it makes no progress for this long; the run ends if no other "
            "robot makes progress; 0: never",
            {"Stuck after", 1, 5.0}, "s", base::kTime)
          .defaultsTo(0.0),
      field("dt", &Settings::dt, "Time step", {"Time step", 3, 0.005}, "s", {0.001, 0.1})
          .defaultsTo(0.05),
      field("record_every", &Settings::recordEvery,
            "Time steps from one recorded sample to the next", {"Record every", 0, 1.0}, {},
            {1.0, kLargestId})
          .defaultsTo(1),
      field("model", &Settings::model, "Pedestrian model, see `list models`", {"Model"})
          .defaultsTo(ResolvedHuman().model),
      FieldBuilder<Settings>("model_parameters",
                             "Parameters of models, below the name of each, see `list models "
                             "--format json`")
          .withCustomIo(readModelParameters, writeModelParameters, &Settings::modelParameters),
      field("route", &Settings::route,
            "Paths planned around walls, or straight lines as in HuNavSim", {"Routes"})
          .words(routeWords())
          .defaultsTo(Route::Planned),
      field("obstacle_points", &Settings::obstaclePoints,
            "Wall forces from the nearest points of walls, or from the hits of rays as of a lidar",
            {"Wall force from"})
          .words({"boundary", "rays"})
          .defaultsTo(ObstaclePoints::Boundary),
      field("loop_trees", &Settings::loopTrees, "Restart a tree that has ended", {"Loop trees"})
          .defaultsTo(true),
      field("wrap_x", &Settings::wrapX,
            "Periodic corridor: people who pass the second x re-enter at the first", {"Corridor"},
            "m", base::kCoordinateRange)
          .with(&Field<Settings>::read, readWrap),
      FieldBuilder<Settings>("groups", "Names of groups by their numbers")
          .withCustomIo(readGroups, writeGroups, &Settings::groups),
      FieldBuilder<Settings>("variation", "Variation of people between seeds")
          .withCustomIo(readVariation, writeVariation, &Settings::variation)};
}

Fields<MetricsSettings> metricsFields() {
  using Settings = MetricsSettings;
  return {
      moment("from", &Settings::from, {"begin", "goal", "motion"},
             "Start of the measurement: begin, goal, motion, time 5.0 or event contact", "From"),
      moment("until", &Settings::until, {"end", "arrival"},
             "End of the measurement: end, arrival, time 20.0 or event contact", "Until"),
      field("frequency", &Settings::frequency, "Sampling rate; 0: every recorded sample",
            {"Frequency", 1, 1.0}, "Hz", base::kRate)
          .defaultsTo(0.0),
      field("tag", &Settings::tag, "Name of the experiment in the results", {"Tag"})
          .defaultsTo(std::string("exp_1")),
      field("run_id", &Settings::runId, "Number of the run in the results", {"Run number", 0, 1.0})
          .defaultsTo(0),
      field("file", &Settings::file,
            "File that selects the metrics, relative to the scenario; absent: all metrics",
            {"Metrics file"}),
      FieldBuilder<Settings>("parameters", "Thresholds of metrics: name and value of each",
                             {"Thresholds"})
          .withCustomIo(readThresholds, writeThresholds, &Settings::parameters)};
}

/// The key `variation`: a preset, and a map per quantity. The table uses dotted keys for them:
/// `speed.sd`.
Fields<VariationSettings> variationFields() {
  Fields<VariationSettings> all;
  all.push_back(field("preset", &VariationSettings::preset,
                      "Amount of variation of people between seeds; keys of a quantity take "
                      "precedence",
                      {"Variation"})
                    .words({"none", "light", "strong"})
                    .defaultsTo(VariationPreset::None));
  addSpread(VariationQuantity::StartTime, "Added to the start time", all);
  addSpread(VariationQuantity::Start, "Added to x and y of the start", all);
  addSpread(VariationQuantity::Heading, "Added to the heading at the start", all);
  addSpread(VariationQuantity::Speed, "Factor of max_vel", all);
  addSpread(VariationQuantity::ReactionTime, "Factor of the reaction time", all);
  addSpread(VariationQuantity::FirstGoal,
            "Number of goals of a repeated route that are skipped at first", all);
  return all;
}

void readVariation(YamlMap& view, DesktopSettings& to) {
  VariationSettings& variation = to.variation;
  YamlMap map = view.map("variation");
  std::map<std::string, YamlMap> spreads;
  for (const auto& field : fieldsOf<VariationSettings>()) {
    const std::string part = partsOf(field.spec.key).first;
    if (!part.empty() && spreads.count(part) == 0) {
      spreads.emplace(part, map.map(part));
    }
    YamlMap& at = part.empty() ? map : spreads.at(part);
    field.assign(variation, readValue(at, innerSpec(field.spec), field.is64Bit));
  }
  for (std::size_t i = 0; i < kVariedCount; ++i) {
    const auto quantity = static_cast<VariationQuantity>(i);
    YamlMap& spread = spreads.at(variationInfo(quantity).key);
    warnUnused(spread, variation.of(quantity), spreadOf(variation, quantity).kind);
    variation.of(quantity).unknown = spread.takeUnknownKeys();
  }
  variation.unknown = map.takeUnknownKeys();
}

void writeVariation(YamlNode& tree, const DesktopSettings& desktop) {
  const VariationSettings& variation = desktop.variation;
  YamlNode map;
  for (const auto& field : fieldsOf<VariationSettings>()) {
    const ParameterValue value = field.value(variation);
    const std::string part = partsOf(field.spec.key).first;
    if (value != ParameterValue()) {
      writeValue(part.empty() ? map : map.child(part), innerSpec(field.spec), value, field.digits);
    }
  }
  for (std::size_t i = 0; i < kVariedCount; ++i) {
    const auto quantity = static_cast<VariationQuantity>(i);
    if (const UnknownKeys& unknown = variation.of(quantity).unknown; !unknown.empty()) {
      setUnknown(map.child(variationInfo(quantity).key), unknown);
    }
  }
  setUnknown(map, variation.unknown);
  if (!map.isNull()) {
    setChild(tree, "variation", std::move(map));
  }
}

}  // namespace sim2d
