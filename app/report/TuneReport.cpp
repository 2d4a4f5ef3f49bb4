#include "app/report/TuneReport.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "app/studies/UnifiedDiff.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::TuneVerdict;
using TuneJson = nlohmann::ordered_json;

const char* tuneVerdictName(TuneVerdict verdict) {
  switch (verdict) {
    case TuneVerdict::Improved:
      return "improved";
    case TuneVerdict::NotConfirmed:
      return "not confirmed";
    case TuneVerdict::NoCandidate:
      break;
  }
  return "no candidate";
}

std::string changesText(const app::TuneOptions& options, const app::TuneEvaluation& made) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < options.objectives.size(); ++k) {
    parts.push_back(base::toLower(options.objectives[k].name) + " " +
                    relativeText(made.objectives[k]));
  }
  parts.push_back("success " + percentText(made.success.before) + " before, " +
                  percentText(made.success.after) + " after");
  return base::join(parts, ", ");
}

std::string tuneHeadline(const app::TuneOptions& options, const app::TuneResult& result) {
  switch (result.verdict) {
    case TuneVerdict::Improved:
      return "IMPROVED: " + changesText(options, *result.evaluation);
    case TuneVerdict::NotConfirmed:
      return "NO IMPROVEMENT FOUND: on new runs the best candidate is not clearly better: " +
             changesText(options, *result.evaluation);
    case TuneVerdict::NoCandidate:
      break;
  }
  if (result.candidates.size() <= 1) {
    return "NOTHING TRIED: a limit of " + counted(options.runs, "run") + " is too small for " +
           counted(options.scenarios.size(), "scenario") + " with " +
           counted(static_cast<std::size_t>(options.seeds), "seed") +
           " each: raise --runs, or take fewer scenarios, --seeds or --max-changes";
  }
  return "NO IMPROVEMENT FOUND: none of " + counted(result.candidates.size() - 1, "candidate") +
         " was better than the current values";
}

std::string tuneMethodText(const app::TuneOptions& options, const app::TuneResult& result) {
  return counted(result.candidates.size() - 1, "candidate") + " were compared in " +
         std::to_string(result.searchRuns) +
         " runs. In each stage all candidates had the same seeds, which no stage before had: all "
         "of them ran on one seed of each scenario or more, the best third on half of " +
         std::to_string(options.seeds * static_cast<int>(options.scenarios.size())) +
         " runs, the best sixth on all (successive halving). First, single parameters were set to "
         "their documented defaults and to distant values of their ranges; then the best of these "
         "changes were combined; then CMA-ES (Hansen, arXiv:1604.00772) varied the parameters with "
         "the largest effects in " +
         counted(static_cast<std::size_t>(result.generations), "generation") +
         ", starting at the best values so far. The score is the weighted mean of the objectives "
         "relative to the current values, which were run with the same seeds; failures add to it, "
         "by the share of the distance that was left, and so do losses of more than " +
         percentText(options.maxLoss) +
         " and additional failures beyond a standard error. The last means of the CMA-ES and the "
         "best candidates were compared on further seeds; of the best one each change was taken "
         "back once, and those that do not matter were dropped. An improvement "
         "means: on runs that the search has not seen, an objective or the rate of success is "
         "better with 95 % confidence, no objective is worse by more than " +
         percentText(options.maxLoss) + ", and successes are not fewer with 95 % confidence.";
}

std::vector<std::string> tuneRemarks(const app::TuneResult& result) {
  std::vector<std::string> constant;
  if (result.evaluation) {
    for (const std::string& scenario : result.evaluation->withoutSeedEffect) {
      constant.push_back(std::filesystem::path(scenario).stem().string());
    }
  }
  return withoutSeedEffectRemarks(constant);
}

PageParts tuneParts(const app::TuneOptions& options, const app::TuneSubject& subject,
                    const app::TuneResult& result, const TuneReport& report,
                    const TuneContext& context) {
  PageParts parts;
  if (result.evaluation) {
    parts.section("evaluation", "Evaluation");
    parts.add(tuneEvaluationTable(options, result));
    parts.add(tuneScenarioTable(options, result));
    parts.section("changes", "Changes");
    parts.body +=
        (report.diff.empty()
             ? element("p", "", "None: the evaluated values below are not an improvement.")
             : element("pre", "", escaped(report.diff))) +
        "\n";
    parts.add(tuneEffectsTable(options, subject, result));
  }
  parts.section("front", "Front");
  parts.add(tuneFrontFigure(options, result));
  parts.add(tuneFrontTable(options, subject, result));
  parts.section("parameters", "Parameters");
  parts.add(tuneParametersTable(subject, result));
  if (!result.probes.empty()) {
    parts.add(tuneProbeTable(options, subject, result));
  }
  parts.section("methods", "Methods");
  parts.body += paragraph(tuneMethodText(options, result)) +
                provenanceMarkup(context.inputs, context.command);
  return parts;
}

TuneJson differenceJson(const app::TuneDifference& of) {
  return {{"before", base::jsonNumber<TuneJson>(of.before)},
          {"after", base::jsonNumber<TuneJson>(of.after)},
          {"difference", base::jsonNumber<TuneJson>(of.difference)},
          {"low", base::jsonNumber<TuneJson>(of.interval.low)},
          {"high", base::jsonNumber<TuneJson>(of.interval.high)},
          {"pairs", of.pairs}};
}

TuneJson evaluationJson(const app::TuneOptions& options, const app::TuneSubject& subject,
                        const app::TuneResult& result) {
  if (!result.evaluation) {
    return nullptr;
  }
  const auto differences = [&](const app::TuneDifference& success,
                               const std::vector<app::TuneDifference>& objectives) {
    TuneJson json = {{"success", differenceJson(success)}};
    for (std::size_t k = 0; k < objectives.size(); ++k) {
      json[options.objectives[k].key] = differenceJson(objectives[k]);
    }
    return json;
  };
  const app::TuneEvaluation& made = *result.evaluation;
  TuneJson json = {{"all", differences(made.success, made.objectives)}};
  for (std::size_t k = 0; k < made.scenarios.size(); ++k) {
    json["scenarios"].push_back(
        {{"scenario", options.heldOut[k]},
         {"metrics", differences(made.scenarios[k].first, made.scenarios[k].second)}});
  }
  json["without_seed_effect"] = made.withoutSeedEffect;
  json["effects"] = TuneJson::array();
  for (const app::TuneEffect& effect : result.effects) {
    TuneJson of = {{"parameter", subject.parameters()[effect.parameter].label()},
                   {"value", effect.value},
                   {"score", base::jsonNumber<TuneJson>(effect.total)},
                   {"standard_error", base::jsonNumber<TuneJson>(effect.error)},
                   {"kept", effect.isKept}};
    for (std::size_t k = 0; k < effect.differences.size(); ++k) {
      of[options.objectives[k].key] = differenceJson(effect.differences[k]);
    }
    json["effects"].push_back(of);
  }
  return json;
}

TuneJson probesJson(const app::TuneOptions& options, const app::TuneSubject& subject,
                    const app::TuneResult& result) {
  TuneJson all = TuneJson::array();
  for (const app::TuneProbe& probe : result.probes) {
    TuneJson of = {{"parameter", subject.parameters()[probe.parameter].label()},
                   {"from", probe.from},
                   {"to", probe.to},
                   {"runs", probe.runs},
                   {"score", base::jsonNumber<TuneJson>(probe.score.total)},
                   {"standard_error", base::jsonNumber<TuneJson>(probe.score.error)},
                   {"failures", base::jsonNumber<TuneJson>(probe.score.failures)}};
    for (std::size_t k = 0; k < options.objectives.size(); ++k) {
      of["ratios"][options.objectives[k].key] = base::jsonNumber<TuneJson>(probe.score.ratios[k]);
    }
    all.push_back(of);
  }
  return all;
}

TuneJson candidatesJson(const app::TuneOptions& options, const app::TuneResult& result) {
  TuneJson all = TuneJson::array();
  for (const app::TuneCandidate& candidate : result.candidates) {
    TuneJson ratios = TuneJson::object();
    for (std::size_t k = 0; k < options.objectives.size(); ++k) {
      ratios[options.objectives[k].key] = base::jsonNumber<TuneJson>(candidate.score.ratios[k]);
    }
    all.push_back({{"values", candidate.values},
                   {"generation", candidate.generation},
                   {"runs", candidate.runs},
                   {"score", base::jsonNumber<TuneJson>(candidate.score.total)},
                   {"ratios", ratios},
                   {"failures", base::jsonNumber<TuneJson>(candidate.score.failures)},
                   {"complete", candidate.isComplete},
                   {"on_front", candidate.isOnFront}});
  }
  return all;
}

std::string tuneJson(const app::TuneOptions& options, const app::TuneSubject& subject,
                     const app::TuneResult& result, const TuneContext& context) {
  TuneJson json = {{"verdict", tuneVerdictName(result.verdict)},
                   {"improved", result.verdict == TuneVerdict::Improved},
                   {"file", subject.path()},
                   {"controller", subject.controller()},
                   {"scenarios", options.scenarios},
                   {"held_out", options.heldOut},
                   {"search_runs", result.searchRuns},
                   {"evaluation_runs", result.evaluationRuns},
                   {"generations", result.generations}};
  for (const app::TuneObjective& objective : options.objectives) {
    json["objectives"].push_back(
        {{"key", objective.key}, {"unit", objective.unit}, {"weight", objective.weight}});
  }
  for (std::size_t k = 0; k < subject.parameters().size(); ++k) {
    const app::TunedParameter& parameter = subject.parameters()[k];
    json["parameters"].push_back(
        {{"name", parameter.label()},
         {"low", parameter.range.low},
         {"high", parameter.range.high},
         {"logarithmic", parameter.range.isLogarithmic},
         {"before", parameter.present},
         {"varied",
          std::find(result.varied.begin(), result.varied.end(), k) != result.varied.end()},
         {"chosen", result.chosen ? TuneJson((*result.chosen)[k]) : TuneJson()}});
  }
  json["probes"] = probesJson(options, subject, result);
  json["evaluation"] = evaluationJson(options, subject, result);
  json["candidates"] = candidatesJson(options, result);
  json["inputs"] = TuneJson::array();
  for (const app::InputHash& input : context.inputs) {
    json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  return base::jsonText(json) + "\n";
}

}  // namespace

TuneReport makeTuneReport(const app::TuneOptions& options, const app::TuneSubject& subject,
                          const app::TuneResult& result, const TuneContext& context) {
  TuneReport report;
  report.headline = tuneHeadline(options, result);
  const std::string name = std::filesystem::path(subject.path()).filename().string();
  const std::string chosen =
      result.chosen ? subject.textWith(*result.chosen).value_or(subject.text()) : subject.text();
  report.tuned = result.verdict == TuneVerdict::Improved ? chosen : subject.text();
  report.diff = app::unifiedDiff(subject.text(), report.tuned, name, context.outputName);
  const PageParts parts = tuneParts(options, subject, result, report, context);
  report.html = parts.page("Tuning of " + name, subject.controller(),
                           verdictNotes(report.headline, tuneRemarks(result)));
  report.json = tuneJson(options, subject, result, context);
  report.tables = parts.report.tables;
  report.figures = parts.report.figures;
  return report;
}

}  // namespace report
