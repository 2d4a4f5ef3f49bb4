#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "metrics/FormulaReader.h"
#include "metrics/Report.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

using base::YamlNode;

constexpr char kOwnNode[] = "hunavsim_metrics";

/// Keys that can be selected: all but the parts of others.
std::vector<std::string> selectableKeys(const MetricRegistry& registry) {
  std::vector<std::string> keys;
  for (const MetricEntry& entry : registry.entries()) {
    if (entry.info.partOf.empty()) {
      keys.push_back(entry.info.key);
    }
  }
  return keys;
}

void turnOn(const MetricInfo& info, bool on, Selection::Keys& keys) {
  if (info.hunav > 0 && !on) {
    keys.off.insert(info.key);
  } else if (info.hunav > 0) {
    keys.off.erase(info.key);
  } else if (on) {
    keys.on.insert(info.key);
  } else {
    keys.on.erase(info.key);
  }
}

class FileReader {
 public:
  FileReader(std::string name, const MetricRegistry& registry)
      : name_(std::move(name)), registry_(registry) {
    file_.selection.keys.emplace();
  }

  base::Result<MetricsFile> read(const YamlNode& root) {
    const YamlNode* own = root.find(kOwnNode);
    if (own != nullptr) {
      FormulaReader(name_, registry_, file_.selection.own, problems_)
          .read(own->find("ros__parameters"), *own);
    }
    if (own != nullptr && root.items.size() == 1) {
      file_.selection.keys.reset();
      return finished();
    }
    const YamlNode& parameters = find(root);
    if (!parameters.isMap()) {
      error(root, "metrics.no-parameters");
      return problems_;
    }
    for (const YamlNode& entry : parameters.items) {
      readEntry(entry.key, entry);
    }
    return finished();
  }

 private:
  base::Result<MetricsFile> finished() {
    if (base::hasErrors(problems_)) {
      return problems_;
    }
    return {std::move(file_), std::move(problems_)};
  }

  void error(const YamlNode& node, std::string_view code, base::ProblemValues values = {}) {
    problems_.push_back(placed(base::error(code, std::move(values)), node, name_));
  }
  void warn(const YamlNode& node, std::string_view code, base::ProblemValues values) {
    problems_.push_back(placed(base::warning(code, std::move(values)), node, name_));
  }

  /// Parameters of the node; a file may also hold them without the two outer keys.
  static const YamlNode& find(const YamlNode& root) {
    for (const YamlNode& entry : root.items) {
      const YamlNode* parameters = entry.find("ros__parameters");
      if (root.isMap() && entry.key != kOwnNode && parameters != nullptr) {
        return *parameters;
      }
    }
    return root;
  }

  void readEntry(const std::string& key, const YamlNode& value) {
    if (key == "metrics") {
      readMetrics(value);
    } else if (key == "frequency") {
      readFrequency(value);
    } else if (key == "result_file") {
      readText(value, file_.resultFile);
    } else if (key == "experiment_tag") {
      readText(value, file_.selection.tag);
    } else if (key == "use_sim_time") {
      file_.useSimTime = readBool(value, key);
    } else if (key == "run_id") {
      file_.selection.runId = static_cast<int>(base::parseInt(value.text).value_or(0));
    } else if (!isIgnored(key)) {
      warn(
          value, "metrics.unknown-key",
          {key, base::nearestName(key, {"metrics", "frequency", "result_file", "experiment_tag"})});
    }
  }

  static bool isIgnored(const std::string& key) {  // of the first version, without effect on values
    static constexpr std::array<const char*, 3> kKeys = {"mode", "use_navgoal_to_start",
                                                         "use_nav_goal_to_start"};
    return std::any_of(kKeys.begin(), kKeys.end(),
                       [&key](const char* known) { return key == known; });
  }

  void readText(const YamlNode& value, std::string& to) {
    if (value.isScalar()) {
      to = value.text;
    } else {
      error(value, "metrics.no-text");
    }
  }

  void readFrequency(const YamlNode& value) {
    const std::optional<double> frequency =
        value.isScalar() ? base::parseDouble(value.text) : std::nullopt;
    if (!frequency || !std::isfinite(*frequency) || *frequency < 0.0) {
      error(value, "metrics.bad-frequency");
      return;
    }
    file_.selection.window.frequency = *frequency;
  }

  bool readBool(const YamlNode& value, const std::string& key) {
    const std::string text = value.isScalar() ? base::lowered(value.text) : "";
    if (text == "true" || text == "false") {
      return text == "true";
    }
    error(value, "metrics.no-boolean", {key});
    return false;
  }

  void readMetrics(const YamlNode& value) {
    if (value.isList()) {  // the first version listed the names
      for (const MetricEntry& entry : registry_.entries()) {
        turnOn(entry.info, false, *file_.selection.keys);
      }
      for (const YamlNode& item : value.items) {
        turnKey(item, item.isScalar() ? item.text : "", true);
      }
      return;
    }
    if (!value.isMap()) {
      error(value, "metrics.no-map");
      return;
    }
    std::set<std::string> seen;
    for (const YamlNode& entry : value.items) {
      const std::string& key = entry.key;
      if (!seen.insert(key).second) {
        error(keyNode(entry), "metrics.key-twice", {key});
      }
      turnKey(keyNode(entry), key, readBool(entry, key));
    }
  }

  void turnKey(const YamlNode& place, const std::string& key, bool on) {
    const MetricEntry* entry = registry_.find(key);
    if (entry == nullptr || !entry->info.partOf.empty()) {
      warn(place, "metrics.unknown-metric",
           {key, base::nearestName(key, selectableKeys(registry_))});
      return;
    }
    turnOn(entry->info, on, *file_.selection.keys);
  }

  std::string name_;
  const MetricRegistry& registry_;
  MetricsFile file_;
  base::Diagnostics problems_;
};

}  // namespace

base::Result<Selection> selectionOfKeys(const std::vector<std::string>& keys,
                                        const MetricRegistry& registry) {
  Selection selection;
  selection.keys.emplace();
  for (const MetricEntry& entry : registry.entries()) {
    turnOn(entry.info, false, *selection.keys);
  }
  base::Diagnostics problems;
  for (const std::string& key : keys) {
    const MetricEntry* entry = registry.find(key);
    if (entry == nullptr || !entry->info.partOf.empty()) {
      problems.push_back(base::error("metrics.unknown-metric",
                                     {key, base::nearestName(key, selectableKeys(registry))}));
      continue;
    }
    turnOn(entry->info, true, *selection.keys);
  }
  if (!problems.empty()) {
    return problems;
  }
  return selection;
}

base::Result<MetricsFile> parseMetricsFile(const std::string& text, const std::string& name,
                                           const MetricRegistry& registry) {
  base::Diagnostics problems;
  const YamlNode root = base::parseYaml(text, name, problems);
  for (const base::Diagnostic& problem : problems) {
    // a second document is not read, repeated keys are told where they matter
    if (problem.code != "yaml.second-document" && problem.code != "yaml.key-twice" &&
        problem.code != "yaml.key-no-word") {
      const std::string reason = problem.value("reason");
      return base::error("metrics.not-yaml", {reason.empty() ? problem.message : reason}, name,
                         problem.line, problem.column);
    }
  }
  return FileReader(name, registry).read(root);
}

base::Result<MetricsFile> readMetricsFile(const std::string& path, const MetricRegistry& registry) {
  base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  return parseMetricsFile(*text, path, registry);
}

}  // namespace metrics
