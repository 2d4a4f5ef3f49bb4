#include "app/report/SearchPage.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::SavedFailure;
using app::SearchedRun;
using app::SearchStudy;

constexpr double kSearchWidth = 720.0;  // [px]

std::string playFailureCommand(const std::string& folder, const SavedFailure& failure) {
  const std::string file = (std::filesystem::path(folder) / failure.file).string();
  return "hunavsim " + base::shellWord(file);
}

std::string remainingChangesText(const SavedFailure& failure) {
  std::vector<std::string> changes;
  for (const std::string& setting : failure.shrunk.request.spec.set) {
    if (!app::isEntityList(setting)) {
      changes.push_back(setting);
    }
  }
  return changes.empty() ? std::string("–") : base::join(changes, ", ");
}

Table foundFailuresTable(const SearchStudy& study, const std::string& folder) {
  Table table;
  table.name = "failures";
  table.caption =
      "One failure of each kind, with the fewest people and changes that still fail in the same "
      "way. The command opens it in the window; hunavsim run FILE repeats it.";
  table.columns = {{"Kind", {}, false},    {"Run", {}, true},       {"Scenario", {}, false},
                   {"Seed", {}, true},     {"People", {}, true},    {"End", "s", true},
                   {"Changes", {}, false}, {"Repeated", {}, false}, {"Play", {}, false}};
  for (const SavedFailure& failure : study.failures) {
    const app::ShrunkFailure& shrunk = failure.shrunk;
    const SearchedRun& run = study.result.runs[failure.run];
    const std::string before = "of " + std::to_string(shrunk.peopleBefore);
    const double end = base::parseDouble(shrunk.row.simulated).value_or(std::nan(""));
    table.rows.push_back({{failure.kind.text(), shrunk.row.reason},
                          {std::to_string(failure.run)},
                          {study.experiment->scenarios[study.space->scenarioOf(run.candidate)]},
                          {std::to_string(shrunk.request.seed)},
                          {std::to_string(shrunk.people), before},
                          numberCell(numberText(end, 1), end),
                          {remainingChangesText(failure)},
                          {failure.isRepeated ? "yes" : "no"},
                          commandCell(playFailureCommand(folder, failure))});
  }
  return table;
}

std::string archiveCellLabel(const app::Descriptor& descriptor, int cell) {
  if (cell == app::Descriptor::kUndefinedCell) {
    return "none";
  }
  const double width = (descriptor.high - descriptor.low) / descriptor.cells;
  return numberText(descriptor.low + width * cell, width < 0.995 ? 2 : 1);
}

/// The cells of the archive: a disc in cells with a failure, the fitness as opacity.
Figure archiveFigure(const SearchStudy& study) {
  const app::EliteArchive& archive = study.result.archive;
  const auto& [across, up] = archive.descriptors();
  constexpr double kLeft = 70.0, kTop = 10.0, kCellHeight = 22.0;
  const double cellWidth = (kSearchWidth - kLeft - 10.0) / (across.cells + 1);
  const double bottom = kTop + kCellHeight * (up.cells + 1);
  Figure figure("archive", kSearchWidth, bottom + 40.0);
  double low = 0.0, high = 0.0;
  bool isFirst = true;
  for (const auto& [cell, elite] : archive.elites()) {
    low = isFirst ? elite.fitness : std::min(low, elite.fitness);
    high = isFirst ? elite.fitness : std::max(high, elite.fitness);
    isFirst = false;
  }
  for (const auto& [cell, elite] : archive.elites()) {  // undefined cells come first
    const double x = kLeft + cellWidth * (cell[0] + 1), y = bottom - kCellHeight * (cell[1] + 2);
    const double share = high > low ? (elite.fitness - low) / (high - low) : 1.0;
    figure.rect(x + 1.0, y + 1.0, cellWidth - 2.0, kCellHeight - 2.0, "heat", 0.15 + 0.6 * share);
    if (study.result.runs[elite.run].kind) {
      figure.disc(x + cellWidth / 2.0, y + kCellHeight / 2.0, 4.0, "ink");
    }
  }
  for (int cell = app::Descriptor::kUndefinedCell; cell < across.cells; ++cell) {
    figure.text(kLeft + cellWidth * (cell + 1), bottom + 14.0, archiveCellLabel(across, cell),
                "dim");
  }
  for (int cell = app::Descriptor::kUndefinedCell; cell < up.cells; ++cell) {
    figure.text(kLeft - 6.0, bottom - kCellHeight * (cell + 1) - 6.0, archiveCellLabel(up, cell),
                "dim", Figure::Anchor::End);
  }
  figure.text(kLeft, bottom + 32.0, across.key + " →", "ink");
  figure.caption = "The archive: " + across.key + " to the right, " + up.key +
                   " upwards, labels at the lower end of each cell. Darker cells have a better "
                   "run for the search; a dot marks a failure.";
  return figure;
}

/// Best fitness and number of kinds after each run.
Figure courseFigure(const SearchStudy& study) {
  const std::vector<SearchedRun>& runs = study.result.runs;
  constexpr double kLeft = 60.0, kTop = 10.0, kHeight = 160.0;
  std::vector<double> best;
  for (const SearchedRun& run : runs) {
    const double former = best.empty() ? -std::numeric_limits<double>::infinity() : best.back();
    best.push_back(std::max(former, run.fitness));
  }
  Figure figure("course", kSearchWidth, kTop + kHeight + 40.0);
  const auto first =
      std::find_if(best.begin(), best.end(), [](double value) { return std::isfinite(value); });
  figure.caption = "Best fitness after each run" +
                   std::string(study.plan.worst.empty()
                                   ? ": above 1 for failures, below it for runs that came near one."
                                   : ": " + study.plan.worst + " in its worse direction.");
  if (first == best.end() || !std::isfinite(best.back())) {
    return figure;
  }
  const Scale across{0.0, std::max(1.0, static_cast<double>(runs.size()) - 1.0), kLeft,
                     kSearchWidth - 10.0};
  const Scale up = paddedScale(*first, best.back(), kTop + kHeight, kTop);
  std::vector<base::Vec2> points;
  for (std::size_t k = 0; k < best.size(); ++k) {
    if (std::isfinite(best[k])) {
      points.emplace_back(across.at(static_cast<double>(k)), up.at(best[k]));
    }
  }
  verticalAxis(figure, up, ticks(up.low, up.high, 5), kLeft, kSearchWidth - 10.0);
  horizontalAxis(figure, across, kTop + kHeight);
  figure.polyline(points, strokeOf(0), 1.5);
  return figure;
}

std::string searchLeadText(const SearchStudy& study) {
  const app::SearchResult& result = study.result;
  std::string text =
      counted(result.runs.size(), "run") + " of " +
      counted(study.experiment->scenarios.size(), "scenario") + "; " +
      (study.failures.size() == 1 ? std::string("1 kind of failure")
                                  : std::to_string(study.failures.size()) + " kinds of failures") +
      ".";
  const auto excused = std::count_if(result.runs.begin(), result.runs.end(),
                                     [](const SearchedRun& run) { return run.isUnavoidable; });
  if (excused > 0) {
    text += " " + counted(static_cast<std::size_t>(excused), "contact") +
            " could not have been avoided from the first sight on and did not count.";
  }
  if (result.notSimulated > 0) {
    text += " " + counted(result.notSimulated, "run") + " could not start: " + result.firstProblem;
  }
  return text;
}

void addWorstRun(const SearchStudy& study, const std::string& folder, PageParts& page) {
  const SearchedRun& run = study.result.runs[study.worst->run];
  const std::string scenario = study.experiment->scenarios[study.space->scenarioOf(run.candidate)];
  page.section("worst", "Worst run");
  page.body +=
      paragraph(study.plan.worst + " = " + base::formatDouble(run.value) + " in run " +
                std::to_string(study.worst->run) + " (" + scenario + ", seed " +
                std::to_string(study.space->seedOf(run.candidate)) + ").") +
      element("p", "", element("code", "", escaped(playFailureCommand(folder, *study.worst)))) +
      "\n";
}

constexpr const char* kSearchMethods =
    "Candidates: CMA-ES with restarts (Hansen, arXiv:1604.00772) and the improvement emitter of "
    "CMA-ME (Fontaine et al. 2020, arXiv:1912.02400) over the continuous values, in an archive of "
    "elites (Mouret & Clune 2015, arXiv:1504.04909). Failures are shrunk by delta debugging "
    "(Zeller & Hildebrandt 2002).";

}  // namespace

std::string searchPage(const SearchStudy& study, const std::string& folder,
                       const std::vector<std::string>& command) {
  const std::string title =
      "Search of " + std::filesystem::path(study.experiment->path).filename().string();
  PageParts page;
  if (study.worst) {
    addWorstRun(study, folder, page);
  }
  page.section("failures", "Failures");
  if (study.failures.empty()) {
    page.body += paragraph("No run failed.");
  } else {
    page.add(foundFailuresTable(study, folder), "failures");
  }
  page.section("archive", "Archive");
  page.add(archiveFigure(study));
  page.section("course", "Course");
  page.add(courseFigure(study));
  page.section("methods", "Methods");
  page.body += paragraph(kSearchMethods) + provenanceMarkup({}, command);
  return page.page(title, searchLeadText(study), {});
}

}  // namespace report
