#include "app/capsule/Pack.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct PackCommandOptions {
  std::string study, output;
  bool withCode = false, force = false;
};

int packCommand(const PackCommandOptions& options, const Invocation& given) {
  requireFine(checkOverwrite(options.output, options.force));
  const capsule::PackOptions pack{options.study, options.output, options.withCode, loadMapImage};
  Progress progress(given.quiet || given.json);
  progress.show("packing " + options.study);
  const base::Result<capsule::PackedStudy> packed = capsule::packStudy(pack);
  requireFine(packed.diagnostics());
  requireFine(recordOutputFile(options.output, "pack"));
  if (given.json) {
    const nlohmann::ordered_json json = {
        {"written", options.output}, {"identity", packed->identity},
        {"bytes", packed->size},     {"files", packed->members},
        {"runs", packed->runs},      {"omitted_code", packed->omittedCode}};
    print(base::jsonText(json) + "\n");
    return ExitFine;
  }
  for (const std::string& code : packed->omittedCode) {
    printError("not packed: " + code + " (--with-code packs it)");
  }
  if (!given.quiet) {
    printLine(options.output + ": " + std::to_string(packed->runs) +
              (packed->runs == 1 ? " run, " : " runs, ") + std::to_string(packed->members) +
              " files, " + std::to_string(packed->size) + " bytes");
    printLine("identity " + packed->identity);
  }
  return ExitFine;
}

}  // namespace

void addPack(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "pack", "Write a study with all its inputs and results as one file", packCommand);
  command.add_option("study", options.study, "Folder of a batch or of a run")->required();
  command.add_option("-o,--output", options.output, "File to write (.hnv)")->required();
  command.add_flag("--with-code", options.withCode,
                   "Also pack planner programs and libraries that the runs started");
  addForce(command, options.force);
  commands.addExamples(
      command, {{"hunavsim pack out -o run.hnv", "Write a run and its scenario as one file"},
                {"hunavsim pack results -o study.hnv", "Write a study as one file",
                 "the folder of a batch"}});
}

}  // namespace app
