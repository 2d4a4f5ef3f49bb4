#include "app/report/Page.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/report/PageTexts.h"
#include "app/report/PlotParts.h"
#include "app/report/Plots.h"
#include "app/report/Tables.h"
#include "app/run/DataPaths.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr double kFineStep = 0.1;  // [s] between samples of a page with one run

std::string replaced(std::string text, const std::string& hole, const std::string& by) {
  const std::size_t at = text.find(hole);
  return at == std::string::npos ? text : text.replace(at, hole.size(), by);
}

std::string paragraph(const std::string& words, const std::string& attributes = {}) {
  return element("p", attributes, escaped(words)) + "\n";
}

std::string counted(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

/// Makes the page of a study, section by section.
class PageMaker {
 public:
  PageMaker(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
            const std::vector<std::string>& command, const OnStep& onStep)
      : study_(study), weights_(weights), command_(command), onStep_(onStep) {}

  Report make() {
    struct Step {
      const char* what;
      void (PageMaker::*work)();
    };
    constexpr Step kSteps[] = {
        {"comparing", &PageMaker::compareOptions}, {"reading runs", &PageMaker::readRuns},
        {"results", &PageMaker::writeResults},     {"figures", &PageMaker::writeFigures},
        {"pairs", &PageMaker::writePairs},         {"cases", &PageMaker::writeCases},
        {"maps", &PageMaker::writeRuns},           {"failures", &PageMaker::writeFailures},
        {"methods", &PageMaker::writeMethods},     {"tables", &PageMaker::writePage}};
    for (const Step& step : kSteps) {
      tell(step.what);
      (this->*step.work)();
    }
    return std::move(report_);
  }

 private:
  void tell(const std::string& what) const {
    if (onStep_) {
      onStep_(what);
    }
  }

  void compareOptions() {
    blocks_ = blocksOf(study_);
    for (const std::size_t metric : study_.shown) {
      tell("comparing " + study_.metrics[metric].name);
      comparisons_.push_back(compare(study_, metric, blocks_));
    }
  }

  void readRuns() {
    findFailures();
    pictures_ = readRunPictures(study_, failures_);
    report_.problems = pictures_.problems;
    writeTitle();
  }

  void writePage() {
    report_.moreTables.emplace_back("all_metrics", allMetricsCsv(study_));
    report_.html = wholePage(study_.title, head_ + navigation() + body_, hasPlayer_);
  }

  /// Runs that ended with an error, and those without success.
  void findFailures() {
    const std::size_t none = study_.results.keys.size();
    std::size_t key = none;
    for (const char* name : app::kSuccessKeys) {
      key = key < none ? key : study_.results.keyAt(name);
    }
    for (std::size_t run = 0; run < study_.runCount(); ++run) {
      const bool hasKey = key < none;
      knowsSuccess_ = knowsSuccess_ || (hasKey && !std::isnan(study_.valuesOf(key)[run]));
      if (!study_.results.runs[run].ok || (hasKey && study_.valuesOf(key)[run] == 0.0)) {
        failures_.push_back(run);
      }
    }
  }

  void section(const std::string& id, const std::string& title) {
    sections_.emplace_back(id, title);
    body_ += "<h2 id=\"" + id + "\">" + escaped(title) + "</h2>\n";
  }

  std::string navigation() const {
    std::string links;
    for (const auto& [id, title] : sections_) {
      links += "<a href=\"#" + id + "\">" + escaped(title) + "</a> ";
    }
    return "<nav>" + links + "</nav>\n";
  }

  void add(const std::optional<Figure>& figure) {
    if (!figure) {
      return;
    }
    report_.figures.push_back(*figure);
    body_ += "<figure>\n" + figure->markup() + "<figcaption>" +
             element("b", "", "Figure " + std::to_string(report_.figures.size()) + ".") + " " +
             escaped(figure->caption) + "</figcaption>\n</figure>\n";
  }
  void add(const std::optional<Table>& table, const std::string& htmlClass = {}) {
    if (!table) {
      return;
    }
    report_.tables.push_back(*table);
    body_ += tableHtml(*table, htmlClass);
  }

  void writeTitle() {
    std::set<long long> seeds;
    std::set<std::string> scenarios;
    for (const Results::Run& run : study_.results.runs) {
      seeds.insert(run.seed);
      scenarios.insert(run.scenario);
    }
    head_ += element("h1", "", escaped(study_.title)) + "\n";
    std::string lead = counted(study_.runCount(), "run") + " of " +
                       counted(scenarios.size(), "scenario") + " with " +
                       counted(seeds.size(), "seed");
    if (study_.options.size() > 1) {
      lead += ", " + std::to_string(study_.options.size()) + " options of " + study_.compared +
              " side by side";
    }
    head_ += paragraph(lead + ".", " class=\"lead\"");
    if (!study_.shard.empty()) {
      head_ += paragraph("These are the runs of shard " + study_.shard +
                         " of the study, not all; merge puts the shards together.");
    }
    if (study_.status == "interrupted") {
      head_ += paragraph("The batch was interrupted: only the runs that had ended are here.");
    }
    writeSeedWarning();
    std::string findings;
    for (const MetricComparison& comparison : comparisons_) {
      const std::string words = finding(comparison);
      if (!words.empty()) {
        findings += element("li", "", words) + "\n";
      }
    }
    if (!findings.empty()) {
      head_ += element("ul", "", "\n" + findings) + "\n";
    }
  }

  /// Runs that differ in nothing but their number are no evidence.
  void writeSeedWarning() {
    const std::size_t constant = constantCells(study_);
    if (constant == 0) {
      return;
    }
    head_ += paragraph(
        "In " + counted(constant, "combination") +
            " of option and case all seeds gave the same values. Their runs are "
            "counted as if they were independent and are not: intervals and p values are too "
            "small. Let the seed matter (variation in the scenario, noise of sensors, random "
            "arrivals), or read the table as one run per combination.",
        " class=\"warning\"");
  }

  /// Those that are no leaders.
  std::vector<std::string> namesOf(const MetricComparison& comparison, Standing standing) const {
    std::vector<std::string> names;
    for (std::size_t option = 0; option < study_.options.size(); ++option) {
      if (!comparison.leads(option) && comparison.standings[option] == standing) {
        names.push_back(study_.options[option]);
      }
    }
    return names;
  }

  /// "Path length: best is dwa (7.1 m), better than pursuit; not clearly different from mppi."
  std::string finding(const MetricComparison& comparison) const {
    if (!comparison.best) {
      return {};
    }
    const Metric& metric = study_.metrics[comparison.metric];
    const double best = comparison.estimates[*comparison.best].mean;
    std::vector<std::string> leaders;  // the best, and who equals it
    for (std::size_t option = 0; option < study_.options.size(); ++option) {
      if (comparison.leads(option)) {
        leaders.push_back(study_.options[option]);
      }
    }
    const std::vector<std::string> beaten = namesOf(comparison, Standing::Beaten);
    const std::vector<std::string> close = namesOf(comparison, Standing::Close);
    const std::vector<std::string> ahead = namesOf(comparison, Standing::Ahead);
    const std::vector<std::string> pieces = namesOf(comparison, Standing::NoSuccess);
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
    add(beaten, "better than " + (beatsAll ? "all others" : someOf(beaten)));
    add(close, "not clearly different from " + someOf(close));
    add(ahead, "but " + someOf(ahead) + (ahead.size() == 1 ? " is" : " are") +
                   " better on the same cases and seeds");
    add(pieces, someOf(pieces) +
                    (pieces.size() == 1 ? " never succeeds and is" : " never succeed and are") +
                    " left out");
    return words + ".";
  }

  static std::string someOf(const std::vector<std::string>& names) {
    constexpr std::size_t kMostNames = 6;
    return names.size() > kMostNames ? std::to_string(names.size()) + " others"
                                     : escaped(base::join(names, ", "));
  }

  void writeResults() {
    section("results", "Results");
    add(resultsTable(study_, comparisons_, weights_));
    add(ratesFigure(study_, comparisons_));
    add(intervalsFigure(study_, comparisons_));
    add(mediansTable(study_, comparisons_));
  }

  void writeFigures() {
    const std::optional<Figure> distribution = distributionFigure(study_, comparisons_);
    if (distribution) {
      section("distributions", "All runs");
      add(distribution);
    }
    if (study_.pareto) {
      const std::optional<Figure> front = paretoFigure(study_, comparisonOf(study_.pareto->first),
                                                       comparisonOf(study_.pareto->second));
      if (front) {
        section("pareto", "Trade-off");
        add(front);
      }
    }
  }

  MetricComparison comparisonOf(std::size_t metric) const {
    for (const MetricComparison& comparison : comparisons_) {
      if (comparison.metric == metric) {
        return comparison;
      }
    }
    return compare(study_, metric, blocks_);
  }

  void writePairs() {
    if (study_.options.size() < 2) {
      return;
    }
    section("pairs", "Paired comparisons");
    add(differencesFigure(study_, comparisons_));
    const Table all = pairsTable(study_, comparisons_, true);
    body_ += tableHtml(pairsTable(study_, comparisons_, false));
    report_.tables.push_back(all);
    const std::optional<Table> family = familyTable(study_, comparisons_);
    if (family) {
      section("ranks", "All options at once");
      add(ranksFigure(study_, comparisons_));
      add(family);
    }
  }

  void writeCases() {
    if (study_.cases.size() < 2) {
      return;
    }
    const auto judged = std::find_if(study_.shown.begin(), study_.shown.end(), [this](auto metric) {
      return study_.metrics[metric].sense != 0;
    });
    if (judged == study_.shown.end()) {
      return;
    }
    const std::optional<Figure> figure = difficultyFigure(study_, *judged);
    if (figure) {
      section("difficulty", "Difficulty");
      add(figure);
    }
  }

  void writeRuns() {
    const std::optional<Figure> ways = waysFigure(study_, pictures_);
    const std::optional<Figure> contacts = contactsFigure(study_, pictures_);
    if (ways || contacts) {
      section("trajectories", "On the map");
      add(ways);
      add(contacts);
    }
  }

  void writeFailures() {
    std::vector<std::size_t> played;
    std::vector<std::string> data;
    for (const RunPicture& picture : pictures_.runs) {
      if (!picture.player.empty()) {
        played.push_back(picture.run);
        data.push_back(picture.player);
      }
    }
    constexpr std::size_t kMostRows = 200;
    const bool isCut = failures_.size() > kMostRows;
    std::vector<std::size_t> told = failures_;
    told.resize(std::min(told.size(), kMostRows));
    section("failures", "Failures");
    if (!knowsSuccess_ && failures_.empty()) {
      body_ += paragraph("No run ended with an error; success is not measured here.");
    } else if (failures_.empty()) {
      body_ += paragraph("Every run succeeded.");
    } else {
      Table table = failuresTable(study_, told, played);
      table.caption = counted(failures_.size(), "run") + " of " +
                      std::to_string(study_.runCount()) + " without success" +
                      (isCut ? "; the first " + std::to_string(kMostRows) +
                                   " are listed, the others are in tables/failures.csv."
                             : ".") +
                      playedFailuresText(pictures_, failures_) +
                      " The command shows the run in the window." +
                      (study_.knowsRunWords || areAllKept(told)
                           ? ""
                           : " What the experiment sets for all runs (duration, "
                             "dt …) is not in it: the file of the "
                             "experiment is gone or has changed.");
      body_ += tableHtml(table, "failures");
      report_.tables.push_back(failuresTable(study_, failures_, {}));
      report_.tables.back().caption = "Runs without success.";
    }
    if (pictures_.kept == 0) {
      body_ += paragraph(
          "No folders of runs were kept, so no run can be drawn or played here (record: all in the "
          "experiment keeps them, record: unsuccessful those of runs without success).");
    }
    hasPlayer_ = !data.empty();
    if (hasPlayer_) {
      const std::string others = playedOthersText(pictures_, failures_);
      body_ += (others.empty() ? "" : paragraph(others, " class=\"played\"")) + playerMarkup(data);
    }
  }

  bool areAllKept(const std::vector<std::size_t>& runs) const {
    return std::all_of(runs.begin(), runs.end(),
                       [this](std::size_t run) { return study_.runFolder(run).has_value(); });
  }

  void writeMethods() {
    section("methods", "Methods");
    for (const char* words : kMethods) {
      body_ += paragraph(words);
    }
    body_ += paragraph("Intervals are of " + levelText(study_.level) + ", " +
                       std::to_string(study_.resamples) +
                       " resamples of the bootstrap, seed 1. Blocks are cases with one seed; " +
                       std::to_string(blocks_.size()) + " here.");
    std::string facts;
    const auto fact = [&facts](const std::string& name, const std::string& value) {
      if (!value.empty()) {
        facts += element("dt", "", escaped(name)) +
                 element("dd", "", element("code", "", escaped(value))) + "\n";
      }
    };
    fact("Batch by", study_.version.empty() ? std::string("not known (no manifest)")
                                            : "hunavsim " + study_.version + " " + study_.commit);
    fact("Report by", "hunavsim " + app::programVersion() + " " + app::programCommit());
    fact("results.csv", study_.resultsHash);
    for (const Study::Input& input : study_.inputs) {
      fact(input.path, input.sha256);
    }
    fact("Seeds", seedsText());
    fact("Drawn for each scenario and seed", base::join(study_.drawn, ", "));
    fact("Part of a study", study_.shard.empty() ? "" : "shard " + study_.shard);
    body_ += element("dl", "", "\n" + facts) + "\n";
    std::string commands;
    if (!study_.inputs.empty()) {
      commands += shellText(study_.batchWords()) + "\n";
    }
    commands += shellText(command_);
    body_ += "<pre>" + element("code", "", escaped(commands)) + "</pre>\n";
  }

  /// "1 to 20", or a list.
  std::string seedsText() const {
    std::set<long long> seeds;
    for (const Results::Run& run : study_.results.runs) {
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

  static constexpr const char* kMethods[] = {
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
      "p values are adjusted by Holm's method over all pairs of one metric. The typical difference "
      "is the estimate of Hodges and Lehmann with its interval (of rates the difference with the "
      "paired score interval, Newcombe 1998), the effect size is Cliff's delta over all values. "
      "Several metrics are "
      "several families: the chance of a false finding holds for each of them.",
      "With three options or more Friedman's test comes first (with ties; F of Iman and Davenport "
      "1980), and mean ranks are compared by Nemenyi's critical difference (Demšar 2006). The "
      "number of pairs that would be enough is Noether's (1987) for the signed-rank test among the "
      "pairs that differ, over their share; for rates, and where half of the pairs or more tie, "
      "Connor's (1987) for McNemar's test of the signs."};

  const Study& study_;
  const std::vector<std::pair<std::string, double>>& weights_;
  const std::vector<std::string>& command_;
  const OnStep& onStep_;
  std::vector<std::vector<std::size_t>> blocks_;
  Comparisons comparisons_;
  std::vector<std::size_t> failures_;
  RunPictures pictures_;
  Report report_;
  std::string head_, body_;
  std::vector<std::pair<std::string, std::string>> sections_;
  bool knowsSuccess_ = false, hasPlayer_ = false;
};

}  // namespace

std::string wholePage(const std::string& title, const std::string& body, bool withPlayer) {
  std::string page = kPageText;
  page = replaced(page, "{{title}}", escaped(title));
  page = replaced(page, "{{style}}", kStyleText);
  page = replaced(page, "{{script}}", std::string(kReportText) + (withPlayer ? kPlayerText : ""));
  return replaced(page, "{{body}}", body);  // last: it may hold anything
}

std::string playerMarkup(const std::vector<std::string>& runs) {
  std::string data;
  for (const std::string& run : runs) {
    data += (data.empty() ? "" : ",\n") + scriptSafe(run);
  }
  return "<div class=\"player\">\n<header><select aria-label=\"Run\"></select>"
         "<b>Run</b><span>&#160;</span></header>\n"
         "<canvas></canvas>\n<div class=\"controls\"><button type=\"button\" "
         "class=\"toggle\">Play</button><input type=\"range\" min=\"0\" max=\"1\" value=\"0\" "
         "aria-label=\"Time\"/><output>0</output><select aria-label=\"Speed\">"
         "<option value=\"0.5\">0.5×</option><option value=\"1\" selected=\"selected\">1×</option>"
         "<option value=\"2\">2×</option><option value=\"4\">4×</option>"
         "<option value=\"10\">10×</option></select></div>\n<ul class=\"events\"></ul>\n</div>\n"
         "<script type=\"application/json\" id=\"replays\">[" +
         data + "]</script>\n";
}

std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title) {
  const double seconds = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const std::string body =
      element("h1", "", escaped(title)) + "\n" +
      paragraph((trace.header.humans.size() == 1
                     ? std::string("1 person")
                     : std::to_string(trace.header.humans.size()) + " people") +
                    ", " + counted(trace.header.robots.size(), "robot") + ", " +
                    numberText(seconds, 1) + " s, seed " + std::to_string(trace.header.seed) + ".",
                " class=\"lead\"") +
      playerMarkup({playerJson(trace, contacts, {title}, kFineStep)}) +
      paragraph("Made by hunavsim " + app::programVersion() + " " + app::programCommit() + ".",
                " class=\"lead\"");
  return wholePage(title, body, true);
}

Report makeReport(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
                  const std::vector<std::string>& command, const OnStep& onStep) {
  return PageMaker(study, weights, command, onStep).make();
}

}  // namespace report
