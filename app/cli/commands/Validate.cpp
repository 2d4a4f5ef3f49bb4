#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Nav2Robots.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/World.h"
#include "sim2d/world/realism/RealismTest.h"

namespace app {

namespace {

struct ValidateOptions {
  std::vector<std::string> names;  // of realism tests; empty: all
  std::vector<std::string> models = {"sfm", "das"};
  std::string output;  // folder, or empty
  int seeds = 10;      // seeds 1 to this number, for tests with random draws
  bool force = false;  // overwrite files not created by hunavsim
};

constexpr const char* kTableFile = "validation.csv";
constexpr const char* kJsonFile = "validation.json";

using Json = nlohmann::ordered_json;
using sim2d::Quantity;
using sim2d::RealismTest;

/// One quantity of one realism test with one model.
struct Row {
  std::string test, model;
  Quantity quantity;
  double value = 0.0;
  std::string problem;         // why there is no value
  std::vector<double> values;  // one per seed

  bool passes() const { return problem.empty() && quantity.passes(value); }
  const char* result() const { return passes() ? "PASS" : "FAIL"; }
  const char* summary() const {
    constexpr const char* kNames[] = {"mean", "smallest", "largest"};  // of Summary
    return kNames[static_cast<int>(quantity.summary)];
  }
};

std::string csvOf(const std::vector<Row>& rows) {
  std::string text = "test,model,quantity,unit,summary,seeds,value,least,most,result\n";
  const auto number = [](double value) {
    return std::isfinite(value) ? base::formatDouble(value) : std::string();
  };
  for (const Row& row : rows) {
    text += base::join({row.test, row.model, "\"" + row.quantity.name + "\"", row.quantity.unit,
                        row.summary(), std::to_string(row.values.size()), number(row.value),
                        number(row.quantity.least), number(row.quantity.most), row.result()},
                       ",") +
            "\n";
  }
  return text;
}

std::string jsonOf(const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows) {  // numbers that are not finite become null
    all.push_back({{"name", row.test},
                   {"model", row.model},
                   {"quantity", row.quantity.name},
                   {"unit", row.quantity.unit},
                   {"summary", row.summary()},
                   {"seeds", row.values.size()},
                   {"value", row.value},
                   {"least", row.quantity.least},
                   {"most", row.quantity.most},
                   {"pass", row.passes()}});
    for (const double value : row.values) {
      all.back()["values"].push_back(value);
    }
    if (!row.problem.empty()) {
      all.back()["why"] = row.problem;
    }
  }
  return base::jsonText(all);
}

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

void printRows(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> table = {
      {"", "test", "model", "quantity", "value", "limit", "unit", ""}};
  for (const Row& row : rows) {
    const std::string value = rounded(row.value);
    table.push_back({row.result(), row.test, row.model, row.quantity.name,
                     value.empty() ? "none" : value, limitText(row.quantity), row.quantity.unit,
                     row.problem});
  }
  printTable(table);
}

/// The selected tests; throws CommandEnd for unknown names of tests or models.
std::vector<const RealismTest*> chosenTests(const ValidateOptions& options) {
  const std::vector<std::string> known = builtinRegistries().models.names();
  base::Diagnostics wrong;
  for (const std::string& model : options.models) {
    if (std::find(known.begin(), known.end(), model) == known.end()) {
      wrong.push_back(base::error(
          "option.unknown-name",
          {"--model", model, base::nearestName(model, known), base::join(known, ", ")}));
    }
  }
  std::vector<std::string> names;
  std::map<std::string, const RealismTest*> byName;
  for (const RealismTest& test : sim2d::realismTests()) {
    names.push_back(test.name);
    byName[test.name] = &test;
  }
  std::vector<const RealismTest*> tests;
  for (const std::string& name : options.names.empty() ? names : options.names) {
    const auto found = byName.find(name);
    if (found == byName.end()) {
      wrong.push_back(base::error(
          "option.unknown-name",
          {"realism tests", name, base::nearestName(name, names), base::join(names, ", ")}));
    } else {
      tests.push_back(found->second);
    }
  }
  requireFine(wrong, ExitWrongCommandLine);
  return tests;
}

/// Runs the tests and shows the progress. False: interrupted.
bool runTests(const std::vector<const RealismTest*>& tests, const ValidateOptions& options,
              bool quiet, std::vector<Row>& rows) {
  const auto seedsOf = [&options](const RealismTest& test) {
    return test.isSeeded ? options.seeds : 1;
  };
  std::size_t done = 0, all = 0;
  for (const RealismTest* test : tests) {
    all += options.models.size() * static_cast<std::size_t>(seedsOf(*test));
  }
  Progress progress(quiet);
  const auto begin = std::chrono::steady_clock::now();
  const auto showProgress = [&](const std::string& next) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const double left = spent.count() / static_cast<double>(done) * static_cast<double>(all - done);
    progress.show(std::to_string(done) + "/" + std::to_string(all) + " " + next +
                  (done > 0 ? ", " + durationText(left) + " left" : ""));
  };
  // False: interrupted.
  const auto runTest = [&](const RealismTest& test, const std::string& model) {
    std::vector<std::vector<double>> values(test.quantities.size());
    std::string problem;
    for (int seed = 1; seed <= seedsOf(test) && problem.empty(); ++seed) {
      showProgress(test.name + ", " + model + ", seed " + std::to_string(seed));
      const base::Result<std::vector<double>> measured =
          test.measure({model, seed, wasInterrupted});
      if (wasInterrupted()) {
        return false;
      }
      ++done;
      if (!measured) {
        problem = measured.diagnostics().front().message;
      }
      for (std::size_t i = 0; measured && i < values.size(); ++i) {
        values[i].push_back((*measured)[i]);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Quantity& quantity = test.quantities[i];
      rows.push_back(
          {test.name, model, quantity, quantity.summaryOf(values[i]), problem, values[i]});
    }
    return true;
  };
  return std::all_of(tests.begin(), tests.end(), [&](const RealismTest* test) {
    return std::all_of(options.models.begin(), options.models.end(),
                       [&](const std::string& model) { return runTest(*test, model); });
  });
}

/// Opens the output folder before the tests, so that errors appear early; null: no output.
std::unique_ptr<OutputFolder> openOutput(const ValidateOptions& options) {
  if (options.output.empty()) {
    return nullptr;
  }
  base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(options.output, options.force, Manifest::kHiddenName);
  requireFine(output.diagnostics());
  requireFine((*output)->conflictingFiles({kTableFile, kJsonFile}));
  return *std::move(output);
}

base::Diagnostics writeRows(const std::vector<Row>& rows, OutputFolder& output) {
  base::Diagnostics problems = output.write(kTableFile, csvOf(rows));
  base::append(problems, output.write(kJsonFile, jsonOf(rows) + "\n"));
  return base::hasErrors(problems) ? problems
                                   : output.commit(base::jsonText(Json{{"kind", "validation"}}),
                                                   OutputFolder::EarlierFiles::Kept);
}

int validateCommand(const ValidateOptions& options, const Invocation& given) {
  const std::vector<const RealismTest*> tests = chosenTests(options);
  catchInterrupts();
  const std::unique_ptr<OutputFolder> output = openOutput(options);
  std::vector<Row> rows;
  const bool isComplete = runTests(tests, options, given.quiet, rows);
  if (given.json) {
    print(jsonOf(rows) + "\n");
  } else if (!given.quiet) {
    printRows(rows);
  }
  if (output != nullptr && !printDiagnostics(writeRows(rows, *output))) {
    return ExitBadInput;
  }
  if (!isComplete) {
    printError("interrupted: " + std::to_string(rows.size()) + " rows are complete");
    return ExitRunFailed;
  }
  const auto passed =
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.passes(); });
  if (!given.json && !given.quiet) {
    printLine(std::to_string(passed) + " of " + std::to_string(rows.size()) + " within the limits");
  }
  return static_cast<std::size_t>(passed) < rows.size() ? ExitRunFailed : ExitFine;
}

}  // namespace

void addValidate(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "validate", "Run realism tests: compare pedestrian models with real people", validateCommand);
  command.add_option("names", options.names, "Realism tests to run (default: all)");
  addOutputFolder(command, options.output, "Output folder (default: write no files)");
  addForce(command, options.force);
  command.add_option("--seeds", options.seeds, "Use seeds 1 to N (default: 10)")
      ->check(CLI::Range(1, 10000));
  command.add_option("--model", options.models, "Models to test (default: sfm and das)")
      ->allow_extra_args(false);
  commands.addExamples(command, {{"hunavsim validate rimea-1 --model sfm --seeds 1",
                                  "Run one realism test of one model"}});
}

}  // namespace app
