#include "app/report/PageSections.h"

#include <set>
#include <vector>

#include "app/report/Markup.h"
#include "app/report/Plots.h"
#include "app/report/Tables.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// The names of the options with this standing, without the leaders.
std::vector<std::string> namesOf(const Study& study, const MetricComparison& comparison,
                                 RelativeToBest standing) {
  std::vector<std::string> names;
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (!comparison.isBestOrTied(option) && comparison.relativeToBest[option] == standing) {
      names.push_back(study.options[option]);
    }
  }
  return names;
}

std::string namesText(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 6;
  return names.size() > kMostNames ? std::to_string(names.size()) + " others"
                                   : escaped(base::join(names, ", "));
}

}  // namespace

std::string findingMarkup(const Study& study, const MetricComparison& comparison) {
  if (!comparison.best) {
    return {};
  }
  const Metric& metric = study.metrics[comparison.metric];
  const double best = comparison.estimates[*comparison.best].mean;
  std::vector<std::string> leaders;  // the best and those equal to it
  for (std::size_t option = 0; option < study.options.size(); ++option) {
    if (comparison.isBestOrTied(option)) {
      leaders.push_back(study.options[option]);
    }
  }
  const std::vector<std::string> beaten = namesOf(study, comparison, RelativeToBest::Worse);
  const std::vector<std::string> close = namesOf(study, comparison, RelativeToBest::NotDifferent);
  const std::vector<std::string> ahead = namesOf(study, comparison, RelativeToBest::Better);
  const std::vector<std::string> pieces = namesOf(study, comparison, RelativeToBest::NeverSucceeds);
  const int decimals = decimalsFor(comparison.estimates, metric.isRate);
  const std::string unit = metric.unit.empty() || metric.unit == "-" ? "" : " " + metric.unit;
  std::string words = element("b", "", escaped(metric.name)) +
                      (leaders.size() == 1 ? ": best is " : ": best are ") +
                      escaped(base::join(leaders, ", ")) + " (" +
                      escaped(estimateText(metric, best, decimals) + unit) + ")";
  const bool beatsAll = close.empty() && ahead.empty() && pieces.empty() && beaten.size() > 1;
  const char* between = ", ";
  const auto add = [&](const std::vector<std::string>& names, const std::string& more) {
    words += names.empty() ? "" : between + more;
    between = names.empty() ? between : "; ";
  };
  add(beaten, "better than " + (beatsAll ? "all others" : namesText(beaten)));
  add(close, "not significantly different from " + namesText(close));
  add(ahead, "but " + namesText(ahead) + (ahead.size() == 1 ? " is" : " are") +
                 " better on the same cases and seeds");
  add(pieces, namesText(pieces) +
                  (pieces.size() == 1 ? " never succeeds and is" : " never succeed and are") +
                  " excluded");
  return words + ".";
}

namespace {

constexpr const char* kMethods[] = {
    "A value is one metric of one run. Undefined values, such as the time to a goal that is not "
    "reached, are excluded; n is the number of defined values. A run that ended with an error "
    "counts as a run without success; its other values are excluded. Confidence intervals of means "
    "are bias-corrected and accelerated (BCa) bootstrap intervals (Efron 1987), those of rates are "
    "Wilson intervals (Wilson 1927), those of medians lie between order statistics (Conover 1999).",
    "Options are compared on the same case and seed. A pair of options is tested with Wilcoxon's "
    "signed-rank test: two-sided, zeros by Pratt's rule, exact for up to 50 differing pairs, "
    "otherwise by normal approximation with corrections for ties and continuity. Rates are tested "
    "with McNemar's exact test. Cases (scenarios and all other varied values) are strata: each "
    "case is tested separately. For the test over all cases, differences are ranked within their "
    "case, and the rank sums are added with van Elteren's weights 1 / (pairs + 1) (1960), so that "
    "the spread of one case does not affect another. McNemar's test equals the test of Cochran, "
    "Mantel and Haenszel with one stratum per pair; it is therefore valid over all cases without "
    "changes. p values are adjusted with Holm's method over all pairs of one metric. The "
    "difference is the Hodges-Lehmann estimate that belongs to the test, with its confidence "
    "interval; for rates it is the difference of rates with the paired score interval (Newcombe "
    "1998), combined over cases as by Yan and Su (2010). The effect size is Cliff's delta over "
    "values of the same case, weighted by the number of comparisons. Each metric is a family of "
    "tests of its own: the error rate applies to each metric separately.",
    "With three or more options, Friedman's test is applied first (corrected for ties; F statistic "
    "of Iman and Davenport 1980). It ranks within a case and seed; mean ranks are compared with "
    "Nemenyi's critical difference (Demšar 2006). The required number of pairs is that of Noether "
    "(1987) for the signed-rank test of the differing pairs, divided by their share; for rates, "
    "and if at least half of the pairs are ties, it is that of Connor (1987) for McNemar's test of "
    "the signs."};

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

std::string methodsMarkup(const Study& study, std::size_t blocks,
                          const std::vector<std::string>& command) {
  std::string body;
  for (const char* words : kMethods) {
    body += paragraph(words);
  }
  body += paragraph("The confidence level is " + levelText(study.level) + ", " +
                    std::to_string(study.resamples) +
                    " bootstrap resamples with seed 1. A block is a case with one seed; number of "
                    "blocks: " +
                    std::to_string(blocks) + ".");
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
  body += element("dl", "", "\n" + facts) + "\n";
  std::string commands;
  if (!study.inputs.empty()) {
    commands += shellText(study.batchCommand()) + "\n";
  }
  commands += shellText(command);
  body += "<pre>" + element("code", "", escaped(commands)) + "</pre>\n";
  return body;
}

}  // namespace report
