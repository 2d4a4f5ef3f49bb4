#include "app/report/Methods.h"

#include <set>

#include "app/report/Markup.h"
#include "app/report/PlotParts.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr const char* kMethods[] = {
    "A value is one metric of one run. What a run leaves undefined, such as the time to a goal "
    "that is not reached, is left out, and n says how many values are left; a run that ended "
    "with an error counts as one without success, and what was measured until then is left out. "
    "Means have bias-corrected and accelerated bootstrap "
    "intervals (Efron 1987), rates Wilson's (Wilson 1927), medians those between order "
    "statistics "
    "(Conover 1999).",
    "Options are compared on the same case and seed. The test of a pair is Wilcoxon's "
    "signed-rank test, two-sided, zeros by Pratt's rule, exact up to 50 pairs that differ, else "
    "normal with corrections for ties and continuity; of rates McNemar's exact test. "
    "Cases (scenarios, and what else is varied) are strata: each is tested alone, and for the test "
    "over all of them differences are ranked within their case and the sums of ranks added with "
    "van Elteren's weights 1 / (pairs + 1) (1960), so that the spread of one case does not affect "
    "another. McNemar's test is that of Cochran, Mantel and Haenszel with a stratum for each pair, "
    "and so is valid over cases unchanged. "
    "p values are adjusted by Holm's method over all pairs of one metric. The typical difference "
    "is the estimate of Hodges and Lehmann that belongs to the test, with its interval (of rates "
    "the difference with the paired score interval, Newcombe 1998, those of cases combined as "
    "Yan and Su do, 2010); the effect size is Cliff's delta over values of the same case, weighted "
    "by the number of comparisons. "
    "Several metrics are "
    "several families: the chance of a false finding holds for each of them.",
    "With three options or more Friedman's test comes first (with ties; F of Iman and Davenport "
    "1980), which ranks within a case and seed, and mean ranks are compared by Nemenyi's critical "
    "difference (Demšar 2006). The "
    "number of pairs that would be enough is Noether's (1987) for the signed-rank test among the "
    "pairs that differ, over their share; for rates, and where half of the pairs or more tie, "
    "Connor's (1987) for McNemar's test of the signs."};

/// "1 to 20", or a list.
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

std::string methodsMarkup(const Study& study, std::size_t blocks,
                          const std::vector<std::string>& command) {
  std::string body;
  for (const char* words : kMethods) {
    body += paragraph(words);
  }
  body += paragraph("Intervals are of " + levelText(study.level) + ", " +
                    std::to_string(study.resamples) +
                    " resamples of the bootstrap, seed 1. Blocks are cases with one seed; " +
                    std::to_string(blocks) + " here.");
  std::string facts;
  const auto fact = [&facts](const std::string& name, const std::string& value) {
    if (!value.empty()) {
      facts += element("dt", "", escaped(name)) +
               element("dd", "", element("code", "", escaped(value))) + "\n";
    }
  };
  fact("Batch by", study.version.empty() ? std::string("not known (no manifest)")
                                         : "hunavsim " + study.version + " " + study.commit);
  fact("Report by", "hunavsim " + app::programVersion() + " " + app::programCommit());
  fact("results.csv", study.resultsHash);
  for (const Study::Input& input : study.inputs) {
    fact(input.path, input.sha256);
  }
  fact("Seeds", seedsText(study));
  fact("Drawn for each scenario and seed", base::join(study.drawn, ", "));
  fact("Part of a study", study.shard.empty() ? "" : "shard " + study.shard);
  body += element("dl", "", "\n" + facts) + "\n";
  std::string commands;
  if (!study.inputs.empty()) {
    commands += shellText(study.batchWords()) + "\n";
  }
  commands += shellText(command);
  body += "<pre>" + element("code", "", escaped(commands)) + "</pre>\n";
  return body;
}

}  // namespace report
