#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/studies/SearchStudy.h"
#include "sim2d/trace/Csv.h"

/// Fields that the files of all kinds of searches have in common.
namespace app {

/// The inputs of a run of the search, and its end.
template <class Json>
Json searchedRunJson(const SearchStudy& study, std::size_t number) {
  const SearchedRun& run = study.result.runs[number];
  Json values = Json::object();
  const std::vector<std::string> texts = study.space->textsOf(run.candidate);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    values[study.experiment->values[k].path] = texts[k];
  }
  return {{"run", number},
          {"scenario", study.space->scenarioName(run.candidate)},
          {"seed", study.space->seedOf(run.candidate)},
          {"values", values},
          {"reason", run.reason},
          {"simulated", run.simulated}};
}

/// Adds a comma and the field.
inline void addCsvField(std::string& line, const std::string& field) {
  line += ',';
  sim2d::appendCsvField(line, field);
}

}  // namespace app
