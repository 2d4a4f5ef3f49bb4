#include "app/run/Validation.h"

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using sim2d::RealismTest;

const char* summaryName(const ValidationRow& row) {
  constexpr const char* kNames[] = {"mean", "smallest", "largest"};  // of Summary
  return kNames[static_cast<int>(row.quantity.summary)];
}

std::string csvOf(const std::vector<ValidationRow>& rows) {
  std::string text = "test,model,quantity,unit,summary,seeds,value,least,most,result\n";
  const auto number = [](double value) {
    return std::isfinite(value) ? base::formatDouble(value) : std::string();
  };
  for (const ValidationRow& row : rows) {
    text += row.test + "," + row.model + ",\"" + row.quantity.name + "\"," + row.quantity.unit +
            "," + summaryName(row) + "," + std::to_string(row.values.size()) + "," +
            number(row.value) + "," + number(row.quantity.least) + "," + number(row.quantity.most) +
            "," + (row.passes() ? "PASS" : "FAIL") + "\n";
  }
  return text;
}

}  // namespace

Validation runValidation(const ValidationJob& job) {
  const auto seedsOf = [&job](const RealismTest& test) { return test.isSeeded ? job.seeds : 1; };
  std::size_t done = 0, all = 0;
  for (const RealismTest* test : job.tests) {
    all += job.models.size() * static_cast<std::size_t>(seedsOf(*test));
  }
  Validation validation;
  // Plays a test with a model; false when it was stopped.
  const auto play = [&](const RealismTest& test, const std::string& model) {
    std::vector<std::vector<double>> values(test.quantities.size());
    std::string problem;
    for (int seed = 1; seed <= seedsOf(test) && problem.empty(); ++seed) {
      if (job.onProgress) {
        job.onProgress(done, all, test.name + ", " + model + ", seed " + std::to_string(seed));
      }
      const base::Result<std::vector<double>> measured = test.measure({model, seed, job.wantsStop});
      if (job.wantsStop && job.wantsStop()) {
        return false;
      }
      ++done;
      if (!measured) {
        problem = measured.diagnostics().empty() ? "failed" : measured.diagnostics()[0].message;
      }
      for (std::size_t i = 0; measured && i < values.size(); ++i) {
        values[i].push_back((*measured)[i]);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const sim2d::Quantity& quantity = test.quantities[i];
      validation.rows.push_back(
          {test.name, model, quantity, quantity.summaryOf(values[i]), problem, values[i]});
    }
    return true;
  };
  for (const RealismTest* test : job.tests) {
    for (const std::string& model : job.models) {
      if (validation.isComplete && !play(*test, model)) {
        validation.isComplete = false;
      }
    }
  }
  return validation;
}

std::string validationJson(const std::vector<ValidationRow>& rows) {
  Json all = Json::array();
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  for (const ValidationRow& row : rows) {
    all.push_back({{"name", row.test},
                   {"model", row.model},
                   {"quantity", row.quantity.name},
                   {"unit", row.quantity.unit},
                   {"summary", summaryName(row)},
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
  return all.dump(2);
}

base::Diagnostics writeValidation(const std::string& folder,
                                  const std::vector<ValidationRow>& rows) {
  std::error_code ignored;  // an impossible folder shows when the files are written
  std::filesystem::create_directories(folder, ignored);
  base::Diagnostics problems = base::writeFileAtomically(folder + "/validation.csv", csvOf(rows));
  base::append(problems,
               base::writeFileAtomically(folder + "/validation.json", validationJson(rows) + "\n"));
  return problems;
}

}  // namespace app
