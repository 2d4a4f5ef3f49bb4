#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/run/Nav2Robots.h"
#include "metrics/MetricParameters.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/Fields.h"

/// Every number that a scenario file can contain: from the tables of keys, of planners, models and
/// metrics, and from a file that has all structures.
namespace outside {

using base::YamlNode;
using YamlPath = std::vector<std::string>;  // "[2]": an item of a list

/// A number of the file, and the values that are tried for it.
struct NumericField {
  std::string name;             // "ROBOT.max_acc"
  std::vector<YamlPath> paths;  // from the root; all get the value
  std::vector<std::string> values;
  bool isList = false;  // where the file has none, a list of two is made
};

constexpr const char* kLoader = "hunav_loader";
constexpr const char* kBlock = "hunavsim_desktop";
constexpr const char* kBelow = "ros__parameters";

/// Zero, tiny, huge and non-finite numbers of both signs.
inline std::vector<std::string> extremeValues(bool isInteger) {
  std::vector<std::string> values = {"1.0e-300", "-1.0e-300", "1.0e-6",   "-1.0e-6",
                                     "1.0e+155", "-1.0e+155", "1.0e+300", "-1.0e+300",
                                     ".nan",     ".inf",      "-.inf"};
  const std::vector<std::string> plain =
      isInteger ? std::vector<std::string>{"0", "1000000", "-1000000", "2147483647",
                                           "9223372036854775807"}
                : std::vector<std::string>{"0.0", "1000000.0", "-1000000.0"};
  values.insert(values.end(), plain.begin(), plain.end());
  return values;
}

inline bool isInteger(const base::ParameterSpec& spec) {
  return spec.type == base::ParameterType::Integer || spec.type == base::ParameterType::Integers;
}
inline bool isList(const base::ParameterSpec& spec) {
  return spec.type == base::ParameterType::Numbers || spec.type == base::ParameterType::Integers;
}
inline bool isNumeric(const base::ParameterSpec& spec) {
  return spec.choices.empty() &&
         (isInteger(spec) || isList(spec) || spec.type == base::ParameterType::Number);
}

/// These and both ends of the range.
inline std::vector<std::string> valuesOf(const base::ParameterSpec& spec) {
  std::vector<std::string> values = extremeValues(isInteger(spec));
  for (const double end : {spec.range.low, spec.range.high}) {
    if (std::isfinite(end)) {
      values.push_back(isInteger(spec) ? std::to_string(std::llround(end))
                                       : base::formatDecimals(end, 1));
    }
  }
  return values;
}

/// A YAML scalar that a number can replace.
inline bool isNumber(const YamlNode& node) {
  return node.isScalar() && !node.quoted && base::parseDouble(node.text).has_value();
}

class NumericFields {
 public:
  explicit NumericFields(const YamlNode& scenario) : root_(scenario) {
    addWritten(root_, {});
    const std::vector<std::string> people = namesIn("agents", kLoader);
    const std::vector<std::string> robots = namesIn("robots", kBlock);
    add<sim2d::Human>("PERSON.", kLoader, people, {});
    add<sim2d::Behavior>("PERSON.behavior.", kLoader, people, {"behavior"});
    add<sim2d::PersonExtension>("PERSON.", kBlock, people, {});
    add<sim2d::Robot>("ROBOT.", kBlock, robots, {});
    add<sim2d::LidarSettings>("ROBOT.lidar.", kBlock, robots, {"lidar"});
    add<sim2d::DetectorSettings>("ROBOT.detector.", kBlock, robots, {"detector"});
    add<sim2d::OdometrySettings>("ROBOT.odometry_noise.", kBlock, robots, {"odometry_noise"});
    add<sim2d::LocalizationSettings>("ROBOT.localization.", kBlock, robots, {"localization"});
    add<sim2d::BatterySettings>("ROBOT.battery.", kBlock, robots, {"battery"});
    addPlain<sim2d::ScenarioSettings>(kLoader, {});
    addPlain<sim2d::DesktopSettings>(kBlock, {});
    addPlain<sim2d::VariationSettings>(kBlock, {"variation"});
    addPlain<sim2d::MetricsSettings>(kBlock, {"metrics"});
    for (const char* list : {"obstacles", "doors", "areas", "docks"}) {
      for (const std::string& name : namesIn(list, kBlock)) {
        addEntity(list, name);
      }
    }
    addParameters(robots);
  }
  const std::vector<NumericField>& all() const { return all_; }
  /// Keys whose range has no end on one side, but for numbers of 64 bits (the seed).
  const std::vector<std::string>& unbounded() const { return unbounded_; }

 private:
  const YamlNode& below(const char* node) const { return *root_.find(node)->find(kBelow); }

  std::vector<std::string> namesIn(const char* list, const char* node) const {
    std::vector<std::string> names;
    for (const YamlNode& item : below(node).find(list)->items) {
      names.push_back(item.text);
    }
    return names;
  }

  /// All numbers in the file.
  void addWritten(const YamlNode& node, const YamlPath& path) {
    for (std::size_t k = 0; k < node.items.size(); ++k) {
      YamlPath inner = path;
      inner.push_back(node.isMap() ? node.items[k].key : "[" + std::to_string(k) + "]");
      addWritten(node.items[k], inner);
    }
    if (isNumber(node)) {
      push(base::join(path, "."), {path}, extremeValues(base::parseInt(node.text).has_value()));
    }
  }

  void push(std::string name, std::vector<YamlPath> paths, std::vector<std::string> values,
            bool isListed = false) {
    all_.push_back({std::move(name), std::move(paths), std::move(values), isListed});
  }

  void addSpec(const std::string& name, const base::ParameterSpec& spec, bool is64Bit,
               const std::vector<YamlPath>& places) {
    if (!isNumeric(spec)) {
      return;
    }
    noteEnds(name, spec, is64Bit);
    push(name, places, valuesOf(spec), isList(spec));
  }

  void noteEnds(const std::string& name, const base::ParameterSpec& spec, bool is64Bit) {
    const bool hasEnds = std::isfinite(spec.range.low) && std::isfinite(spec.range.high);
    if (!hasEnds && !is64Bit) {
      unbounded_.push_back(name);
    }
  }

  static YamlPath pathOf(const char* node, const YamlPath& inner, const std::string& key) {
    YamlPath path = {node, kBelow};
    path.insert(path.end(), inner.begin(), inner.end());
    for (const std::string& word : base::split(key, '.')) {  // speed.sd
      path.push_back(word);
    }
    return path;
  }

  template <class T>
  void add(const std::string& title, const char* node, const std::vector<std::string>& owners,
           const YamlPath& inner) {
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
      if (field.isStructure()) {
        continue;  // its parts are in the file
      }
      std::vector<YamlPath> places;
      for (const std::string& owner : owners) {
        YamlPath path = {owner};
        path.insert(path.end(), inner.begin(), inner.end());
        places.push_back(pathOf(node, path, field.spec.key));
      }
      addSpec(title + field.spec.key, field.spec, field.is64Bit, places);
    }
  }

  template <class T>
  void addPlain(const char* node, const YamlPath& inner) {
    for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
      if (!field.isStructure()) {
        addSpec(base::join(inner, ".") + "." + field.spec.key, field.spec, field.is64Bit,
                {pathOf(node, inner, field.spec.key)});
      }
    }
  }

  void addEntity(const std::string& list, const std::string& name) {
    const YamlNode* const kind = below(kBlock).find(name)->find("kind");
    const auto addAll = [&](const auto& fields, const auto& thing) {
      for (const auto& field : fields) {
        if (!field.isStructure() && field.belongsTo(thing)) {
          addSpec(name + "." + field.spec.key, field.spec, field.is64Bit,
                  {pathOf(kBlock, {name}, field.spec.key)});
        }
      }
    };
    if (list == "obstacles") {
      sim2d::Obstacle obstacle;
      sim2d::fieldOf<sim2d::Obstacle>("kind")->assign(obstacle, kind->text);
      addAll(sim2d::fieldsOf<sim2d::Obstacle>(), obstacle);
    } else if (list == "doors") {
      addAll(sim2d::fieldsOf<sim2d::Door>(), sim2d::Door());
    } else if (list == "areas") {
      addAll(sim2d::fieldsOf<sim2d::Area>(), sim2d::Area());
    } else {
      addAll(sim2d::fieldsOf<sim2d::Dock>(), sim2d::Dock());
    }
  }

  /// Parameters of planners, models and metrics, which have tables of their own.
  void addParameters(const std::vector<std::string>& robots) {
    const sim2d::Registries known = app::builtinRegistries();
    for (const std::string& robot : robots) {
      const std::string planner = below(kBlock).find(robot)->find("planner")->text;
      for (const base::ParameterSpec& spec : known.planners.find(planner)->parameters) {
        addSpec(planner + "." + spec.key, spec, false,
                {pathOf(kBlock, {robot, "planner_parameters"}, spec.key)});
      }
    }
    for (const auto& planner : known.planners.entries()) {  // others of this build too
      for (const base::ParameterSpec& spec : planner.parameters) {
        if (isNumeric(spec)) {
          noteEnds(planner.name + "." + spec.key, spec, false);
        }
      }
    }
    for (const auto& model : known.models.entries()) {
      for (const base::ParameterSpec& spec : model.parameters) {
        addSpec(model.name + "." + spec.key, spec, false,
                {pathOf(kBlock, {"model_parameters", model.name}, spec.key)});
      }
    }
    for (const metrics::ParameterInfo& info : metrics::parameterInfos()) {
      addSpec("metrics.parameters." + info.spec.key, info.spec, false,
              {pathOf(kBlock, {"metrics", "parameters"}, info.spec.key)});
    }
  }

  const YamlNode& root_;
  std::vector<NumericField> all_;
  std::vector<std::string> unbounded_;
};

/// The file with the value at all places of the field; in a list, as its first element.
inline YamlNode withValue(YamlNode root, const NumericField& field, const std::string& value) {
  for (const YamlPath& path : field.paths) {
    YamlNode* at = &root;
    for (const std::string& key : path) {
      const bool isItem = key.front() == '[';
      at = isItem ? &at->items[std::stoul(key.substr(1))] : &at->child(key);
    }
    if (at->isList()) {
      at->items.front() = base::scalarNode(value);
      continue;
    }
    const std::string key = at->key;
    *at = base::scalarNode(value);
    if (field.isList) {
      *at = YamlNode(YamlNode::Kind::List);
      at->items = {base::scalarNode(value), base::scalarNode("1.0")};
    }
    at->key = key;
  }
  return root;
}

}  // namespace outside
