#include "app/run/MetricsSetup.h"

#include <filesystem>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

base::Diagnostics readParameters(const std::vector<std::pair<std::string, double>>& settings,
                                 metrics::MetricParameters& parameters, const std::string& file) {
  base::Diagnostics problems;
  for (const auto& [name, value] : settings) {
    if (const metrics::ParameterInfo* info = metrics::findParameter(name)) {
      parameters.*(info->member) = value;
      if (!info->spec.range.contains(value)) {
        problems.push_back(
            base::withContext(name, base::outOfRange(base::formatDouble(value), info->spec.range)));
        problems.back().file = file;
      }
      continue;
    }
    std::vector<std::string> known;
    for (const metrics::ParameterInfo& info : metrics::parameterInfos()) {
      known.push_back(info.spec.key);
    }
    problems.push_back(
        base::error("metrics.unknown-parameter", {name, base::nearestName(name, known)}, file));
  }
  return problems;
}

void applyFile(const base::Result<metrics::MetricsFile>& file, MetricsSetup& setup,
               base::Diagnostics& problems) {
  base::append(problems, file.diagnostics());
  if (file) {
    setup.selection = file->selection;
    setup.hasFile = true;
  }
}

void addWindowProblem(const metrics::Window& window, const std::string& file,
                      base::Diagnostics& problems) {
  if (std::optional<base::Diagnostic> wrong = metrics::windowError(window)) {
    wrong->file = file;
    problems.push_back(*std::move(wrong));
  }
}

/// Metrics of the card that do not exist.
void addCardProblems(const sim2d::ScenarioCard& card, const std::string& scenarioPath,
                     base::Diagnostics& problems) {
  const metrics::MetricRegistry& registry = metrics::standardRegistry();
  for (const std::string& key : card.metrics) {
    if (registry.find(key) != nullptr) {
      continue;
    }
    base::Diagnostics one = {base::error(
        "card.unknown-metric", {key, base::nearestName(key, registry.keys())}, scenarioPath)};
    sim2d::addKeyLocation(one, scenarioPath, {"hunavsim_desktop.ros__parameters.card.metrics"});
    base::append(problems, one);
  }
}

}  // namespace

std::optional<std::string> metricsFileOf(const sim2d::Scenario& scenario,
                                         const std::string& scenarioPath) {
  const std::optional<std::string>& file = scenario.desktop.metrics.file;
  return file ? std::optional((std::filesystem::path(scenarioPath).parent_path() / *file).string())
              : std::nullopt;
}

base::Result<MetricsSetup> metricsSetupOf(const sim2d::Scenario& scenario,
                                          const std::string& scenarioPath) {
  const sim2d::MetricsSettings& settings = scenario.desktop.metrics;
  MetricsSetup setup;
  base::Diagnostics problems;
  for (base::Diagnostic& wrong :
       readParameters(settings.parameters, setup.parameters, scenarioPath)) {
    base::Diagnostics one = {std::move(wrong)};
    const std::string name = one.front().value("where");
    sim2d::addKeyLocation(one, scenarioPath,
                          {"hunavsim_desktop.ros__parameters.metrics.parameters." + name});
    base::append(problems, one);
  }
  addCardProblems(scenario.desktop.card, scenarioPath, problems);
  if (const auto path = metricsFileOf(scenario, scenarioPath)) {
    applyFile(metrics::readMetricsFile(*path), setup, problems);
  }
  metrics::Selection& selection = setup.selection;
  selection.window.from = settings.from.value_or(selection.window.from);
  selection.window.until = settings.until.value_or(selection.window.until);
  selection.window.frequency = settings.frequency.value_or(selection.window.frequency);
  selection.tag = settings.tag.value_or(selection.tag);
  selection.runId = settings.runId.value_or(selection.runId);
  addWindowProblem(selection.window, scenarioPath, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {setup, problems};
}

base::Diagnostics readMetricsSetup(const sim2d::TraceHeader& header, MetricsSetup& setup) {
  const char file[] = "trace.json";
  const sim2d::TraceMetrics& recorded = header.metrics;
  base::Diagnostics problems = readParameters(recorded.parameters, setup.parameters, file);
  if (!recorded.selection.empty()) {
    applyFile(metrics::parseMetricsFile(recorded.selection, file), setup, problems);
  }
  metrics::Selection& selection = setup.selection;
  selection.window = {recorded.from, recorded.until, recorded.frequency};
  selection.tag = recorded.tag;
  selection.runId = recorded.runId;
  addWindowProblem(selection.window, file, problems);
  return problems;
}

void storeMetricsSelection(const MetricsSetup& setup, sim2d::TraceHeader& header) {
  if (!setup.hasFile) {
    return;
  }
  header.metrics.selection = metrics::writeMetricsFile({setup.selection, "metrics", true});
  header.metrics.frequency = setup.selection.window.frequency;
  header.metrics.tag = setup.selection.tag;
  header.metrics.runId = setup.selection.runId;
}

base::Result<int> robotIdOf(const sim2d::TraceHeader& header, const std::string& word) {
  const std::optional<long long> number = base::parseInt(word);
  std::vector<std::string> names;
  for (const sim2d::TraceRobot& robot : header.robots) {
    if (word == robot.name || (number && (*number == robot.id || *number == -robot.id))) {
      return robot.id;
    }
    names.push_back(robot.name);
  }
  const std::string known = names.empty() ? "none" : base::join(names, ", ");
  return base::error("option.unknown-name",
                     {"--robot", word, base::nearestName(word, names), known});
}

base::Diagnostics applyMetricsOptions(const MetricsOptions& options, MetricsSetup& setup,
                                      base::Diagnostics& wrongOptions) {
  setup.parameters.profile = *metrics::profileOf(options.metricsProfile);
  if (options.metrics.empty()) {
    return {};
  }
  std::error_code ignored;
  const bool namesAFile = options.metrics.find_first_of("/.") != std::string::npos;
  if (namesAFile || std::filesystem::exists(options.metrics, ignored)) {
    const base::Result<metrics::MetricsFile> file = metrics::readMetricsFile(options.metrics);
    if (file) {
      setup.selection.keys = file->selection.keys;
      setup.selection.own = file->selection.own;
    }
    return file.diagnostics();
  }
  const base::Result<metrics::Selection> chosen =
      metrics::selectionOfKeys(base::split(options.metrics, ','));
  if (chosen) {
    setup.selection.keys = chosen->keys;
    setup.selection.own.clear();
  }
  base::append(wrongOptions, chosen.diagnostics());
  return {};
}

void skipUnwrittenMetrics(bool hasFiles, bool showsBehaviors, metrics::Selection& selection) {
  selection.everyRobot = true;
  selection.series = selection.seriesOnDisk = hasFiles;
  selection.behaviors = showsBehaviors;
  selection.behaviorSeries = false;  // in no file
}

}  // namespace app
