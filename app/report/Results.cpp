#include "app/report/Results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace report {

namespace {

constexpr std::size_t kMaxProblems = 10;
constexpr double kUndefinedValue = std::numeric_limits<double>::quiet_NaN();

class ResultsReader {
 public:
  ResultsReader(const std::string& text, std::string file)
      : reader_(text), file_(std::move(file)) {}

  base::Result<Results> read() {
    if (!readColumns()) {
      return problems_;
    }
    sim2d::CsvRow row;
    sim2d::CsvField last;  // the reader returns no row at the end
    while (problems_.size() < kMaxProblems && nextRow(row)) {
      readRow(row);
      last = row.back();
    }
    if (problems_.empty() && reader_.isTruncated()) {
      addProblem(last, "trace.cut-line");
    }
    if (problems_.empty() && results_.runs.empty()) {
      problems_.push_back(base::error("report.no-runs", {}, file_));
    }
    if (!problems_.empty()) {
      return problems_;
    }
    return std::move(results_);
  }

 private:
  void addProblem(const sim2d::CsvField& field, std::string_view code,
                  base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_, field.line, field.column));
  }

  /// Columns: run,scenario,seed,<value paths>,status,reason,simulated,<metric keys>
  bool nextRow(sim2d::CsvRow& row) {
    const bool hasRow = reader_.next(row);
    for (sim2d::CsvField& field : row) {
      sim2d::removeFormulaMark(field.text);
    }
    return hasRow;
  }

  bool readColumns() {
    sim2d::CsvRow row;
    const bool hasRow = nextRow(row);
    const auto is = [&row](std::size_t at, const char* name) {
      return at < row.size() && row[at].text == name;
    };
    const auto status = std::find_if(row.begin(), row.end(), [](const sim2d::CsvField& field) {
      return field.text == "status";
    });
    status_ = static_cast<std::size_t>(status - row.begin());
    if (!hasRow || !is(0, "run") || !is(1, "scenario") || !is(2, "seed") || status_ < kFixed ||
        !is(status_ + 1, "reason") || !is(status_ + 2, "simulated")) {
      problems_.push_back(base::error("report.columns", {}, file_, 1, 1));
      return false;
    }
    std::set<std::string> known;
    for (std::size_t at = kFixed; at < row.size(); ++at) {
      if (!known.insert(row[at].text).second || row[at].text.empty()) {
        addProblem(row[at], "report.column-twice", {row[at].text});
      }
      if (at < status_) {
        results_.paths.push_back(row[at].text);
      } else if (at > status_ + 2) {
        results_.keys.push_back(row[at].text);
      }
    }
    columns_ = row.size();
    results_.metrics.resize(results_.keys.size());
    results_.isBoolean.assign(results_.keys.size(), false);
    return problems_.empty();
  }

  void readRow(const sim2d::CsvRow& row) {
    if (row.size() != columns_) {
      addProblem(row.front(), "trace.field-count", {row.size(), columns_});
      return;
    }
    Results::Run run;
    run.number = wholeOf(row[0], "run");
    run.scenario = row[1].text;
    run.seed = wholeOf(row[2], "seed");
    for (std::size_t at = kFixed; at < status_; ++at) {
      run.values.push_back(row[at].text);
    }
    run.ok = row[status_].text == "ok";
    run.reason = row[status_ + 1].text;
    if (!run.ok && row[status_].text != "failed") {
      addProblem(row[status_], "report.status", {row[status_].text});
    }
    if (!numbers_.insert(run.number).second) {
      addProblem(row[0], "report.run-twice", {run.number});
    }
    for (std::size_t k = 0; k < results_.keys.size(); ++k) {
      readMetric(row[status_ + 3 + k], k);
    }
    results_.runs.push_back(std::move(run));
  }

  long long wholeOf(const sim2d::CsvField& field, const char* name) {
    const std::optional<long long> number = base::parseInt(field.text);
    if (!number || *number < 0) {
      addProblem(field, "trace.not-whole", {name, field.text});
    }
    return number.value_or(0);
  }

  void readMetric(const sim2d::CsvField& field, std::size_t key) {
    double value = kUndefinedValue;
    if (field.text == "True" || field.text == "False") {
      value = field.text == "True" ? 1.0 : 0.0;
      results_.isBoolean[key] = true;
    } else if (!field.text.empty()) {
      const std::optional<double> number = base::parseDouble(field.text);
      if (!number) {
        addProblem(field, "trace.not-finite", {results_.keys[key], field.text});
      }
      value = number.value_or(kUndefinedValue);
      value = std::abs(value) <= std::numeric_limits<double>::max() ? value : kUndefinedValue;
    }
    results_.metrics[key].push_back(value);
  }

  static constexpr std::size_t kFixed = 3;  // run, scenario, seed

  sim2d::CsvReader reader_;
  std::string file_;
  base::Diagnostics problems_;
  Results results_;
  std::set<long long> numbers_;
  std::size_t status_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace

std::size_t Results::keyAt(const std::string& key) const {
  return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
}

base::Result<Results> parseResults(const std::string& text, const std::string& file) {
  return ResultsReader(text, file).read();
}

}  // namespace report
