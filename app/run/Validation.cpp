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

/// Plays tests one after the other.
class TrackPlayer {
 public:
  explicit TrackPlayer(const ValidationJob& job) : job_(job) {
    for (const RealismTest* test : job.tests) {
      all_ += job.models.size() * seedCount(*test);
    }
  }

  /// False when it was stopped.
  bool play(const RealismTest& test, const std::string& model, std::vector<ValidationRow>& rows) {
    std::vector<std::vector<double>> values(test.quantities.size());
    std::string problem;
    for (std::size_t seed = 1; seed <= seedCount(test) && problem.empty(); ++seed) {
      if (job_.onProgress) {
        job_.onProgress(done_, all_, test.name + ", " + model + ", seed " + std::to_string(seed));
      }
      const base::Result<std::vector<double>> measured =
          test.measure({model, static_cast<long long>(seed), job_.wantsStop});
      if (job_.wantsStop && job_.wantsStop()) {
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
      const sim2d::Quantity& quantity = test.quantities[i];
      rows.push_back(
          {test.name, model, quantity, quantity.summaryOf(values[i]), problem, values[i]});
    }
    return true;
  }

 private:
  std::size_t seedCount(const RealismTest& test) const {
    return test.isSeeded ? static_cast<std::size_t>(job_.seeds) : 1;
  }

  const ValidationJob& job_;
  std::size_t done_ = 0, all_ = 0;
};

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
  Validation validation;
  TrackPlayer player(job);
  for (const RealismTest* test : job.tests) {
    for (const std::string& model : job.models) {
      if (!player.play(*test, model, validation.rows)) {
        validation.isComplete = false;
        return validation;
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
