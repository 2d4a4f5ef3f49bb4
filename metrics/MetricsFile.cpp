#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "metrics/Expression.h"
#include "metrics/Report.h"
#include "sim2d/base/Ranges.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlMap.h"

namespace metrics {

namespace {

using base::YamlNode;

constexpr char kOwnNode[] = "hunavsim_metrics";

/// Keys that can be selected; parts of other metrics are excluded.
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
  const bool isHunav = info.hunav > 0;
  std::set<std::string>& listed = isHunav ? keys.off : keys.on;
  if (on != isHunav) {
    listed.insert(info.key);
  } else {
    listed.erase(info.key);
  }
}

bool isKey(const std::string& key) {
  const auto isLetter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !key.empty() && isLetter(key.front()) && std::all_of(key.begin(), key.end(), [&](char c) {
    return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

class FileReader {
 public:
  FileReader(const std::string& name, const MetricRegistry& registry) : registry_(registry) {
    report_.file = name;
    file_.selection.keys.emplace();
  }

  base::Result<MetricsFile> read(const YamlNode& root) {
    const YamlNode* own = root.find(kOwnNode);
    if (own != nullptr) {
      readFormulas(own->find("ros__parameters"), *own);
    }
    if (own != nullptr && root.items.size() == 1) {
      file_.selection.keys.reset();
      return finished();
    }
    const YamlNode& parameters = find(root);
    if (!parameters.isMap()) {
      error(root, "metrics.no-parameters");
      return report_.diagnostics;
    }
    for (const YamlNode& entry : parameters.items) {
      readEntry(entry.key, entry);
    }
    return finished();
  }

 private:
  base::Result<MetricsFile> finished() {
    if (base::hasErrors(report_.diagnostics)) {
      return report_.diagnostics;
    }
    return {std::move(file_), std::move(report_.diagnostics)};
  }

  void error(const YamlNode& node, std::string_view code, base::ProblemValues values = {}) {
    report_.add(node, base::error(code, std::move(values)));
  }
  void warn(const YamlNode& node, std::string_view code, base::ProblemValues values) {
    report_.add(node, base::warning(code, std::move(values)));
  }

  /// The parameters of the node; a file may also contain them without the two outer keys.
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

  static bool isIgnored(const std::string& key) {  // of the first version, no effect on values
    return key == "mode" || key == "use_navgoal_to_start" || key == "use_nav_goal_to_start";
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
    if (!frequency || !std::isfinite(*frequency) || *frequency < 0.0 ||
        *frequency > base::kRate.high) {
      error(value, "metrics.bad-frequency");
      return;
    }
    file_.selection.window.frequency = *frequency;
  }

  bool readBool(const YamlNode& value, const std::string& key) {
    const std::string text = value.isScalar() ? base::toLower(value.text) : "";
    if (text == "true" || text == "false") {
      return text == "true";
    }
    error(value, "metrics.no-boolean", {key});
    return false;
  }

  void readMetrics(const YamlNode& value) {
    if (value.isList()) {  // the first version has a list of names
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
    for (const YamlNode& entry : value.items) {
      const std::string& key = entry.key;
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

  /// `place`: position for the report of a missing map.
  void readFormulas(const YamlNode* metrics, const YamlNode& place) {
    if (metrics == nullptr || !metrics->isMap()) {
      error(place, "metrics.no-formulas");
      return;
    }
    for (const YamlNode& entry : metrics->items) {
      const std::string& key = entry.key;
      const bool isTaken =
          registry_.find(key) != nullptr ||
          std::any_of(file_.selection.own.begin(), file_.selection.own.end(),
                      [&key](const MetricEntry& other) { return other.info.key == key; });
      if (isTaken) {
        error(keyNode(entry), "metrics.name-taken", {key});
      } else if (!isKey(key)) {
        error(keyNode(entry), "metrics.bad-key");
      } else {
        readFormula(key, keyNode(entry), entry);
      }
    }
  }

  void readFormula(const std::string& key, const YamlNode& place, const YamlNode& value) {
    UserMetric metric;
    metric.key = key;
    const YamlNode* expression = value.find("expression");
    if (expression == nullptr || !expression->isScalar()) {
      error(place, "metrics.no-expression", {key});
      return;
    }
    for (const YamlNode& entry : value.items) {
      const std::string& name = entry.key;
      if (name == "expression") {
        metric.expression = entry.text;
      } else if (name == "name") {
        readText(entry, metric.name);
      } else if (name == "unit") {
        readText(entry, metric.unit);
      } else if (name == "better") {
        readBetter(entry, metric.better);
      } else {
        warn(keyNode(entry), "metrics.unknown-key",
             {name, base::nearestName(name, {"expression", "name", "unit", "better"})});
      }
    }
    addFormula(metric, *expression);
  }

  void readBetter(const YamlNode& value, Better& better) {
    for (const Better candidate : {Better::Lower, Better::Higher, Better::Neutral}) {
      if (value.isScalar() && value.text == betterName(candidate)) {
        better = candidate;
        return;
      }
    }
    error(value, "metrics.bad-better");
  }

  /// Sets the position of problems in this file; formulas are on one line, quoted or not.
  void addFormula(const UserMetric& metric, const YamlNode& text) {
    const base::Result<MetricEntry> entry = entryOf(metric);
    if (entry) {
      file_.selection.own.push_back(*entry);
    }
    const int quote = text.quoted && text.tag.empty() ? 1 : 0;
    for (base::Diagnostic problem : entry.diagnostics()) {
      problem.file = report_.file;
      problem.line = text.line;
      problem.column += text.column - 1 + quote;
      report_.diagnostics.push_back(problem);
    }
  }

  const MetricRegistry& registry_;
  MetricsFile file_;
  base::ReadReport report_;
};

std::string ownText(const std::vector<MetricEntry>& own) {
  std::string text;
  for (const MetricEntry& entry : own) {
    const MetricInfo& info = entry.info;
    text += text.empty() ? std::string("hunavsim_metrics:\n  ros__parameters:\n") : std::string();
    text += "    " + info.key + ":\n";
    text += "      expression: " + base::quotedText(info.formula) + "\n";
    text += "      name: " + base::quotedText(info.name) + "\n";
    text += "      unit: " + base::quotedText(info.unit) + "\n";
    text += std::string("      better: ") + betterName(info.better) + "\n";
  }
  return text;
}

const char* boolText(bool value) {
  return value ? "true" : "false";
}

}  // namespace

bool Selection::selects(const MetricInfo& info) const {
  if (!keys) {
    return true;
  }
  const std::string& key = info.partOf.empty() ? info.key : info.partOf;
  const bool isHunav = info.hunav > 0 || !info.partOf.empty();
  return isHunav ? keys->off.count(key) == 0 : keys->on.count(key) > 0;
}

std::vector<MetricEntry> Selection::entries(const MetricRegistry& registry) const {
  std::vector<MetricEntry> selected;
  for (const MetricEntry& entry : registry.entries()) {
    if (selects(entry.info)) {
      selected.push_back(entry);
    }
  }
  selected.insert(selected.end(), own.begin(), own.end());
  return selected;
}

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
  const YamlNode root = base::parseYaml(text, name, base::DuplicateKeys::LastWins, problems);
  for (const base::Diagnostic& problem : problems) {
    const bool isWarning = problem.severity == base::Severity::Warning;
    // a second document is ignored
    if (!isWarning && problem.code != "yaml.second-document" &&
        problem.code != "yaml.key-no-word") {
      const std::string reason = problem.value("reason");
      return base::error("metrics.not-yaml", {reason.empty() ? problem.message : reason}, name,
                         problem.line, problem.column);
    }
  }
  base::Result<MetricsFile> file = FileReader(name, registry).read(root);
  base::Diagnostics all;
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(all),
               [](const base::Diagnostic& problem) {
                 return problem.severity == base::Severity::Warning;  // repeated keys
               });
  base::append(all, file.diagnostics());
  return file ? base::Result<MetricsFile>(*std::move(file), std::move(all))
              : base::Result<MetricsFile>(std::move(all));
}

base::Result<MetricsFile> readMetricsFile(const std::string& path, const MetricRegistry& registry) {
  base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  return parseMetricsFile(*text, path, registry);
}

std::string writeMetricsFile(const MetricsFile& file, const MetricRegistry& registry) {
  const Selection& selection = file.selection;
  std::string text = "hunav_evaluator_node:\n  ros__parameters:\n";
  text += std::string("    use_sim_time: ") + boolText(file.useSimTime) + "\n";
  text += "    frequency: " + base::formatDecimals(selection.window.frequency, 1) + "\n";
  text += "    result_file: " + base::quotedText(file.resultFile) + "\n";
  text += "    metrics:\n";
  for (const MetricEntry& entry : registry.entries()) {
    const bool on = selection.selects(entry.info);
    const bool listed = entry.info.partOf.empty() && (entry.info.hunav > 0 || on);
    if (listed) {
      text += "      " + entry.info.key + ": " + boolText(on) + "\n";
    }
  }
  return text + ownText(selection.own);
}

}  // namespace metrics
