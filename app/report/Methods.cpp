#include "app/report/Methods.h"

#include <set>

#include "app/report/Markup.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// The seeds: "1 to 20", or a list.
std::string seedsText(const Study& study) {
  std::set<long long> seeds;
  for (const Results::Run& run : study.results.runs) {
    seeds.insert(run.seed);
  }
  const long long span = *seeds.rbegin() - *seeds.begin() + 1;
  if (seeds.size() > 2 && span == static_cast<long long>(seeds.size())) {
    return std::to_string(*seeds.begin()) + " to " + std::to_string(*seeds.rbegin());
  }
  std::vector<std::string> words;
  words.reserve(seeds.size());
  for (const long long seed : seeds) {
    words.push_back(std::to_string(seed));
  }
  return base::join(words, ", ");
}

std::string thisProgram() {
  return "hunavsim " + app::programVersion() + " " + app::programCommit();
}

}  // namespace

void addInputs(const std::vector<app::InputHash>& inputs, std::vector<Fact>& facts) {
  for (const app::InputHash& input : inputs) {
    facts.emplace_back(input.path, input.sha256);
  }
}

std::string provenanceMarkup(const std::vector<Fact>& facts, const std::string& commands) {
  std::string list;
  for (const auto& [name, value] : facts) {
    if (!value.empty()) {
      list += element("dt", "", escaped(name)) +
              element("dd", "", element("code", "", escaped(value))) + "\n";
    }
  }
  return element("dl", "", "\n" + list) + "\n" +
         (commands.empty() ? std::string()
                           : element("pre", "", element("code", "", escaped(commands))) + "\n");
}

std::string provenanceMarkup(const std::vector<app::InputHash>& inputs,
                             const std::vector<std::string>& command) {
  std::vector<Fact> facts = {{"Created by", thisProgram()}};
  addInputs(inputs, facts);
  return provenanceMarkup(facts, shellText(command));
}

std::string provenanceMarkup(const Study& study, const std::string& commands) {
  std::vector<Fact> facts = {
      {"Batch created by", study.version.empty()
                               ? std::string("unknown (no manifest)")
                               : "hunavsim " + study.version + " " + study.commit},
      {"Report created by", thisProgram()},
      {"results.csv", study.resultsHash}};
  addInputs(study.inputs, facts);
  facts.emplace_back("Seeds", seedsText(study));
  facts.emplace_back("Drawn per scenario and seed", base::join(study.drawn, ", "));
  facts.emplace_back("Part of a study", study.shard.empty() ? "" : "shard " + study.shard);
  return provenanceMarkup(facts, commands);
}

}  // namespace report
