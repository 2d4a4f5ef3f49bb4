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

}  // namespace

std::string factsMarkup(const Study& study) {
  std::string facts;
  const auto fact = [&facts](const std::string& name, const std::string& value) {
    if (!value.empty()) {
      facts += element("dt", "", escaped(name)) +
               element("dd", "", element("code", "", escaped(value))) + "\n";
    }
  };
  fact("Batch created by", study.version.empty()
                               ? std::string("unknown (no manifest)")
                               : "hunavsim " + study.version + " " + study.commit);
  fact("Report created by", "hunavsim " + app::programVersion() + " " + app::programCommit());
  fact("results.csv", study.resultsHash);
  for (const Study::Input& input : study.inputs) {
    fact(input.path, input.sha256);
  }
  fact("Seeds", seedsText(study));
  fact("Drawn per scenario and seed", base::join(study.drawn, ", "));
  fact("Part of a study", study.shard.empty() ? "" : "shard " + study.shard);
  return facts;
}

}  // namespace report
