#include <CLI/CLI.hpp>

#include "app/cli/CertifyCommand.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/Export.h"
#include "app/run/FileKind.h"
#include "app/run/Nav2Robots.h"
#include "bt/engine/Program.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/scenario/Fields.h"

namespace app {

namespace {

struct CheckOptions {
  std::vector<std::string> files;
  RunSpec scenario;    // map, trees, nav2Params, strict
  std::string distro;  // of Nav2's files; empty = guessed from them
  CertifyOptions certify;
};

base::Diagnostics checkScenarioFile(const std::string& path, const CheckOptions& options) {
  RunSpec run = options.scenario;
  run.strict = false;  // applied to all files together
  run.scenario = path;
  if (!run.nav2Params.empty()) {
    run.planner = sim2d::kNav2Planner;
  }
  const Bundle bundle = readBundle(run, {}, loadMapImage);
  Verdict verdict = check(bundle);
  base::append(verdict.problems, verdict.wrongOptions);
  base::append(verdict.problems, verdict.worldRemarks);
  if (bundle.hasScenario()) {
    base::append(verdict.problems,
                 newDiagnostics(verdict.problems, treeCompatibilityNotes(bundle)));
  }
  return verdict.problems;
}

/// Checks a tree file: nodes, ports, references and compilation.
base::Diagnostics checkTree(const std::string& path) {
  const base::Result<bt::TreeTable> table = bt::loadTrees(path);
  base::Diagnostics found = table.diagnostics();
  if (!table) {
    return found;
  }
  const bt::NodeLibrary library = bt::humanNodes();
  base::append(found, bt::diagnosticsOf(bt::checkForImport(*table, library.catalogue())));
  if (!base::hasErrors(found)) {  // the compiler repeats these checks
    bt::CompileOptions options;
    options.differencesFromBtCpp = true;
    base::append(found, newDiagnostics(found, bt::compile(*table, library, options).diagnostics()));
  }
  return found;
}

/// Checks the experiment and its scenarios as `batch` does; code that needs --allow-code is a
/// warning.
base::Diagnostics checkExperiment(const std::string& path) {
  base::Result<Experiment> experiment = readExperiment(path);
  base::Diagnostics found = experiment.diagnostics();
  if (experiment) {
    ExperimentRunner runner(*experiment, {}, loadMapImage);
    base::append(found, newDiagnostics(found, runner.check(base::Severity::Warning)));
  }
  return found;
}

base::Diagnostics checkFile(const std::string& fileOrName, const CheckOptions& options) {
  const std::string path = scenarioFile(fileOrName);
  if (const std::optional<base::Diagnostic> unknown = unknownScenario(path)) {
    return {*unknown};
  }
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  const Nav2Branch branch = sim2d::nav2::distroFromName(options.distro);
  switch (fileKindOf(*text)) {
    case FileKind::Tree:
      return checkTree(path);
    case FileKind::NavigatorTree:
      return checkNavigatorTree(path, branch);
    case FileKind::Nav2: {
      std::vector<std::string> entries = options.scenario.nav2Params;
      entries.insert(entries.begin(), path);
      return checkNav2Files(entries, branch);
    }
    case FileKind::Map:
      return readMapFile(path, "humble", loadMapImage).diagnostics();
    case FileKind::Experiment:
      return checkExperiment(path);
    case FileKind::Scenario:
      break;
  }
  return checkScenarioFile(path, options);
}

std::string summary(std::size_t files, const base::Diagnostics& diagnostics) {
  std::size_t warnings = 0;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    warnings += diagnostic.severity == base::Severity::Warning ? 1 : 0;
  }
  const auto count = [](std::size_t number, const std::string& noun) {
    return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
  };
  return count(files, "file") + " checked: " + count(errorsOf(diagnostics).size(), "error") + ", " +
         count(warnings, "warning");
}

int checkCommand(const CheckOptions& options, const Invocation& given) {
  if (options.certify.isGiven()) {
    return certifyCommand(options.files, options.certify, given);
  }
  base::Diagnostics all;
  const auto show = [&](base::Diagnostics found) {
    found = options.scenario.strict ? base::withStrictSubstitutions(std::move(found))
                                    : std::move(found);
    if (!given.json) {
      printDiagnostics(found);
    }
    base::append(all, found);
  };
  const std::vector<std::string>& params = options.scenario.nav2Params;
  if (options.files.empty()) {  // all parameter files as one
    show(checkNav2Files(params, sim2d::nav2::distroFromName(options.distro)));
  }
  for (const std::string& file : options.files) {
    show(checkFile(file, options));
  }
  if (given.json) {
    printJson(all);
  } else if (!given.quiet) {
    printLine(summary(options.files.empty() ? params.size() : options.files.size(), all));
  }
  return base::hasErrors(all) ? ExitBadInput : ExitFine;
}

}  // namespace

void addCheck(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "check", "Validate scenarios, trees, maps, experiments and nav2_params.yaml files",
      checkCommand);
  command.add_option("files", options.files,
                     "Files, or names of shipped scenarios (hunavsim list scenarios)");
  command.add_option("--map", options.scenario.map,
                     "Map to use instead of the scenario's; none = open plane");
  command.add_option("--trees", options.scenario.trees, "Folder with the behaviour trees");
  command
      .add_option("--nav2-distro", options.distro,
                  "Nav2 version of the files: humble, jazzy, kilted, lyrical or main (default: "
                  "guessed from the file)")
      ->check(oneOf(knownDistros()));
  addRunOption(command, "nav2-params", options.scenario);
  addRunOption(command, "strict", options.scenario);
  addCertifyOptions(command, options.certify);
  command.callback([&checked = options] {
    const bool hasAll = checked.certify.isGiven() && checked.certify.all;
    if (!hasAll && checked.files.empty() && checked.scenario.nav2Params.empty()) {
      throw CLI::RequiredError("files");
    }
  });
  commands.addExamples(
      command, {{"hunavsim check corner_cafe_agents", "Check a scenario with its map and trees"},
                {"hunavsim check my_nav2.yaml --nav2-distro humble",
                 "Check a parameter file of Nav2", "your file"}});
}

}  // namespace app
