#include "app/report/Page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "app/report/ContactTables.h"
#include "app/report/CoverageTable.h"
#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "app/report/PlayerPage.h"
#include "app/report/Plots.h"
#include "app/report/Tables.h"
#include "app/report/Verdict.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

/// The markup of the methods section: procedures with references, versions and inputs, and the
/// commands. `blocks`: number of blocks; `tests`: number of paired tests over all cases; `command`:
/// the command line of this report.
std::string methodsMarkup(const Study& study, std::size_t blocks, std::size_t tests,
                          const std::vector<std::string>& command) {
  const std::string batch =
      study.inputs.empty() ? std::string() : shellText(study.batchCommand()) + "\n";
  return filled(kMethodsText,
                {{"level", levelText(study.level)},
                 {"resamples", std::to_string(study.resamples)},
                 {"blocks", std::to_string(blocks)},
                 {"tests", std::to_string(tests)},
                 {"provenance", provenanceMarkup(study, batch + shellText(command))}});
}

/// Creates the page of a study section by section.
class PageBuilder {
 public:
  PageBuilder(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
              const std::vector<std::string>& command, const ProgressCallback& onProgress)
      : study_(study), weights_(weights), command_(command), onProgress_(onProgress) {}

  Report make() {
    struct Step {
      const char* what;
      void (PageBuilder::*work)();
    };
    constexpr Step kSteps[] = {
        {"comparing", &PageBuilder::compareOptions}, {"reading runs", &PageBuilder::readRuns},
        {"results", &PageBuilder::writeResults},     {"figures", &PageBuilder::writeFigures},
        {"pairs", &PageBuilder::writePairs},         {"cases", &PageBuilder::writeCases},
        {"maps", &PageBuilder::writeRuns},           {"failures", &PageBuilder::writeFailures},
        {"contacts", &PageBuilder::writeContacts},   {"trees", &PageBuilder::writeTrees},
        {"methods", &PageBuilder::writeMethods},     {"tables", &PageBuilder::writePage}};
    for (const Step& step : kSteps) {
      reportProgress(step.what);
      (this->*step.work)();
    }
    return std::move(parts_.report);
  }

 private:
  void reportProgress(const std::string& what) const {
    if (onProgress_) {
      onProgress_(what);
    }
  }

  void compareOptions() {
    blocks_ = blocksOf(study_);
    for (const std::size_t metric : study_.shown) {
      reportProgress("comparing " + study_.metrics[metric].name);
      comparisons_.push_back(compare(study_, metric, blocks_));
    }
    adjustTogether(study_, comparisons_);
  }

  void readRuns() {
    findFailures();
    pictures_ = readRunPictures(study_, failures_);
    parts_.report.problems = pictures_.problems;
    writeNotes();
  }

  void writePage() {
    parts_.report.moreTables.emplace_back("all_metrics", allMetricsCsv(study_));
    parts_.report.html = parts_.page(study_.title, leadText() + tablesText(), notes_, hasPlayer_);
  }

  /// Finds the runs that ended with an error or without success.
  void findFailures() {
    const std::size_t none = study_.results.keys.size();
    std::size_t key = none;
    for (const char* name : app::kSuccessKeys) {
      key = key < none ? key : study_.results.keyAt(name);
    }
    for (std::size_t run = 0; run < study_.runCount(); ++run) {
      const bool hasKey = key < none;
      hasSuccessMetric_ = hasSuccessMetric_ || (hasKey && !std::isnan(study_.valuesOf(key)[run]));
      if (!study_.results.runs[run].ok || (hasKey && study_.valuesOf(key)[run] == 0.0)) {
        failures_.push_back(run);
      }
    }
  }

  /// A section with these figures; nothing without figures.
  void addSection(const char* id, const char* title,
                  const std::vector<std::optional<Figure>>& figures) {
    bool isBegun = false;
    for (const std::optional<Figure>& figure : figures) {
      if (figure && !std::exchange(isBegun, true)) {
        parts_.section(id, title);
      }
      parts_.add(figure);
    }
  }

  /// The sentence below the title.
  std::string leadText() const {
    std::set<long long> seeds;
    std::set<std::string> scenarios;
    for (const Results::Run& run : study_.results.runs) {
      seeds.insert(run.seed);
      scenarios.insert(run.scenario);
    }
    const std::string compared =
        std::to_string(study_.options.size()) + " options of " + study_.compared + " compared";
    return counted(study_.runCount(), "run") + " of " + counted(scenarios.size(), "scenario") +
           " with " + counted(seeds.size(), "seed") +
           (study_.options.size() > 1 ? ", " + compared : "") + ".";
  }

  /// Names the main tables: " Table 1: means and rates; Table 3: paired tests."
  std::string tablesText() const {
    constexpr std::pair<const char*, const char*> kTables[] = {
        {"results", "means and rates"},
        {"pairs", "paired tests"},
        {"pairs_by_case", "paired tests by case"},
        {"failures", "runs without success"}};
    std::vector<std::string> words;
    for (const auto& [name, what] : kTables) {
      if (const std::size_t number = parts_.tableNumber(name); number > 0) {
        words.push_back("Table " + std::to_string(number) + ": " + what);
      }
    }
    return words.empty() ? std::string() : " " + base::join(words, "; ") + ".";
  }

  void writeNotes() {
    notes_ += verdictMarkup(study_, comparisons_);
    if (!study_.shard.empty()) {
      notes_ += paragraph("This report contains only the runs of shard " + study_.shard +
                          " of the study; merge joins all shards.");
    }
    if (study_.status == "interrupted") {
      notes_ +=
          paragraph("The batch was interrupted; this report contains only the finished runs.");
    }
    if (!study_.until.empty()) {
      notes_ += paragraph("The batch ended after " + std::to_string(study_.enoughSeeds) +
                          " seeds: " + study_.until +
                          ". The intervals and p values of this page do not take into account "
                          "that the number of seeds depended on the results.");
    }
    if (!study_.changedInputs.empty()) {
      notes_ += paragraph("Changed after the runs: " + base::join(study_.changedInputs, ", ") +
                              ". The results belong to the earlier content of these files.",
                          " class=\"warning\"");
    }
    writeSeedWarning();
    std::string findings;
    for (const MetricComparison& comparison :
         isOneRunPerCell(study_) ? Comparisons() : comparisons_) {
      const std::string words = findingMarkup(study_, comparison);
      findings += words.empty() ? "" : element("li", "", words) + "\n";
    }
    if (!findings.empty()) {
      notes_ += element("ul", "", "\n" + findings) + "\n";
    }
    writeInputWarnings();
  }

  /// Lists the warnings for the inputs: of each kind the first, with the number of all.
  void writeInputWarnings() {
    constexpr std::size_t kMostKinds = 8;
    std::map<std::string_view, std::size_t> counts;
    for (const base::Diagnostic& problem : study_.inputWarnings) {
      ++counts[problem.code];
    }
    std::string items;
    std::set<std::string_view> listed;
    for (const base::Diagnostic& problem : study_.inputWarnings) {
      if (listed.size() < kMostKinds && listed.insert(problem.code).second) {
        const std::size_t more = counts[problem.code] - 1;
        items += element("li", "",
                         escaped(problem.text()) +
                             (more > 0 ? " (and " + std::to_string(more) + " of the same kind)"
                                       : std::string())) +
                 "\n";
      }
    }
    if (!items.empty()) {
      notes_ += paragraph("The inputs of this study have " +
                              counted(study_.inputWarnings.size(), "warning") +
                              (counts.size() > kMostKinds
                                   ? " of " + std::to_string(counts.size()) + " kinds, the first " +
                                         std::to_string(kMostKinds) + ":"
                                   : std::string(":")),
                          " class=\"warning\"") +
                element("ul", "", "\n" + items) + "\n";
    }
  }

  /// Warns about runs that are identical for all seeds.
  void writeSeedWarning() {
    std::vector<std::string> constant = constantCells(study_);
    if (constant.empty()) {
      return;
    }
    constexpr std::size_t kMostNames = 6;
    const std::size_t count = constant.size();
    if (count > kMostNames) {
      constant.resize(kMostNames);
      constant.emplace_back("…");
    }
    notes_ += paragraph(
        "In " + counted(count, "combination") + " of option and case (" +
            base::join(constant, "; ") +
            "), all seeds gave the same values, within 0.1 %, in every column. The tables and "
            "figures below count these runs as independent, but they are not a sample: confidence "
            "intervals and p values say nothing. Make the runs depend on the seed (key variation "
            "of the scenario, sensor noise, random arrivals), or interpret the tables as one run "
            "per combination.",
        " class=\"warning\"");
  }

  void writeResults() {
    parts_.section("results", "Results");
    parts_.add(resultsTable(study_, comparisons_, weights_));
    parts_.add(intervalsFigure(study_, comparisons_, true));
    parts_.add(intervalsFigure(study_, comparisons_, false));
    parts_.add(mediansTable(study_, comparisons_));
  }

  void writeFigures() {
    addSection("distributions", "Distributions", {distributionFigure(study_, comparisons_)});
    if (study_.pareto) {
      addSection("pareto", "Trade-off",
                 {paretoFigure(study_, comparisonOf(study_.pareto->first),
                               comparisonOf(study_.pareto->second))});
    }
  }

  MetricComparison comparisonOf(std::size_t metric) const {
    const auto* const known = base::findBy(comparisons_, &MetricComparison::metric, metric);
    return known != nullptr ? *known : compare(study_, metric, blocks_);
  }

  void writePairs() {
    if (study_.options.size() < 2) {
      return;
    }
    parts_.section("pairs", "Paired comparisons");
    parts_.add(differencesFigure(study_, comparisons_));
    parts_.add(pairsTable(study_, comparisons_, false), pairsTable(study_, comparisons_, true));
    if (const auto byCase = casePairsTable(study_, comparisons_, false)) {
      parts_.add(*byCase, *casePairsTable(study_, comparisons_, true));
    }
    const std::optional<Table> family = familyTable(study_, comparisons_);
    if (family) {
      parts_.section("ranks", "Comparison of all options");
      parts_.add(ranksFigure(study_, comparisons_));
      parts_.add(family);
    }
  }

  void writeCases() {
    if (study_.cases.size() < 2) {
      return;
    }
    const auto* const judged = base::findIf(
        study_.shown, [this](std::size_t metric) { return study_.metrics[metric].sense != 0; });
    if (judged != nullptr) {
      addSection("difficulty", "Difficulty", {difficultyFigure(study_, *judged)});
    }
  }

  void writeRuns() {
    addSection("trajectories", "Paths and contacts",
               {pathsFigure(study_, pictures_), contactsFigure(study_, pictures_)});
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
    constexpr std::size_t kMaxRows = 200;
    const bool isCut = failures_.size() > kMaxRows;
    std::vector<std::size_t> listed = failures_;
    listed.resize(std::min(listed.size(), kMaxRows));
    parts_.section("failures", "Failures");
    if (!hasSuccessMetric_ && failures_.empty()) {
      parts_.body += paragraph("No run ended with an error; no metric measures success.");
    } else if (failures_.empty()) {
      parts_.body += paragraph("Every run succeeded.");
    } else {
      Table table = failuresTable(study_, listed, played);
      table.caption =
          counted(failures_.size(), "run") + " of " + std::to_string(study_.runCount()) +
          " without success" +
          (isCut ? "; the first " + std::to_string(kMaxRows) +
                       " are listed; tables/failures.csv contains all."
                 : ".") +
          playedFailuresText(pictures_, failures_) + " The command opens the run in the window." +
          (study_.hasRunOptions || areAllKept(listed)
               ? ""
               : " It lacks the options that the experiment sets for all runs (duration, dt …), "
                 "because the experiment file is missing or has changed.");
      Table all = failuresTable(study_, failures_, {});
      all.caption = "Runs without success.";
      parts_.add(table, std::move(all), "failures");
    }
    if (pictures_.kept == 0) {
      parts_.body += paragraph(
          "No run folders were kept, so runs cannot be drawn or played here. To keep them, set "
          "record: all in the experiment, or record: unsuccessful to keep only runs without "
          "success.");
    }
    hasPlayer_ = !data.empty();
    if (hasPlayer_) {
      const std::string others = playedOthersText(pictures_, failures_);
      parts_.body +=
          (others.empty() ? "" : paragraph(others, " class=\"played\"")) + playerMarkup(data);
    }
  }

  bool areAllKept(const std::vector<std::size_t>& runs) const {
    return std::all_of(runs.begin(), runs.end(),
                       [this](std::size_t run) { return study_.runFolder(run).has_value(); });
  }

  void writeContacts() { addContactsSection(study_, parts_); }

  void writeTrees() {
    if (const std::optional<Table> table = coverageTable(study_.trees, false)) {
      parts_.section("trees", "Behaviour trees");
      parts_.add(*table, *coverageTable(study_.trees, true));
    }
  }

  void writeMethods() {
    parts_.section("methods", "Methods");
    parts_.body += methodsMarkup(study_, blocks_.size(), testCounts(comparisons_).pairs, command_);
  }

  const Study& study_;
  const std::vector<std::pair<std::string, double>>& weights_;
  const std::vector<std::string>& command_;
  const ProgressCallback& onProgress_;
  std::vector<std::vector<std::size_t>> blocks_;
  Comparisons comparisons_;
  std::vector<std::size_t> failures_;
  RunPictures pictures_;
  PageParts parts_;
  std::string notes_;
  bool hasSuccessMetric_ = false, hasPlayer_ = false;
};

}  // namespace

Report makeReport(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
                  const std::vector<std::string>& command, const ProgressCallback& onProgress) {
  return PageBuilder(study, weights, command, onProgress).make();
}

std::string methodsPage(const Study& study, const std::vector<std::string>& command) {
  const std::vector<std::vector<std::size_t>> blocks = blocksOf(study);
  Comparisons comparisons;
  for (const std::size_t metric : study.shown) {
    comparisons.push_back(compare(study, metric, blocks));
  }
  const std::string heading =
      element("h1", "", escaped(study.title)) + element("h2", "", "Methods");
  return htmlPage(
      study.title,
      heading + methodsMarkup(study, blocks.size(), testCounts(comparisons).pairs, command), false);
}

}  // namespace report
