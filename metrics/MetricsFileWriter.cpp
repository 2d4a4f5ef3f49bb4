#include "metrics/Report.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

/// A text that YAML reads back as a text.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? "''" : std::string(1, c);
  }
  return result + "'";
}

std::string ownText(const std::vector<MetricEntry>& own) {
  std::string text;
  for (const MetricEntry& entry : own) {
    const MetricInfo& info = entry.info;
    text += text.empty() ? std::string("hunavsim_metrics:\n  ros__parameters:\n") : std::string();
    text += "    " + info.key + ":\n";
    text += "      expression: " + quoted(info.formula) + "\n";
    text += "      name: " + quoted(info.name) + "\n";
    text += "      unit: " + quoted(info.unit) + "\n";
    text += std::string("      better: ") + betterName(info.better) + "\n";
  }
  return text;
}

const char* boolText(bool value) {
  return value ? "true" : "false";
}

}  // namespace

std::string writeMetricsFile(const MetricsFile& file, const MetricRegistry& registry) {
  const Selection& selection = file.selection;
  std::string text = "hunav_evaluator_node:\n  ros__parameters:\n";
  text += std::string("    use_sim_time: ") + boolText(file.useSimTime) + "\n";
  text += "    frequency: " + base::formatDecimals(selection.window.frequency, 1) + "\n";
  text += "    result_file: " + quoted(file.resultFile) + "\n";
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
