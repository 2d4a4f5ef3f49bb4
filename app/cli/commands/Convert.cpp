#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Export.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/JsonText.h"

namespace app {

namespace {

struct ConvertOptions {
  RunSpec source;                   // scenario, map, trees
  std::string output;               // folder
  std::string target;               // name of exportTargets()
  std::string dialect;              // B, C; empty: that of the target
  std::string style = "corrected";  // of generated trees: corrected, hunav2
  bool force = false;               // overwrite files not created by hunavsim
};

using Json = nlohmann::ordered_json;

Json diagnosticsJson(const base::Diagnostics& report) {
  Json all = Json::array();
  for (const base::Diagnostic& problem : report) {
    all.push_back({{"severity", base::severityName(problem.severity)},
                   {"file", problem.file},
                   {"code", problem.code},
                   {"message", problem.message}});
  }
  return all;
}

void printPlan(const ExportPlan& plan, const base::Diagnostics& report,
               const ConvertOptions& options, const Invocation& given) {
  if (given.json) {
    Json files = Json::array();
    for (const ExportPlan::File& file : plan.files) {
      files.push_back({{"file", file.content.path}, {"state", fileStateName(file.state)}});
    }
    const Json json = {{"target", options.target},
                       {"files", files},
                       {"report", diagnosticsJson(report)},
                       {"start", plan.startCommand.empty() ? Json() : Json(plan.startCommand)}};
    print(base::jsonText(json) + "\n");
    return;
  }
  if (given.quiet) {
    return;
  }
  for (const ExportPlan::File& file : plan.files) {
    const std::string state = fileStateName(file.state);
    printLine(state + std::string(10 - state.size(), ' ') + file.content.path);
  }
  if (!plan.startCommand.empty()) {
    printLine("copy the folders into the wrapper's package, build the workspace, then start:\n  " +
              plan.startCommand);
  }
}

int convertCommand(const ConvertOptions& options, const Invocation& given) {
  const base::Result<Bundle> source = readExportSource(options.source, loadMapImage);
  requireFine(source.diagnostics(), ExitBadInput, base::Severity::Warning);
  ExportRequest request;
  request.target = options.target;
  request.folder = options.output;
  request.style = options.style == "hunav2" ? bt::TreeStyle::Hunav2 : bt::TreeStyle::Corrected;
  if (!options.dialect.empty()) {
    request.dialect = options.dialect == "B" ? sim2d::Dialect::B : sim2d::Dialect::C;
  }
  ExportPlan plan = planExport(*source, request);
  plan.report = newDiagnostics(source.diagnostics(), plan.report);
  requireFine(plan.report, ExitBadInput,
              given.quiet ? base::Severity::Warning : base::Severity::Info);
  std::vector<base::FileContent> files;
  files.reserve(plan.files.size());
  for (const ExportPlan::File& file : plan.files) {
    files.push_back({file.name, file.content.content});
  }
  requireFine(writeIntoForeignFolder(options.output, files, "convert", options.force));
  base::Diagnostics report = source.diagnostics();
  base::append(report, plan.report);
  printPlan(plan, report, options, given);
  return ExitFine;
}

}  // namespace

void addConvert(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "convert", "Export a scenario with trees and map for another simulator", convertCommand);
  std::vector<std::string> targets;
  for (const sim2d::TargetInfo& target : sim2d::exportTargets()) {
    targets.push_back(target.name);
  }
  command.add_option("scenario", options.source.scenario, "Scenario file in any dialect")
      ->required()
      ->transform(scenarioFile);
  addOutputFolder(command, options.output, "Output folder for scenarios, behavior_trees and maps")
      .required();
  command.add_option("--target", options.target, "Target simulator")
      ->required()
      ->check(oneOf(targets));
  command
      .add_option("--dialect", options.dialect,
                  "Scenario dialect: B or C (default: that of the target)")
      ->check(oneOf({"B", "C"}));
  command.add_option("--style", options.style, "Style of generated trees: corrected or hunav2")
      ->check(oneOf({"corrected", "hunav2"}));
  command.add_option("--map", options.source.map, "Map to use instead of the scenario's");
  addForce(command, options.force);
  addRunOption(command, "trees", options.source);
  commands.addExamples(command, {{"hunavsim convert corner_cafe_agents -o ws --target webots",
                                  "Export the café for Webots"}});
}

}  // namespace app
