#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/report/Comparison.h"
#include "app/report/Plots.h"
#include "app/report/TuneReport.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::TuneCandidate;
using app::TuneDifference;
using TuneCell = Table::Cell;

TuneCell differenceCell(const TuneDifference& of) {
  const int decimals = decimalsFor(of.difference, of.interval);
  return {signedNumberText(of.difference, decimals), intervalText(of.interval, decimals)};
}

TuneCell tuneValueCell(double value, const TuneDifference& of) {
  return {numberText(value, decimalsFor(of.before, of.interval))};
}

TuneCell percentCell(double share) {
  return {std::isnan(share) ? "–" : numberText(100.0 * share, 1) + " %"};
}

TuneCell ratePoints(const TuneDifference& of) {
  return {signedNumberText(100.0 * of.difference, 1) + " points",
          intervalText(of.interval, 1, 100.0)};
}

std::string titleOf(const app::TuneObjective& objective) {
  return objective.name + (objective.unit.empty() ? "" : " [" + objective.unit + "]");
}

std::string tuneScenarioName(const std::string& path) {
  return std::filesystem::path(path).stem().string();
}

double relativeSize(const TuneDifference& of) {
  return std::fabs(of.before) > 0.0 ? std::fabs(of.before) : statistics::kUndefined;
}

TuneCell relativeCell(const TuneDifference& of) {
  const double size = relativeSize(of);
  return {signedPercent(of.difference / size), intervalText(of.interval, 1, 100.0 / size)};
}

std::vector<TuneCell> objectiveRow(const std::string& title, const TuneDifference& of) {
  return {{title},
          tuneValueCell(of.before, of),
          tuneValueCell(of.after, of),
          differenceCell(of),
          relativeCell(of),
          {std::to_string(of.pairs)}};
}

/// The relative change of each objective [1].
std::vector<double> objectiveChanges(const app::TuneOptions& options, const app::TuneScore& score) {
  std::vector<double> changes;
  changes.reserve(options.objectives.size());
  for (std::size_t k = 0; k < options.objectives.size(); ++k) {
    changes.push_back(options.objectives[k].sign * (score.ratios[k] - 1.0));
  }
  return changes;
}

/// A column per objective, in its own unit.
void addObjectiveColumns(const app::TuneOptions& options, Table& table) {
  for (const app::TuneObjective& objective : options.objectives) {
    table.columns.push_back({objective.name, objective.unit});
  }
}

/// A column per objective, for cells of addChanges(), which end with "%".
void addChangeColumns(const app::TuneOptions& options, Table& table) {
  for (const app::TuneObjective& objective : options.objectives) {
    table.columns.push_back({objective.name, ""});
  }
}

void addChanges(const app::TuneOptions& options, const app::TuneScore& score,
                std::vector<TuneCell>& row) {
  for (const double change : objectiveChanges(options, score)) {
    row.push_back({signedPercent(change)});
  }
}

/// A candidate that was run on all runs of the search, in the plane of the two objectives.
struct FrontPoint {
  base::Vec2 changes;  // of the objectives [%]
  bool isOnFront = false, isChosen = false, isBefore = false;
};

std::vector<FrontPoint> frontPoints(const app::TuneOptions& options,
                                    const app::TuneResult& result) {
  std::vector<FrontPoint> points;
  for (const TuneCandidate& candidate : result.candidates) {
    if (candidate.isComplete) {
      const std::vector<double> changes = objectiveChanges(options, candidate.score);
      points.push_back({{100.0 * changes[0], 100.0 * changes[1]},
                        candidate.isOnFront,
                        result.chosen && candidate.values == *result.chosen,
                        candidate.generation < 0});
    }
  }
  return points;
}

void drawFrontPoint(Figure& figure, const FrontPoint& point, const base::Vec2& at) {
  figure.disc(at.x(), at.y(), 3.0, point.isOnFront ? "heat" : "dim", point.isOnFront ? 1.0 : 0.5);
  if (point.isBefore || point.isChosen) {
    figure.mark(at.x(), at.y(), point.isChosen ? 1 : 0, 6.0);
    figure.text(at.x() + 9.0, at.y() - 7.0, point.isChosen ? "chosen" : "before");
  }
}

}  // namespace

std::string signedPercent(double share) {
  return std::isnan(share) ? "–" : signedNumberText(100.0 * share, 1) + " %";
}

std::string relativeText(const TuneDifference& difference) {
  const TuneCell cell = relativeCell(difference);
  return cell.text + (cell.below.empty() ? "" : " " + cell.below);
}

Table tuneEvaluationTable(const app::TuneOptions& options, const app::TuneResult& result) {
  const app::TuneEvaluation& made = *result.evaluation;
  Table table;
  table.name = "evaluation";
  table.caption = "Values before and after tuning on runs that the search has not seen: " +
                  counted(options.heldOut.size(), "scenario") + ", " +
                  counted(static_cast<std::size_t>(options.heldOutSeeds), "seed") +
                  " each. Differences after − before with 95 % intervals, paired by scenario and "
                  "seed; pairs in which a run failed are excluded from the objectives.";
  table.columns = {{"", "", false},    {"Before", ""},   {"After", ""},
                   {"Difference", ""}, {"Relative", ""}, {"Pairs", ""}};
  table.rows.push_back({{"Success"},
                        percentCell(made.success.before),
                        percentCell(made.success.after),
                        ratePoints(made.success),
                        {},
                        {std::to_string(made.success.pairs)}});
  for (std::size_t k = 0; k < options.objectives.size(); ++k) {
    table.rows.push_back(objectiveRow(titleOf(options.objectives[k]), made.objectives[k]));
  }
  return table;
}

Table tuneScenarioTable(const app::TuneOptions& options, const app::TuneResult& result) {
  Table table{"evaluation_by_scenario",
              "The same per scenario: differences after − before with 95 % intervals.",
              {{"Scenario", "", false}, {"Success", ""}},
              {}};
  addObjectiveColumns(options, table);
  for (std::size_t k = 0; k < options.heldOut.size(); ++k) {
    const auto& [success, objectives] = result.evaluation->scenarios[k];
    table.rows.push_back({{tuneScenarioName(options.heldOut[k])}, ratePoints(success)});
    for (const TuneDifference& of : objectives) {
      table.rows.back().push_back(differenceCell(of));
    }
  }
  return table;
}

Table tuneEffectsTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                       const app::TuneResult& result) {
  Table table{
      "effects",
      "What each change contributes: the candidate compared with itself without this change, on " +
          counted(result.chosenRuns, "run") +
          " of the search. Score: loss without the change, in percent of the current score. "
          "Differences with the change − without it, 95 % intervals. Changes that lose nothing "
          "when they are reverted together are not in the tuned file.",
      {{"Parameter", "", false}, {"Before", ""}, {"After", ""}, {"Score", ""}},
      {}};
  addObjectiveColumns(options, table);
  table.columns.push_back({"In the file", "", false});
  for (const app::TuneEffect& effect : result.effects) {
    const app::TunedParameter& parameter = subject.parameters()[effect.parameter];
    table.rows.push_back(
        {{parameter.label()}, {parameter.present}, {effect.value}, {signedPercent(effect.total)}});
    for (const TuneDifference& of : effect.differences) {
      table.rows.back().push_back(differenceCell(of));
    }
    table.rows.back().push_back({effect.isKept ? "yes" : "no"});
  }
  return table;
}

Table tuneParametersTable(const app::TuneSubject& subject, const app::TuneResult& result) {
  Table table{"parameters",
              "The parameters of the search.",
              {{"Parameter", "", false}, {"Range", "", false}, {"Before", ""}, {"Chosen", ""}},
              {}};
  for (std::size_t k = 0; k < subject.parameters().size(); ++k) {
    const app::TunedParameter& parameter = subject.parameters()[k];
    const std::string chosen = result.chosen ? (*result.chosen)[k] : parameter.present;
    TuneCell value{chosen};
    value.bold = chosen != parameter.present;
    table.rows.push_back({{parameter.label()},
                          {base::formatDouble(parameter.range.low) + " to " +
                           base::formatDouble(parameter.range.high) +
                           (parameter.range.isLogarithmic ? ", logarithmic" : "")},
                          {parameter.present},
                          value});
  }
  return table;
}

Table tuneProbeTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                     const app::TuneResult& result) {
  Table table{
      "probes",
      "Single parameters set to their defaults and to distant values, compared with the best "
      "values so far on the same runs (relative; a negative score is better). Few runs: only large "
      "effects are certain. The CMA-ES varied the parameters in bold.",
      {{"Parameter", "", false},
       {"From", ""},
       {"To", ""},
       {"Runs", ""},
       {"Score", ""},
       {"Standard error", ""}},
      {}};
  addChangeColumns(options, table);
  table.columns.push_back({"Failures", ""});
  for (const app::TuneProbe& probe : result.probes) {
    TuneCell name{subject.parameters()[probe.parameter].label()};
    name.bold = std::find(result.varied.begin(), result.varied.end(), probe.parameter) !=
                result.varied.end();
    table.rows.push_back({name,
                          {probe.from},
                          {probe.to},
                          {std::to_string(probe.runs)},
                          {signedPercent(probe.score.total - 1.0)},
                          percentCell(probe.score.error)});
    addChanges(options, probe.score, table.rows.back());
    table.rows.back().push_back(percentCell(probe.score.failures));
  }
  return table;
}

Table tuneFrontTable(const app::TuneOptions& options, const app::TuneSubject& subject,
                     const app::TuneResult& result) {
  Table table{"front",
              "Pareto-optimal candidates in the runs of the search (changes relative to the "
              "current values with the same seeds). The best of many candidates is selected, so "
              "these values are optimistic on average.",
              {},
              {}};
  addChangeColumns(options, table);
  table.columns.push_back({"Changed values", "", false});
  for (const TuneCandidate& candidate : result.candidates) {
    if (!candidate.isOnFront) {
      continue;
    }
    table.rows.emplace_back();
    addChanges(options, candidate.score, table.rows.back());
    std::vector<std::string> changes;
    for (std::size_t k = 0; k < candidate.values.size(); ++k) {
      const app::TunedParameter& parameter = subject.parameters()[k];
      if (candidate.values[k] != parameter.present) {
        changes.push_back(parameter.name + " " + candidate.values[k]);
      }
    }
    table.rows.back().push_back({changes.empty() ? "none (before)" : base::join(changes, ", ")});
  }
  return table;
}

std::optional<Figure> tuneFrontFigure(const app::TuneOptions& options,
                                      const app::TuneResult& result) {
  if (options.objectives.size() != 2) {
    return std::nullopt;
  }
  constexpr double kWidth = 720.0, kHeight = 360.0;
  const std::vector<FrontPoint> points = frontPoints(options, result);
  Extent wide, high;
  std::vector<base::Vec2> front;
  for (const FrontPoint& point : points) {
    wide.add(point.changes.x());
    high.add(point.changes.y());
  }
  const Scale x = paddedScale(wide.low, wide.high, 64.0, kWidth - 40.0);
  const Scale y = paddedScale(high.low, high.high, kHeight - 52.0, 34.0);
  Figure figure("front", kWidth, kHeight);
  verticalAxis(figure, y, ticks(y.low, y.high, 6), 64.0, kWidth - 40.0);
  horizontalAxis(figure, x, kHeight - 52.0);
  figure.text(64.0, 18.0, options.objectives[1].name + ", change in the search [%]");
  figure.text(kWidth - 40.0, kHeight - 14.0,
              options.objectives[0].name + ", change in the search [%]", "ink",
              Figure::Anchor::End);
  for (const FrontPoint& point : points) {
    const base::Vec2 at(x.at(point.changes.x()), y.at(point.changes.y()));
    drawFrontPoint(figure, point, at);
    if (point.isOnFront) {
      front.push_back(at);
    }
  }
  std::sort(front.begin(), front.end(),
            [](const base::Vec2& a, const base::Vec2& b) { return a.x() < b.x(); });
  if (front.size() > 1) {
    figure.polyline(front, "accent", 1.0, 0.7);
  }
  figure.caption = options.objectives[0].name + " versus " + options.objectives[1].name +
                   " of the candidates that were run on all runs of the search, relative to the "
                   "current values. The line connects the Pareto-optimal ones.";
  return figure;
}

}  // namespace report
