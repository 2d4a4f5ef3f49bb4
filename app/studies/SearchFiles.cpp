#include <cmath>

#include <nlohmann/json.hpp>

#include "app/studies/SearchFields.h"
#include "app/studies/SearchStudy.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

/// A run of the search with what it means for the search.
Json runJson(const SearchStudy& study, std::size_t number) {
  const SearchedRun& run = study.result.runs[number];
  Json json = searchedRunJson<Json>(study, number);
  json["kind"] = run.kind ? Json(run.kind->name()) : Json();
  json["value"] = base::jsonNumber<Json>(run.value);
  json["fitness"] = base::jsonNumber<Json>(run.fitness);
  return json;
}

Json cellsJson(const SearchStudy& study) {
  Json cells = Json::array();
  for (const auto& [cell, elite] : study.result.archive.elites()) {
    Json entry = {
        {"cell", {cell[0], cell[1]}},
        {"descriptors",
         {base::jsonNumber<Json>(elite.values[0]), base::jsonNumber<Json>(elite.values[1])}}};
    entry.update(runJson(study, elite.run));
    cells.push_back(std::move(entry));
  }
  return cells;
}

Json descriptorsJson(const SearchStudy& study) {
  Json all = Json::array();
  for (const Descriptor& each : study.plan.descriptors) {
    all.push_back(
        {{"key", each.key}, {"low", each.low}, {"high", each.high}, {"cells", each.cells}});
  }
  return all;
}

Json failureJson(const SearchStudy& study, const SavedFailure& saved) {
  const ShrunkFailure& shrunk = saved.shrunk;
  return {{"kind", saved.kind.name()},
          {"text", saved.kind.text()},
          {"file", saved.file},
          {"found", runJson(study, saved.run)},
          {"seed", shrunk.request.seed},
          {"set", shrunk.request.spec.set},
          {"reason", shrunk.row.reason},
          {"simulated", shrunk.row.simulated},
          {"people_before", shrunk.peopleBefore},
          {"people", shrunk.people},
          {"removed", shrunk.removed},
          {"reset", shrunk.reset},
          {"shrink_runs", shrunk.runs},
          {"minimal", shrunk.isMinimal},
          {"repeated", saved.isRepeated}};
}

Json worstJson(const SearchStudy& study) {
  if (!study.worst) {
    return {};
  }
  Json worst = runJson(study, study.worst->run);
  worst["file"] = study.worst->file;
  worst["repeated"] = study.worst->isRepeated;
  return worst;
}

std::string csvNumber(double value) {
  return std::isfinite(value) ? base::formatDouble(value) : std::string();
}

/// The columns of runs.csv that depend on the goal of the search.
void addResultColumns(std::string& text, const SearchPlan& plan) {
  if (plan.covers) {
    text += ",fitness,new_nodes";
    return;
  }
  text += ",kind,unavoidable,value,fitness";
  for (const Descriptor& descriptor : plan.descriptors) {
    addCsvField(text, descriptor.key);
  }
}

/// The fields of these columns.
void addResults(std::string& text, const SearchedRun& run, const SearchPlan& plan) {
  if (plan.covers) {
    addCsvField(text, csvNumber(run.fitness));
    addCsvField(text, std::to_string(run.newNodes));
    return;
  }
  addCsvField(text, run.kind ? run.kind->name() : std::string());
  addCsvField(text, run.isUnavoidable ? "True" : "");
  addCsvField(text, csvNumber(run.value));
  addCsvField(text, csvNumber(run.fitness));
  for (const double value : run.descriptors) {
    addCsvField(text, csvNumber(value));
  }
}

}  // namespace

std::string searchJson(const SearchStudy& study) {
  Json failures = Json::array();
  for (const SavedFailure& saved : study.failures) {
    failures.push_back(failureJson(study, saved));
  }
  std::size_t unavoidable = 0;
  for (const SearchedRun& run : study.result.runs) {
    unavoidable += run.isUnavoidable ? 1 : 0;
  }
  const Json json = {{"hunavsim_search", 1},
                     {"worst", study.plan.worst.empty() ? Json() : Json(study.plan.worst)},
                     {"search_seed", study.plan.seed},
                     {"runs", study.result.runs.size()},
                     {"not_simulated", study.result.notSimulated},
                     {"unavoidable_contacts", unavoidable},
                     {"descriptors", descriptorsJson(study)},
                     {"failures", failures},
                     {"worst_run", worstJson(study)},
                     {"cells", cellsJson(study)}};
  return base::jsonText(json) + "\n";
}

std::string searchCsv(const SearchStudy& study) {
  std::string text = "run,scenario,seed";
  for (const ExperimentValue& value : study.experiment->values) {
    addCsvField(text, value.path);
  }
  text += ",reason,simulated";
  addResultColumns(text, study.plan);
  text += '\n';
  for (std::size_t k = 0; k < study.result.runs.size(); ++k) {
    const SearchedRun& run = study.result.runs[k];
    text += std::to_string(k);
    addCsvField(text, study.space->scenarioName(run.candidate));
    addCsvField(text, std::to_string(study.space->seedOf(run.candidate)));
    for (const std::string& value : study.space->textsOf(run.candidate)) {
      addCsvField(text, value);
    }
    addCsvField(text, run.reason);
    addCsvField(text, run.simulated);
    addResults(text, run, study.plan);
    text += '\n';
  }
  return text;
}

}  // namespace app
