#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Validation.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/World.h"

namespace app {

namespace {

struct ValidateOptions {
  std::vector<std::string> names;  // of realism tests; empty: all
  std::vector<std::string> models = {"sfm", "das"};
  std::string output;  // folder, or empty
  int seeds = 10;
};

using sim2d::Quantity;
using sim2d::RealismTest;

std::string rounded(double value) {
  return std::isfinite(value) ? base::formatDouble(std::round(value * 1e4) / 1e4) : "";
}

std::string limitText(const Quantity& quantity) {
  if (std::isfinite(quantity.least) && std::isfinite(quantity.most)) {
    return rounded(quantity.least) + " to " + rounded(quantity.most);
  }
  return std::isfinite(quantity.least) ? "at least " + rounded(quantity.least)
                                       : "at most " + rounded(quantity.most);
}

std::vector<std::string> cellsOf(const ValidationRow& row) {
  const std::string value = rounded(row.value);
  return {row.passes() ? "PASS" : "FAIL",
          row.test,
          row.model,
          row.quantity.name,
          value.empty() ? "none" : value,
          limitText(row.quantity),
          row.quantity.unit,
          row.problem};
}

bool choose(const ValidateOptions& options, std::vector<const RealismTest*>& tests,
            std::vector<std::string>& models) {
  const std::vector<std::string> known = sim2d::programRegistries().models.names();
  bool isFine = true;
  for (const std::string& model : models) {
    if (std::find(known.begin(), known.end(), model) == known.end()) {
      printError("no model '" + model + "' (see hunavsim list models)");
      isFine = false;
    }
  }
  std::vector<std::string> names;
  std::map<std::string, const RealismTest*> byName;
  for (const RealismTest& test : sim2d::realismTests()) {
    names.push_back(test.name);
    byName[test.name] = &test;
  }
  for (const std::string& name : options.names.empty() ? names : options.names) {
    const auto found = byName.find(name);
    if (found == byName.end()) {
      printError("no realism test '" + name + "' (there are " + base::join(names, ", ") + ")");
      isFine = false;
    } else {
      tests.push_back(found->second);
    }
  }
  return isFine;
}

/// Tells how far it is.
Validation play(ValidationJob job, bool quiet) {
  Progress progress(quiet);
  const auto begin = std::chrono::steady_clock::now();
  job.onProgress = [&](std::size_t done, std::size_t all, const std::string& next) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const double left = spent.count() / static_cast<double>(done) * static_cast<double>(all - done);
    progress.show(std::to_string(done) + "/" + std::to_string(all) + " " + next +
                  (done > 0 ? ", " + durationText(left) + " left" : ""));
  };
  return runValidation(job);
}

int validateCommand(const ValidateOptions& options, const OutputOptions& output) {
  ValidationJob job;
  job.models = options.models;
  job.seeds = options.seeds;
  job.wantsStop = wasInterrupted;
  if (!choose(options, job.tests, job.models)) {
    return kWrongCommandLine;
  }
  catchInterrupts();
  const Validation validation = play(std::move(job), output.quiet);
  const std::vector<ValidationRow>& rows = validation.rows;
  if (output.json) {
    printLine(validationJson(rows));
  } else if (!output.quiet) {
    std::vector<std::vector<std::string>> table = {
        {"", "test", "model", "quantity", "value", "limit", "unit", ""}};
    std::transform(rows.begin(), rows.end(), std::back_inserter(table), cellsOf);
    printTable(table);
  }
  if (!options.output.empty()) {
    const base::Diagnostics problems = writeValidation(options.output, rows);
    if (!printDiagnostics(problems)) {
      return kBadInput;
    }
  }
  const auto failed = std::count_if(rows.begin(), rows.end(),
                                    [](const ValidationRow& row) { return !row.passes(); });
  if (!validation.isComplete) {
    printError("interrupted: " + std::to_string(rows.size()) + " rows are complete");
    return kRunFailed;
  }
  if (!output.json && !output.quiet) {
    printLine(std::to_string(rows.size() - static_cast<std::size_t>(failed)) + " of " +
              std::to_string(rows.size()) + " within the limits");
  }
  return failed > 0 ? kRunFailed : kFine;
}

}  // namespace

void addValidate(CommandRegistry& commands) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App& command = commands.add(
      "validate", "Realism tests: people of the models against real ones",
      [options](const Invocation& given) { return validateCommand(*options, given.output); });
  command.add_option("names", options->names, "Realism tests (all)");
  command.add_option("-o,--output", options->output, "Folder for the results");
  command.add_option("--seeds", options->seeds, "Runs with seeds 1 to N (10)")
      ->check(CLI::Range(1, 10000));
  command.add_option("--model", options->models, "Models to test (sfm and das)")
      ->allow_extra_args(false);
}

}  // namespace app
