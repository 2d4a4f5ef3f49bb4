#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/cli/CommandLine.h"
#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "app/run/Export.h"
#include "editor/document/QtImageLoader.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

Json reportJson(const base::Diagnostics& report) {
  Json all = Json::array();
  for (const base::Diagnostic& problem : report) {
    all.push_back({{"severity", base::severityName(problem.severity)},
                   {"file", problem.file},
                   {"message", problem.message}});
  }
  return all;
}

/// What was not told yet.
base::Diagnostics notIn(const base::Diagnostics& told, const base::Diagnostics& report) {
  base::Diagnostics rest;
  for (const base::Diagnostic& problem : report) {
    const bool isTold = std::any_of(told.begin(), told.end(), [&](const base::Diagnostic& other) {
      return other.text() == problem.text();
    });
    if (!isTold) {
      rest.push_back(problem);
    }
  }
  return rest;
}

void printPlan(const ExportPlan& plan, const base::Diagnostics& report,
               const ConvertOptions& options, const OutputOptions& output) {
  if (output.json) {
    Json files = Json::array();
    for (const ExportPlan::File& file : plan.files) {
      files.push_back({{"file", file.content.path}, {"state", stateName(file.state)}});
    }
    const Json json = {{"target", options.target},
                       {"files", files},
                       {"report", reportJson(report)},
                       {"start", plan.startCommand.empty() ? Json() : Json(plan.startCommand)}};
    printLine(json.dump(2, ' ', false, Json::error_handler_t::replace));
    return;
  }
  if (output.quiet) {
    return;
  }
  for (const ExportPlan::File& file : plan.files) {
    const std::string state = stateName(file.state);
    printLine(state + std::string(10 - state.size(), ' ') + file.content.path);
  }
  if (!plan.startCommand.empty()) {
    printLine("copy the folders into the wrapper's package, build the workspace, then start:\n  " +
              plan.startCommand);
  }
}

}  // namespace

int convertCommand(const ConvertOptions& options, const OutputOptions& output) {
  const base::Result<ExportSource> source =
      readExportSource(options.scenario, options.map, options.trees, editor::loadMapImage);
  printDiagnostics(source.diagnostics(), base::Severity::Warning);
  if (!source) {
    return kBadInput;
  }
  ExportRequest request;
  request.target = options.target;
  request.folder = options.output;
  request.style = options.style == "hunav2" ? bt::TreeStyle::Hunav2 : bt::TreeStyle::Corrected;
  if (!options.dialect.empty()) {
    request.dialect = options.dialect == "B" ? sim2d::Dialect::B : sim2d::Dialect::C;
  }
  ExportPlan plan = planExport(*source, request);
  plan.report = notIn(source.diagnostics(), plan.report);
  printDiagnostics(plan.report, output.quiet ? base::Severity::Warning : base::Severity::Info);
  if (base::hasErrors(plan.report)) {
    return kBadInput;
  }
  const base::Diagnostics problems = writeExport(plan);
  printDiagnostics(problems);
  if (base::hasErrors(problems)) {
    return kBadInput;
  }
  base::Diagnostics report = source.diagnostics();
  base::append(report, plan.report);
  printPlan(plan, report, options, output);
  return kFine;
}

}  // namespace app
