#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/CommandLine.h"
#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/World.h"
#include "sim2d/world/realism/RealismTest.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using sim2d::Quantity;
using sim2d::RealismTest;

/// One line of the table.
struct Row {
  std::string test, model;
  Quantity quantity;
  double value = 0.0;
  std::string problem;         // why there is no value
  std::vector<double> values;  // one per seed
  bool passes() const { return problem.empty() && quantity.passes(value); }
};

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

const char* summaryName(sim2d::Summary summary) {
  switch (summary) {
    case sim2d::Summary::Smallest:
      return "smallest";
    case sim2d::Summary::Largest:
      return "largest";
    case sim2d::Summary::Mean:
      break;
  }
  return "mean";
}

/// Plays tests one after the other and tells how far it is.
class Validation {
 public:
  Validation(const ValidateOptions& options, bool quiet)
      : seeds_(options.seeds), progress_(quiet), begin_(std::chrono::steady_clock::now()) {}

  void plan(const std::vector<const RealismTest*>& tests, std::size_t models) {
    for (const RealismTest* test : tests) {
      total_ += models * seedCount(*test);
    }
  }

  /// False when the user stopped it.
  bool play(const RealismTest& test, const std::string& model) {
    std::vector<std::vector<double>> values(test.quantities.size());
    std::string problem;
    for (std::size_t seed = 1; seed <= seedCount(test) && problem.empty(); ++seed) {
      show(test.name + ", " + model + ", seed " + std::to_string(seed));
      const base::Result<std::vector<double>> measured =
          test.measure({model, static_cast<long long>(seed), wasInterrupted});
      if (wasInterrupted()) {
        return false;
      }
      ++done_;
      if (!measured) {
        problem = measured.diagnostics().empty() ? "failed" : measured.diagnostics()[0].message;
        continue;
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i].push_back((*measured)[i]);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Quantity& quantity = test.quantities[i];
      rows_.push_back(
          {test.name, model, quantity, quantity.summaryOf(values[i]), problem, values[i]});
    }
    return true;
  }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::size_t seedCount(const RealismTest& test) const {
    return test.isSeeded ? static_cast<std::size_t>(seeds_) : 1;
  }

  void show(const std::string& what) {
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double done = static_cast<double>(done_);
    const double left = done_ > 0 ? spent / done * (static_cast<double>(total_) - done) : 0.0;
    const std::string rest = done_ > 0 ? ", " + durationText(left) + " left" : "";
    progress_.show(std::to_string(done_) + "/" + std::to_string(total_) + " " + what + rest);
  }

  int seeds_;
  Progress progress_;
  std::chrono::steady_clock::time_point begin_;
  std::size_t done_ = 0, total_ = 0;
  std::vector<Row> rows_;
};

std::vector<std::string> cellsOf(const Row& row) {
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

void printTable(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> lines = {
      {"", "test", "model", "quantity", "value", "limit", "unit", ""}};
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const Row& row : rows) {
    lines.push_back(cellsOf(row));
  }
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  for (const std::vector<std::string>& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += line[i] + std::string(widths[i] - line[i].size() + 2, ' ');
    }
    printLine(text.substr(0, text.find_last_not_of(' ') + 1));
  }
}

Json jsonOf(const std::vector<Row>& rows) {
  Json all = Json::array();
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  for (const Row& row : rows) {
    all.push_back({{"name", row.test},
                   {"model", row.model},
                   {"quantity", row.quantity.name},
                   {"unit", row.quantity.unit},
                   {"summary", summaryName(row.quantity.summary)},
                   {"seeds", row.values.size()},
                   {"value", number(row.value)},
                   {"least", number(row.quantity.least)},
                   {"most", number(row.quantity.most)},
                   {"pass", row.passes()}});
    for (const double value : row.values) {
      all.back()["values"].push_back(number(value));
    }
    if (!row.problem.empty()) {
      all.back()["why"] = row.problem;
    }
  }
  return all;
}

std::string csvOf(const std::vector<Row>& rows) {
  std::string text = "test,model,quantity,unit,summary,seeds,value,least,most,result\n";
  const auto number = [](double value) {
    return std::isfinite(value) ? base::formatDouble(value) : std::string();
  };
  for (const Row& row : rows) {
    text += row.test + "," + row.model + ",\"" + row.quantity.name + "\"," + row.quantity.unit +
            "," + summaryName(row.quantity.summary) + "," + std::to_string(row.values.size()) +
            "," + number(row.value) + "," + number(row.quantity.least) + "," +
            number(row.quantity.most) + "," + (row.passes() ? "PASS" : "FAIL") + "\n";
  }
  return text;
}

/// The tests and models by their names; tells what does not exist.
bool choose(const ValidateOptions& options, std::vector<const RealismTest*>& tests,
            std::vector<std::string>& models) {
  const std::vector<std::string> known = sim2d::modelNames();
  bool isFine = true;
  for (const std::string& model : models) {
    if (std::find(known.begin(), known.end(), model) == known.end()) {
      printError("no model '" + model + "' (see hunavsim list models)");
      isFine = false;
    }
  }
  std::string names;
  for (const RealismTest& test : sim2d::realismTests()) {
    names += (names.empty() ? "" : ", ") + test.name;
    if (options.names.empty()) {
      tests.push_back(&test);
    }
  }
  for (const std::string& name : options.names) {
    const auto& all = sim2d::realismTests();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const RealismTest& test) { return test.name == name; });
    if (found == all.end()) {
      printError("no realism test '" + name + "' (there are " + names + ")");
      isFine = false;
    } else {
      tests.push_back(&*found);
    }
  }
  return isFine;
}

bool writeResults(const std::string& folder, const std::vector<Row>& rows) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  base::Diagnostics problems;
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"validation.csv", csvOf(rows)},
        std::pair<std::string, std::string>{"validation.json", jsonOf(rows).dump(2) + "\n"}}) {
    const base::Diagnostics written = base::writeFileAtomically(folder + "/" + name, text);
    problems.insert(problems.end(), written.begin(), written.end());
  }
  printDiagnostics(problems);
  return !base::hasErrors(problems);
}

}  // namespace

int validateCommand(const ValidateOptions& options, const OutputOptions& output) {
  std::vector<const RealismTest*> tests;
  std::vector<std::string> models = options.models;
  if (!choose(options, tests, models)) {
    return kWrongCommandLine;
  }
  catchInterrupts();
  Validation validation(options, output.quiet);
  validation.plan(tests, models.size());
  bool isComplete = true;
  for (std::size_t i = 0; i < tests.size() && isComplete; ++i) {
    for (std::size_t k = 0; k < models.size() && isComplete; ++k) {
      isComplete = validation.play(*tests[i], models[k]);
    }
  }
  const std::vector<Row>& rows = validation.rows();
  if (output.json) {
    printLine(jsonOf(rows).dump(2));
  } else if (!output.quiet) {
    printTable(rows);
  }
  if (!options.output.empty() && !writeResults(options.output, rows)) {
    return kBadInput;
  }
  const auto failed =
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.passes(); });
  if (!isComplete) {
    printError("interrupted: " + std::to_string(rows.size()) + " rows are complete");
    return kRunFailed;
  }
  if (!output.json && !output.quiet) {
    printLine(std::to_string(rows.size() - static_cast<std::size_t>(failed)) + " of " +
              std::to_string(rows.size()) + " within the limits");
  }
  return failed > 0 ? kRunFailed : kFine;
}

}  // namespace app
