#include "metrics/Statistics.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>

#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace metrics {

namespace {

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

constexpr double kNormalQuantile = 1.959963984540054;  // 97.5 %

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

double meanOf(const std::vector<double>& values) {
  return sumOf(values) / static_cast<double>(values.size());
}

/// Sample standard deviation; at least two values.
double deviationOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double sum = 0.0;
  for (const double value : values) {
    sum += (value - mean) * (value - mean);
  }
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// P(T <= t) of Student's distribution with whole degrees of freedom (Abramowitz and Stegun
/// 26.7.3, 26.7.4).
double studentProbability(double t, int degrees) {
  const double theta = std::atan(t / std::sqrt(static_cast<double>(degrees)));
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1.0;
  double sum = degrees == 1 ? 0.0 : term;
  for (int k = odd ? 3 : 2; k <= degrees - 2; k += 2) {
    term *= cosine * cosine * (k - 1) / k;
    sum += term;
  }
  const double twoSided = odd ? 2.0 / base::kPi * (theta + sine * sum) : sine * sum;
  return 0.5 + twoSided / 2.0;
}

}  // namespace

double studentQuantile(int degrees) {
  constexpr double kWanted = 0.975;
  constexpr int kManyDegrees = 100000;
  if (degrees > kManyDegrees) {
    return kNormalQuantile;
  }
  double low = 0.0;
  double high = 13.0;  // 12.706 with one degree of freedom
  for (int k = 0; k < 100; ++k) {
    const double middle = (low + high) / 2.0;
    (studentProbability(middle, degrees) < kWanted ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

Interval wilsonInterval(double successes, double trials) {
  const double z2 = kNormalQuantile * kNormalQuantile;
  const double rate = successes / trials;
  const double centre = (rate + z2 / (2.0 * trials)) / (1.0 + z2 / trials);
  const double half = kNormalQuantile / (1.0 + z2 / trials) *
                      std::sqrt(rate * (1.0 - rate) / trials + z2 / (4.0 * trials * trials));
  return {std::max(centre - half, 0.0), std::min(centre + half, 1.0)};
}

Statistics statisticsOf(const std::vector<std::optional<double>>& values, Kind kind) {
  std::vector<double> defined;
  for (const std::optional<double>& value : values) {
    if (value && std::isfinite(*value)) {
      defined.push_back(*value);
    }
  }
  Statistics statistics;
  statistics.runs = values.size();
  statistics.defined = defined.size();
  if (defined.empty()) {
    return statistics;
  }
  const double count = static_cast<double>(defined.size());
  statistics.mean = meanOf(defined);
  statistics.median = medianOf(defined);
  statistics.minimum = *std::min_element(defined.begin(), defined.end());
  statistics.maximum = *std::max_element(defined.begin(), defined.end());
  if (kind == Kind::Boolean) {
    statistics.confidence = wilsonInterval(sumOf(defined), count);
  }
  if (defined.size() > 1) {
    statistics.deviation = deviationOf(defined);
    if (kind != Kind::Boolean) {
      const double half = studentQuantile(static_cast<int>(defined.size()) - 1) *
                          *statistics.deviation / std::sqrt(count);
      statistics.confidence = Interval{*statistics.mean - half, *statistics.mean + half};
    }
  }
  return statistics;
}

std::vector<AggregateRow> aggregate(const std::vector<Evaluation>& evaluations) {
  std::vector<AggregateRow> rows;
  if (evaluations.empty()) {
    return rows;
  }
  for (const MetricResult& first : evaluations.front().results) {
    std::vector<std::optional<double>> values;
    for (const Evaluation& evaluation : evaluations) {
      if (const MetricResult* result = evaluation.find(first.info.key); result != nullptr) {
        values.push_back(result->value.value);
      }
    }
    rows.push_back({first.info, statisticsOf(values, first.info.kind)});
  }
  return rows;
}

Statistics pairedDifference(const std::vector<std::optional<double>>& first,
                            const std::vector<std::optional<double>>& second) {
  std::vector<std::optional<double>> differences;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
    differences.push_back(first[k] && second[k] ? std::optional<double>(*second[k] - *first[k])
                                                : std::nullopt);
  }
  return statisticsOf(differences);
}

namespace {

/// Values of all result files by column of the table and metric.
class Comparison {
 public:
  base::Diagnostics add(const ResultFile& file) {
    sim2d::CsvReader reader(file.text);
    sim2d::CsvRow header;
    if (!reader.next(header) || header.size() < 2 || header[0].text != "experiment_tag") {
      return {base::makeError("not a result file of the evaluator", file.name, 1, 1)};
    }
    base::Diagnostics problems;
    sim2d::CsvRow row;
    while (reader.next(row)) {
      if (row.size() != header.size()) {
        problems.push_back(base::makeError("the line has another number of fields than the first",
                                           file.name, row[0].line, 1));
        continue;
      }
      addRow(file.name + "_" + row[0].text, header, row, file.name, problems);
    }
    return problems;
  }

  std::string table() const {
    std::string text;
    for (const std::string& column : columns_) {
      text += ',';
      sim2d::appendCsvField(text, column);
    }
    text += '\n';
    for (const std::string& metric : metrics_) {
      sim2d::appendCsvField(text, metric);
      for (const std::string& column : columns_) {
        text += ',' + cell(column, metric);
      }
      text += '\n';
    }
    return text;
  }

 private:
  static void remember(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  }

  void addRow(const std::string& column, const sim2d::CsvRow& header, const sim2d::CsvRow& row,
              const std::string& file, base::Diagnostics& problems) {
    remember(columns_, column);
    for (std::size_t k = 1; k < row.size(); ++k) {
      if (header[k].text == "run_id") {
        continue;
      }
      remember(metrics_, header[k].text);
      const std::string& text = row[k].text;
      std::optional<double> value = base::parseDouble(text);
      if (text == "True" || text == "False") {
        value = text == "True" ? 1.0 : 0.0;
      } else if (!value && !text.empty()) {
        problems.push_back(
            base::makeError("'" + text + "' is not a number", file, row[k].line, row[k].column));
      }
      values_[{column, header[k].text}].push_back(value);
    }
  }

  std::string cell(const std::string& column, const std::string& metric) const {
    const auto found = values_.find({column, metric});
    if (found == values_.end()) {
      return "";
    }
    const Statistics statistics = statisticsOf(found->second);
    if (!statistics.mean) {
      return "";
    }
    const std::string mean = fourDecimals(*statistics.mean);
    return statistics.deviation ? mean + " ± " + fourDecimals(*statistics.deviation) : mean;
  }

  static std::string fourDecimals(double value) {
    std::array<char, 400> buffer{};  // the largest double has 309 digits before the point
    const char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, 4)
                                .ptr;
    return std::string(static_cast<const char*>(buffer.data()), end);
  }

  std::vector<std::string> columns_, metrics_;
  std::map<std::pair<std::string, std::string>, std::vector<std::optional<double>>> values_;
};

/// Value of a series at a time within it.
double valueAt(const TimedSeries& run, double time) {
  const auto after = std::upper_bound(run.times.begin(), run.times.end(), time);
  if (after == run.times.begin()) {
    return run.series.values.front();
  }
  const auto right = static_cast<std::size_t>(after - run.times.begin());
  const std::size_t left = right - 1;
  if (after == run.times.end() || run.series.kind != Kind::Number) {
    return run.series.values[left];
  }
  const double share = (time - run.times[left]) / (run.times[right] - run.times[left]);
  return run.series.values[left] + share * (run.series.values[right] - run.series.values[left]);
}

}  // namespace

base::Result<std::string> comparisonTable(const std::vector<ResultFile>& files) {
  Comparison comparison;
  base::Diagnostics problems;
  for (const ResultFile& file : files) {
    base::append(problems, comparison.add(file));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return comparison.table();
}

TimedSeries meanSeries(const std::vector<TimedSeries>& runs, double step) {
  TimedSeries mean;
  double end = 0.0;
  for (const TimedSeries& run : runs) {
    end = run.times.empty() ? end : std::max(end, run.times.back());
  }
  const double slack = step * 1e-9;
  for (int k = 0; static_cast<double>(k) * step <= end + slack; ++k) {
    const double time = static_cast<double>(k) * step;
    std::vector<std::optional<double>> values;
    for (const TimedSeries& run : runs) {
      if (!run.times.empty() && time <= run.times.back() + slack) {
        const double value = valueAt(run, time);
        values.push_back(std::isnan(value) ? std::nullopt : std::optional<double>(value));
      }
    }
    mean.times.push_back(time);
    mean.series.values.push_back(statisticsOf(values).mean.value_or(std::nan("")));
  }
  return mean;
}

}  // namespace metrics
