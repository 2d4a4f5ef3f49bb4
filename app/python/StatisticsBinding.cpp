#include <pybind11/stl.h>

#include "app/python/Bindings.h"
#include "app/python/Problems.h"
#include "app/run/Nav2Robots.h"
#include "app/run/ResultStore.h"
#include "metrics/MetricRegistry.h"
#include "metrics/statistics/PairedTests.h"
#include "metrics/statistics/Ranks.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Registries.h"

namespace python {

namespace {

py::tuple tupleOf(const statistics::Interval& interval) {
  return py::make_tuple(interval.low, interval.high);
}

/// A field of the results as a number, a truth value, or text; None: empty.
py::object valueOf(const std::string& text) {
  if (text.empty()) {
    return py::none();
  }
  if (text == "True" || text == "False") {
    return py::bool_(text == "True");
  }
  if (const auto number = base::parseDouble(text)) {
    return py::float_(*number);
  }
  return py::str(text);
}

/// The varied paths of a batch, and its rows in the order of its runs, as dicts of columns.
py::tuple rowsOf(const std::string& database) {
  const base::Result<std::unique_ptr<app::ResultStore>> store = app::ResultStore::open(database);
  if (!store) {
    throwProblems(store.diagnostics());
  }
  py::list rows;
  const std::vector<std::string>& paths = (*store)->study().paths;
  requireNoErrors((*store)->forEach([&](const app::StoredRun& run) {
    py::dict row;
    row["run"] = run.run;
    row["scenario"] = run.scenario;
    row["seed"] = run.seed;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      row[py::str(paths[i])] = valueOf(run.values[i]);
    }
    row["ok"] = run.row.ok;
    row["reason"] = run.row.reason;
    for (const auto& [column, field] : run.row.fields) {
      row[py::str(column)] = valueOf(field);
    }
    rows.append(row);
  }));
  return py::make_tuple(paths, rows);
}

py::dict compare(const std::vector<double>& first, const std::vector<double>& second,
                 double level) {
  if (first.size() != second.size()) {
    throw py::value_error("pairs of values are compared: both lists must be equally long");
  }
  statistics::Strata differences(1);
  for (std::size_t i = 0; i < first.size(); ++i) {
    differences.front().push_back(first[i] - second[i]);
  }
  const statistics::StratifiedSignedRank test = statistics::stratifiedSignedRank(differences);
  py::dict result;
  result["shift"] = statistics::stratifiedShift(differences);
  result["interval"] = tupleOf(statistics::stratifiedShiftInterval(differences, level));
  result["p"] = test.p;
  result["exact"] = test.isExact;
  result["pairs"] = first.size();
  return result;
}

py::list metricInfos() {
  py::list list;
  for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
    py::dict info;
    info["key"] = entry.info.key;
    info["name"] = entry.info.name;
    info["unit"] = entry.info.unit;
    info["formula"] = entry.info.formula;
    info["source"] = entry.info.source;
    list.append(info);
  }
  return list;
}

}  // namespace

void addStatistics(py::module_& module) {
  module.def("_rows", rowsOf, py::arg("database"));
  module.def("compare", compare, py::arg("first"), py::arg("second"), py::arg("level") = 0.95,
             "Compares pairs of values: Hodges-Lehmann shift of first - second with its interval, "
             "and the p value of Wilcoxon's signed-rank test.");
  module.def(
      "mean_interval",
      [](const statistics::Numbers& values, double level) {
        return tupleOf(statistics::meanInterval(values, level));
      },
      py::arg("values"), py::arg("level") = 0.95, "Student's interval for the mean.");
  module.def(
      "rate_interval",
      [](int successes, int n, double level) {
        return tupleOf(statistics::wilsonInterval(successes, n, level));
      },
      py::arg("successes"), py::arg("n"), py::arg("level") = 0.95, "Wilson's interval for a rate.");
  module.def("holm", &statistics::holm, py::arg("ps"), "p values adjusted by Holm's method.");
  module.def("metrics", metricInfos, "All metrics, as dicts: key, name, unit, formula, source.");
  module.def(
      "planners", [] { return app::builtinRegistries().planners.names(); },
      "Names of the robot planners.");
  module.def(
      "models", [] { return app::builtinRegistries().models.names(); },
      "Names of the pedestrian models.");
}

}  // namespace python
