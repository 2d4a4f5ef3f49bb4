#include "app/report/Page.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/report/Findings.h"
#include "app/report/Methods.h"
#include "app/report/PlayerPage.h"
#include "app/report/PlotParts.h"
#include "app/report/Plots.h"
#include "app/report/Tables.h"
#include "app/run/ResultRow.h"

namespace report {

namespace {

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
      const std::string words = findingMarkup(study_, comparison);
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
    if (const auto byCase = casePairsTable(study_, comparisons_, false)) {
      body_ += tableHtml(*byCase);
      report_.tables.push_back(*casePairsTable(study_, comparisons_, true));
    }
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
    body_ += methodsMarkup(study_, blocks_.size(), command_);
  }

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

Report makeReport(const Study& study, const std::vector<std::pair<std::string, double>>& weights,
                  const std::vector<std::string>& command, const OnStep& onStep) {
  return PageMaker(study, weights, command, onStep).make();
}

}  // namespace report
