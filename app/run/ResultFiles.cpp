#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/run/ResultStore.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

/// The metric columns: those of the registry in its order, then the others by first occurrence.
base::Diagnostics findColumns(const ResultStore& store, std::vector<std::string>& columns) {
  std::set<std::string> found;
  std::vector<std::string> inOrder;
  base::Diagnostics problems = store.forEach([&](const StoredRun& stored) {
    for (const auto& [column, field] : stored.row.fields) {
      if (found.insert(column).second) {
        inOrder.push_back(column);
      }
    }
  });
  for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
    if (found.erase(entry.info.key) != 0) {
      columns.push_back(entry.info.key);
    }
  }
  std::copy_if(inOrder.begin(), inOrder.end(), std::back_inserter(columns),
               [&found](const std::string& column) { return found.count(column) != 0; });
  return problems;
}

std::string rowLine(const StoredRun& stored, const std::vector<std::string>& columns) {
  const ResultRow& row = stored.row;
  std::string line = std::to_string(stored.run);
  const auto add = [&line](const std::string& field) {
    line += ',';
    sim2d::appendCsvField(line, field);
  };
  add(stored.scenario);
  add(std::to_string(stored.seed));
  for (const std::string& value : stored.values) {
    add(value);
  }
  add(row.ok ? "ok" : "failed");
  add(row.reason);
  add(row.simulated);
  for (const std::string& column : columns) {
    const auto* const found = fieldOf(row, column);
    add(found == nullptr ? std::string() : *found);
  }
  return line + '\n';
}

std::string headerLineOf(const Study& study, const std::vector<std::string>& columns) {
  std::string line = "run,scenario,seed";
  for (const std::string& path : study.paths) {
    line += ',';
    sim2d::appendCsvField(line, path);
  }
  line += ",status,reason,simulated";
  for (const std::string& column : columns) {
    line += ',';
    sim2d::appendCsvField(line, column);
  }
  return line + '\n';
}

Json manifestOf(const Study& study, std::size_t finished, std::size_t failed) {
  std::vector<InputHash> files = study.inputs;  // in the order in which runs reported them
  std::sort(std::next(files.begin(), files.empty() ? 0 : 1), files.end(),
            [](const InputHash& a, const InputHash& b) { return a.path < b.path; });
  Json inputs = Json::array();
  for (const InputHash& input : files) {
    inputs.push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  const bool isComplete = finished == study.shard.runCount(study.runs) || study.enoughSeeds > 0;
  Json json = {{"program", {{"version", study.version}, {"commit", study.commit}}},
               {"inputs", inputs},
               {"code", {{"allowed", study.allowsCode}}},
               {"status", isComplete ? "finished" : "interrupted"},
               {"runs", study.runs},
               {"finished", finished},
               {"failed", failed}};
  if (!study.design.empty()) {
    json["design"] = Json::parse(base::shallowJson(study.design), nullptr, false);
  }
  if (!study.until.empty()) {
    json["until"] = {{"condition", study.until}, {"met", study.enoughSeeds > 0}};
    if (study.enoughSeeds > 0) {
      json["until"]["seeds"] = study.enoughSeeds;
    }
  }
  if (study.timeLimit > 0.0) {
    json["time_limit"] = study.timeLimit;
  }
  if (study.shard.count > 1) {
    json["shard"] = study.shard.text();
  }
  json["outputs"] = Json::array();  // filled by OutputFolder::commit()
  return json;
}

/// scenario -> seed -> path -> drawn value, which is the same in all runs of that scenario and
/// seed.
base::Result<Json> drawnJson(const ResultStore& store) {
  const Study& study = store.study();
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < study.paths.size(); ++k) {
    if (std::find(study.drawn.begin(), study.drawn.end(), study.paths[k]) != study.drawn.end()) {
      places.push_back(k);
    }
  }
  Json drawn = Json::object();
  if (places.empty()) {
    return drawn;
  }
  base::Diagnostics unreadable = store.forEach([&](const StoredRun& stored) {
    Json& values = drawn[stored.scenario][std::to_string(stored.seed)];
    for (const std::size_t place : places) {
      values[study.paths[place]] = stored.values[place];
    }
  });
  return base::resultOf(std::move(drawn), std::move(unreadable));
}

/// The JSON value of a CSV field.
Json fieldJson(const std::string& field) {
  if (field.empty()) {
    return {};
  }
  if (field == "True" || field == "False") {
    return field == "True";
  }
  const std::optional<double> number = base::parseDouble(field);
  return number && std::isfinite(*number) ? Json(*number) : Json(field);
}

}  // namespace

base::Diagnostics writeResults(const ResultStore& store, const std::string& path) {
  std::vector<std::string> columns;
  base::Diagnostics unreadable = findColumns(store, columns);
  if (!unreadable.empty()) {
    return unreadable;
  }
  base::AtomicFileWriter file(path);
  file.append(headerLineOf(store.study(), columns));
  const base::Diagnostics cut =
      store.forEach([&](const StoredRun& stored) { file.append(rowLine(stored, columns)); });
  return cut.empty() ? file.finish() : cut;
}

std::string rowJson(const Study& study, const StoredRun& run) {
  Json values = Json::object();
  for (std::size_t k = 0; k < run.values.size(); ++k) {
    values[study.paths[k]] = run.values[k];
  }
  Json columns = Json::object();
  for (const auto& [column, field] : run.row.fields) {
    columns[column] = fieldJson(field);
  }
  const Json row = {{"run", run.run},
                    {"scenario", run.scenario},
                    {"seed", run.seed},
                    {"values", values},
                    {"status", run.row.ok ? "ok" : "failed"},
                    {"reason", run.row.reason},
                    {"metrics", columns}};
  return row.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string headerJson(const ResultStore& store) {
  return Json({{"runs", store.study().shard.runCount(store.study().runs)},
               {"finished", store.finished()}})
      .dump();
}

base::Result<std::string> batchManifest(const ResultStore& store) {
  Json json = manifestOf(store.study(), store.finished(), store.failed());
  if (!store.study().drawn.empty()) {
    base::Result<Json> drawn = drawnJson(store);
    if (!drawn) {
      return drawn.diagnostics();
    }
    json["drawn"] = *std::move(drawn);
  }
  return base::jsonText(json);
}

std::string emptyManifest(const Study& study, std::size_t former) {
  Json json = manifestOf(study, 0, 0);
  if (former > study.runs) {
    json["replaces"] = former;
  }
  return base::jsonText(json);
}

}  // namespace app
