#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/TreePictureFile.h"
#include "app/run/DataPaths.h"
#include "app/run/Export.h"
#include "app/run/OutputFolder.h"
#include "app/run/TreeCoverage.h"
#include "app/run/TreePlay.h"
#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

struct TreesOptions {
  std::string scenario;             // scenario for generated trees, tree file to draw, or empty
  std::string output;               // -o; empty: standard output
  std::string style = "corrected";  // corrected, hunav2
  std::string play;                 // tree file to play, or empty
  std::string script;               // results of its leaves; empty: SUCCESS
  int ticks = 10;
  double dt = 0.05;  // [s]
  long long seed = 1;
  std::string compat;    // quirks of the original while playing
  bool force = false;    // overwrite files not created by hunavsim
  std::string picture;   // file of the picture of a tree, or empty
  std::string coverage;  // folder of a batch whose coverage is drawn, or empty
  std::string agent;     // name or id of the agent whose tree is drawn; empty: the only one
};

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bt::TreeStyle styleOf(const TreesOptions& options) {
  return options.style == "hunav2" ? bt::TreeStyle::Hunav2 : bt::TreeStyle::Corrected;
}

/// A generated tree file: of an agent, or the one that all include.
struct GeneratedFile {
  std::string name;
  std::optional<int> agent;
  std::string text;
};

std::vector<GeneratedFile> makeFiles(const sim2d::Scenario& scenario, const std::string& base,
                                     bt::TreeStyle style) {
  const bt::NodeLibrary library = bt::humanNodes();
  std::vector<GeneratedFile> files;
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed) {
      files.push_back({bt::treeFileName(base, human.id), human.id,
                       bt::makeTreeText(scenario, human, style, library.catalogue())});
    }
  }
  files.push_back({bt::kRegularNavFile, std::nullopt, bt::regularNavText(library.catalogue())});
  return files;
}

/// File names consist of the base name and the ids: they must stay inside the folder and be unique.
base::Diagnostics checkNames(const std::string& base, const std::vector<GeneratedFile>& files,
                             const std::string& scenario) {
  if (base.empty() || base.find('/') != std::string::npos || base.find('\0') != std::string::npos) {
    return {base::error("option.bad-base-name", {base}, scenario)};
  }
  base::Diagnostics problems;
  std::set<std::string> seen;
  for (const GeneratedFile& file : files) {
    if (!seen.insert(file.name).second) {
      problems.push_back(base::error("option.id-twice", {file.agent.value_or(0)}, scenario));
    }
  }
  return problems;
}

Json agentJson(const GeneratedFile& file) {
  return file.agent ? Json(*file.agent) : Json();
}

void printFiles(const std::vector<GeneratedFile>& files, const Invocation& given) {
  Json all = Json::array();
  for (const GeneratedFile& file : files) {
    if (given.json) {
      all.push_back({{"file", file.name}, {"agent", agentJson(file)}, {"text", file.text}});
    } else {
      print("==> " + base::escapedControls(file.name) + " <==\n" + file.text +
            (file.agent ? "\n" : ""));
    }
  }
  if (given.json) {
    print(base::jsonText(all) + "\n");
  }
}

/// Writes all files or none; prints the state of each.
int writeFiles(const std::vector<GeneratedFile>& files, const TreesOptions& options,
               const Invocation& given) {
  Json all = Json::array();
  std::vector<base::FileContent> contents;
  for (const GeneratedFile& file : files) {
    const std::string path = (fs::path(options.output) / file.name).string();
    const std::string state = fileStateName(fileStateOf(path, file.text));
    contents.push_back({file.name, file.text});
    all.push_back({{"file", path}, {"agent", agentJson(file)}, {"state", state}});
  }
  requireFine(writeIntoForeignFolder(options.output, contents, "trees", options.force));
  for (const Json& file : given.json || given.quiet ? Json::array() : all) {
    std::string line = file["state"].get<std::string>();
    line.resize(10, ' ');
    printLine(line + file["file"].get<std::string>());
  }
  if (given.json) {
    print(base::jsonText(all) + "\n");
  }
  return ExitFine;
}

int generate(const TreesOptions& options, const Invocation& given) {
  const sim2d::ScenarioReading reading = sim2d::readScenario(options.scenario);
  requireFine(reading.diagnostics, ExitBadInput, base::Severity::Warning);
  const std::string base = sim2d::baseName(reading.scenario, options.scenario);
  const std::vector<GeneratedFile> files = makeFiles(reading.scenario, base, styleOf(options));
  requireFine(checkNames(base, files, options.scenario));
  if (options.output.empty()) {
    printFiles(files, given);
    return ExitFine;
  }
  return writeFiles(files, options, given);
}

bool isTreeFile(const std::string& path) {
  return base::toLower(fs::path(path).extension().string()) == ".xml";
}

/// The agent of --agent, by name or id; without it, the only one.
const sim2d::Human& drawnAgent(const sim2d::Scenario& scenario, const TreesOptions& options) {
  std::vector<const sim2d::Human*> agents;
  std::vector<std::string> names;
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed) {
      agents.push_back(&human);
      names.push_back(human.name);
    }
  }
  if (options.agent.empty() && agents.size() != 1) {
    requireFine(
        {agents.empty() ? base::error("trees.no-agents", {}, options.scenario)
                        : base::error("trees.picture-of-whom",
                                      {agents.size(), base::join(names, ", ")}, options.scenario)},
        agents.empty() ? ExitBadInput : ExitWrongCommandLine);
  }
  const auto found = std::find_if(agents.begin(), agents.end(), [&](const sim2d::Human* each) {
    return options.agent.empty() || each->name == options.agent ||
           std::to_string(each->id) == options.agent;
  });
  if (found == agents.end()) {
    requireFine(
        {base::error("trees.unknown-agent",
                     {options.agent, base::nearestName(options.agent, names)}, options.scenario)},
        ExitWrongCommandLine);
  }
  return **found;
}

/// The trees of a file, or those that the generator makes for an agent.
bt::TreeTable tableToDraw(const TreesOptions& options) {
  if (isTreeFile(options.scenario)) {
    const base::Result<bt::TreeTable> table = bt::loadAgentTrees(bt::readTree(options.scenario));
    requireFine(table.diagnostics());
    return *table;
  }
  const sim2d::ScenarioReading reading = sim2d::readScenario(options.scenario);
  requireFine(reading.diagnostics, ExitBadInput, base::Severity::Warning);
  const bt::NodeLibrary library = bt::humanNodes();
  const std::string text = bt::makeTreeText(reading.scenario, drawnAgent(reading.scenario, options),
                                            styleOf(options), library.catalogue());
  const base::Result<bt::TreeTable> table = bt::loadAgentTrees(bt::readTreeText(text));
  requireFine(table.diagnostics());
  return *table;
}

int draw(const TreesOptions& options, const Invocation& given) {
  if (const std::optional<base::Diagnostic> unknown = unknownTreePicture(options.picture)) {
    requireFine({*unknown}, ExitWrongCommandLine);
  }
  base::Result<std::string> bytes = std::string();
  if (options.coverage.empty()) {
    bytes = treePictureBytes(tableToDraw(options), options.picture);
  } else {
    const auto coverage =
        readTreeCoverage((fs::path(options.coverage) / kTreeCoverageFile).string());
    requireFine(coverage.diagnostics());
    bytes = treePictureBytes(tableToDraw(options), options.picture, *coverage);
  }
  requireFine(bytes.diagnostics());
  requireFine(writeFile(options.picture, *bytes, options.force));
  requireFine(recordOutputFile(options.picture, "trees"));
  if (given.json) {
    print(base::jsonText(Json{{"written", {options.picture}}}) + "\n");
  } else if (!given.quiet) {
    printLine(options.picture);
  }
  return ExitFine;
}

const char* statusText(const LeafCall& call) {
  return call.isHalt ? "HALTED" : base::nodeStatusName(call.status);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text + "  ";
}

Json jsonOf(const TreePlay& play, int tick, double dt, base::NodeStatus root) {
  Json leaves = Json::array();
  for (const LeafCall& call : play.calls()) {
    const bt::Program& program = play.program();
    leaves.push_back({{"name", program.label(call.node)},
                      {"id", program.manifest(call.node).id},
                      {"path", program.path(call.node)},
                      {"status", statusText(call)}});
  }
  return {{"tick", tick},
          {"time", tick * dt},
          {"root", base::nodeStatusName(root)},
          {"leaves", std::move(leaves)}};
}

std::string leavesText(const TreePlay& play) {
  std::vector<std::string> leaves;
  for (const LeafCall& call : play.calls()) {
    leaves.push_back(play.program().label(call.node) + " " + statusText(call));
  }
  return base::join(leaves, ", ");
}

/// Ticks the tree and prints each tick, as a table or, at the end, as JSON; returns the error that
/// stopped it.
base::Diagnostics tickAll(TreePlay& tree, const TreesOptions& options, const Invocation& given) {
  const bool isTable = !given.json && !given.quiet;
  const std::size_t width = std::max<std::size_t>(4, std::to_string(options.ticks).size());
  const auto printRow = [width](const std::string& tick, const char* root,
                                const std::string& leaves) {
    const std::string line = padded(tick, width) + padded(root, 7) + leaves;
    printLine(line.substr(0, line.find_last_not_of(' ') + 1));
  };
  if (isTable) {
    printRow("tick", "root", "leaves");
  }
  Json ticks = Json::array();
  base::Diagnostics fault;
  for (int tick = 1; tick <= options.ticks && fault.empty(); ++tick) {
    const base::NodeStatus root = tree.tick();
    if (given.json) {
      ticks.push_back(jsonOf(tree, tick, options.dt, root));
    } else if (isTable) {
      printRow(std::to_string(tick), base::nodeStatusName(root), leavesText(tree));
    }
    fault = tree.fault();
  }
  if (given.json) {
    print(base::jsonText(ticks) + "\n");
  }
  return fault;
}

int play(const TreesOptions& options, const Invocation& given) {
  PlaySetup setup;
  setup.tree = options.play;
  setup.script = options.script;
  setup.dt = options.dt;
  setup.seed = static_cast<std::uint64_t>(options.seed);
  if (!options.compat.empty()) {
    const base::Result<sim2d::Compatibility> chosen = sim2d::Compatibility::parse(options.compat);
    requireFine(chosen.diagnostics(), ExitWrongCommandLine);
    setup.compatibility = *chosen;
  }
  const base::Result<std::unique_ptr<TreePlay>> made = TreePlay::create(setup);
  requireFine(made.diagnostics(), ExitBadInput, base::Severity::Warning);
  const base::Diagnostics fault = tickAll(**made, options, given);
  printDiagnostics(fault);
  return fault.empty() ? ExitFine : ExitRunFailed;
}

int treesCommand(const TreesOptions& options, const Invocation& given) {
  if (options.scenario.empty() == options.play.empty()) {
    requireFine({base::error("trees.no-scenario")}, ExitWrongCommandLine);
  }
  if (!std::isfinite(options.dt) || options.dt <= 0.0 || options.dt > 10.0) {
    requireFine({base::error("trees.bad-dt")}, ExitWrongCommandLine);
  }
  if (!options.play.empty()) {
    return play(options, given);
  }
  if (options.picture.empty() && isTreeFile(options.scenario)) {
    requireFine({base::error("trees.only-picture", {}, options.scenario)}, ExitWrongCommandLine);
  }
  if (const std::optional<base::Diagnostic> unknown = unknownScenario(options.scenario)) {
    requireFine({*unknown}, ExitBadInput);
  }
  return options.picture.empty() ? generate(options, given) : draw(options, given);
}

Drawing drawingOf(const TreesOptions& options) {
  return options.picture.empty() ? Drawing::None : Drawing::Pictures;
}

}  // namespace

void addTrees(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("trees", "Generate the behaviour trees of agents, draw or tick a tree",
                   treesCommand, drawingOf);
  CLI::Option* scenario = command
                              .add_option("scenario", options.scenario,
                                          "Scenario file; with --picture also a tree file (.xml)")
                              ->transform(scenarioFile);
  CLI::Option* output =
      &addOutputFolder(command, options.output, "Output folder (default: print the trees)");
  addForce(command, options.force);
  CLI::Option* style =
      command.add_option("--style", options.style, "Tree style: corrected or hunav2");
  style->check(oneOf({"corrected", "hunav2"}));
  CLI::Option* play =
      command.add_option("--play", options.play, "Tree file to tick with scripted leaves");
  play->excludes(scenario)->excludes(output)->excludes(style);
  CLI::Option* picture = command.add_option(
      "--picture", options.picture,
      "Draw the tree of an agent, or a tree file, with all subtrees expanded (.svg, .pdf, .png)");
  picture->excludes(play)->excludes(output);
  command.add_option("--agent", options.agent, "Agent whose tree is drawn: name or id")
      ->needs(picture);
  command
      .add_option("--coverage", options.coverage,
                  "Draw which nodes were executed in this batch (tree_coverage: true)")
      ->needs(picture);
  command.add_option("--script", options.script, "YAML file: leaf -> statuses of its calls")
      ->needs(play);
  command.add_option("--ticks", options.ticks, "Number of ticks (default: 10)")
      ->needs(play)
      ->check(CLI::Range(1, 1000000));
  command.add_option("--dt", options.dt, "Time step [s] (default: 0.05)")->needs(play);
  command.add_option("--seed", options.seed, "Seed of random numbers in the tree (default: 1)")
      ->needs(play)
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--compat", options.compat,
                  "Reproduce quirks of HuNavSim 2.0: hunav2 (all), or a list: Q-20")
      ->needs(play);
  commands.addExamples(command, {{"hunavsim trees corner_cafe_agents -o trees",
                                  "Write the generated behaviour tree of each person"}});
}

}  // namespace app
