#include "app/report/StudyOutput.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/studies/FailureShrinking.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

namespace fs = std::filesystem;
using OutputJson = nlohmann::json;

constexpr const char* kTuneFile = "tune.json";
constexpr const char* kGateFile = "gate.json";
constexpr const char* kSensitivityFile = "sensitivity.json";
constexpr const char* kSearchFile = "archive.json";
constexpr const char* kOutputFiles[] = {kTuneFile, kGateFile, kSensitivityFile, kSearchFile};
constexpr int kMostCells = 1000;  // of a descriptor

/// Thrown where a file has another form than the command writes; not a JSON error.
struct BadOutput {};

/// null is an undefined number.
double numberIn(const OutputJson& object, const char* key) {
  const OutputJson& value = object.at(key);
  return value.is_null() ? statistics::kUndefined : value.get<double>();
}

std::string stringIn(const OutputJson& object, const char* key) {
  const OutputJson& value = object.at(key);
  return value.is_null() ? std::string() : value.get<std::string>();
}

std::size_t countIn(const OutputJson& object, const char* key) {
  return object.at(key).get<std::size_t>();
}

std::vector<std::string> textsIn(const OutputJson& object, const char* key) {
  return object.at(key).get<std::vector<std::string>>();
}

/// The elements of a list, each read by a function.
template <class Read>
auto listIn(const OutputJson& object, const char* key, const Read& read) {
  const OutputJson& list = object.at(key);
  std::vector<decltype(read(list))> all;
  all.reserve(list.size());
  for (const OutputJson& each : list) {
    all.push_back(read(each));
  }
  return all;
}

statistics::Interval intervalIn(const OutputJson& object, const char* low, const char* high) {
  return {numberIn(object, low), numberIn(object, high)};
}

/// The value whose name is written in the file.
template <class Value, std::size_t Count>
Value valueNamed(const std::string& name, const std::pair<const char*, Value> (&all)[Count]) {
  const auto* const found = std::find_if(
      std::begin(all), std::end(all),
      [&name](const std::pair<const char*, Value>& each) { return name == each.first; });
  if (found == std::end(all)) {
    throw BadOutput();
  }
  return found->second;
}

app::TuneDifference tuneDifferenceIn(const OutputJson& json) {
  app::TuneDifference difference;
  difference.before = numberIn(json, "before");
  difference.after = numberIn(json, "after");
  difference.difference = numberIn(json, "difference");
  difference.interval = intervalIn(json, "low", "high");
  difference.pairs = json.at("pairs").get<int>();
  return difference;
}

std::vector<app::TuneDifference> objectivesIn(const OutputJson& json,
                                              const std::vector<std::string>& keys) {
  std::vector<app::TuneDifference> all;
  all.reserve(keys.size());
  for (const std::string& key : keys) {
    all.push_back(tuneDifferenceIn(json.at(key)));
  }
  return all;
}

void readTuneEvaluation(const OutputJson& json, TuneOutput& output) {
  if (json.is_null()) {
    return;
  }
  const auto add = [&output](const std::string& scenario, const OutputJson& metrics) {
    output.evaluations.push_back({scenario, tuneDifferenceIn(metrics.at("success")),
                                  objectivesIn(metrics, output.objectives)});
  };
  add({}, json.at("all"));
  for (const OutputJson& each : json.at("scenarios")) {
    add(stringIn(each, "scenario"), each.at("metrics"));
  }
  output.withoutSeedEffect = textsIn(json, "without_seed_effect");
  for (const OutputJson& each : json.at("effects")) {
    output.effects.push_back({stringIn(each, "parameter"), stringIn(each, "value"),
                              numberIn(each, "score"), each.at("kept").get<bool>(),
                              objectivesIn(each, output.objectives)});
  }
}

void readTuneParameters(const OutputJson& json, TuneOutput& output) {
  for (const OutputJson& each : json) {
    TuneOutput::Parameter parameter{stringIn(each, "name"),   numberIn(each, "low"),
                                    numberIn(each, "high"),   each.at("logarithmic").get<bool>(),
                                    stringIn(each, "before"), std::nullopt};
    if (!each.at("chosen").is_null()) {
      parameter.chosen = stringIn(each, "chosen");
    }
    output.parameters.push_back(std::move(parameter));
  }
}

void readTuneCandidates(const OutputJson& json, TuneOutput& output) {
  output.tried = json.empty() ? 0 : json.size() - 1;
  for (const OutputJson& each : json) {
    TuneOutput::Candidate candidate;
    candidate.values = textsIn(each, "values");
    if (candidate.values.size() != output.parameters.size()) {
      throw BadOutput();
    }
    candidate.isBefore = candidate.isChosen = true;
    for (std::size_t k = 0; k < candidate.values.size(); ++k) {
      const TuneOutput::Parameter& parameter = output.parameters[k];
      candidate.isBefore = candidate.isBefore && candidate.values[k] == parameter.before;
      candidate.isChosen = candidate.isChosen && candidate.values[k] == parameter.chosen;
    }
    candidate.isOnFront = each.at("on_front").get<bool>();
    for (const std::string& key : output.objectives) {
      candidate.ratios.push_back(numberIn(each.at("ratios"), key.c_str()));
    }
    if (each.at("complete").get<bool>()) {
      output.candidates.push_back(std::move(candidate));
    }
  }
}

TuneOutput tuneOutputOf(const OutputJson& json) {
  static constexpr std::pair<const char*, app::TuneVerdict> kVerdicts[] = {
      {"improved", app::TuneVerdict::Improved},
      {"not confirmed", app::TuneVerdict::NotConfirmed},
      {"no candidate", app::TuneVerdict::NoCandidate}};
  TuneOutput output;
  output.verdict = valueNamed(stringIn(json, "verdict"), kVerdicts);
  output.file = stringIn(json, "file");
  output.objectives = listIn(
      json, "objectives", [](const OutputJson& objective) { return stringIn(objective, "key"); });
  output.searchRuns = countIn(json, "search_runs");
  output.evaluationRuns = countIn(json, "evaluation_runs");
  readTuneParameters(json.at("parameters"), output);
  readTuneEvaluation(json.at("evaluation"), output);
  readTuneCandidates(json.at("candidates"), output);
  return output;
}

constexpr std::pair<const char*, app::GateVerdict> kGateVerdicts[] = {
    {"pass", app::GateVerdict::Pass},
    {"worse", app::GateVerdict::Worse},
    {"undecided", app::GateVerdict::Undecided}};

GateOutput::Metric gateMetricOf(const OutputJson& json) {
  GateOutput::Metric metric;
  metric.label = stringIn(json, "metric");
  metric.verdict = valueNamed(stringIn(json, "verdict"), kGateVerdicts);
  metric.isMeasured = json.at("measured").get<bool>();
  metric.pairs = countIn(json, "pairs");
  metric.base = numberIn(json, "base");
  metric.candidate = numberIn(json, "candidate");
  metric.unit = stringIn(json, "unit");
  const OutputJson& difference = json.at("difference");
  metric.difference = numberIn(difference, "mean");
  metric.interval = intervalIn(difference, "low", "high");
  metric.margin = numberIn(difference, "margin");
  metric.differenceUnit = stringIn(difference, "unit");
  return metric;
}

GateOutput::Finding gateFindingOf(const OutputJson& json) {
  return {stringIn(json, "scenario"), json.at("seed").get<long long>(), stringIn(json, "what"),
          stringIn(json, "play_candidate"), stringIn(json, "play_base")};
}

GateOutput gateOutputOf(const OutputJson& json) {
  return {valueNamed(stringIn(json, "verdict"), kGateVerdicts),
          stringIn(json, "base"),
          stringIn(json, "candidate"),
          countIn(json, "pairs"),
          listIn(json, "metrics", gateMetricOf),
          textsIn(json, "remarks"),
          listIn(json, "findings", gateFindingOf)};
}

SensitivityOutput::Factor factorOf(const OutputJson& json, bool isMorris,
                                   const OutputJson& ranges) {
  SensitivityOutput::Factor factor;
  factor.path = stringIn(json, "path");
  for (const OutputJson& range : ranges) {
    if (stringIn(range, "path") == factor.path) {
      factor.from = numberIn(range, "from");
      factor.to = numberIn(range, "to");
    }
  }
  if (isMorris) {
    factor.importance = numberIn(json, "mu_star");
    factor.importanceInterval = intervalIn(json, "mu_star_low", "mu_star_high");
    factor.mean = numberIn(json, "mu");
    factor.deviation = numberIn(json, "sigma");
    factor.effects = numberIn(json, "effects");
  } else {
    factor.importance = numberIn(json, "total");
    factor.importanceInterval = intervalIn(json, "total_low", "total_high");
    factor.first = numberIn(json, "first");
    factor.firstInterval = intervalIn(json, "first_low", "first_high");
  }
  factor.orderShare = numberIn(json, "order_share");
  return factor;
}

SensitivityOutput::Result sensitivityResultOf(const OutputJson& json, bool isMorris,
                                              const OutputJson& ranges) {
  SensitivityOutput::Result result;
  result.metric = stringIn(json, "metric");
  result.of = stringIn(json, "case");
  result.varies = json.at("varies").get<bool>();
  result.undefinedPoints = countIn(json, "undefined_points");
  result.seedShare = numberIn(json, "seed_share");
  const OutputJson& few = json.at("too_few_points");
  result.wide = textsIn(few, "wide");
  result.unordered = few.at("unordered").get<std::vector<std::pair<std::string, std::string>>>();
  result.required = numberIn(few, "required");
  result.factors = listIn(json, "factors", [&](const OutputJson& factor) {
    return factorOf(factor, isMorris, ranges);
  });
  return result;
}

SensitivityOutput sensitivityOutputOf(const OutputJson& json) {
  static constexpr std::pair<const char*, bool> kMethods[] = {{"morris", true}, {"sobol", false}};
  SensitivityOutput output;
  output.isMorris = valueNamed(stringIn(json, "method"), kMethods);
  output.points = countIn(json, "points");
  output.runs = countIn(json, "runs");
  output.seeds = countIn(json, "seeds");
  output.level = numberIn(json, "level");
  output.constantMetrics = textsIn(json, "constant_metrics");
  output.results = listIn(json, "results", [&](const OutputJson& result) {
    return sensitivityResultOf(result, output.isMorris, json.at("factors"));
  });
  return output;
}

SearchOutput::Failure failureOutputOf(const OutputJson& json) {
  SearchOutput::Failure failure;
  failure.kind = stringIn(json, "kind");
  failure.file = stringIn(json, "file");
  failure.scenario = stringIn(json.at("found"), "scenario");
  failure.seed = json.at("seed").get<long long>();
  failure.reason = stringIn(json, "reason");
  failure.end = base::parseDouble(stringIn(json, "simulated")).value_or(statistics::kUndefined);
  failure.people = countIn(json, "people");
  failure.peopleBefore = countIn(json, "people_before");
  failure.changes = textsIn(json, "set");
  failure.changes.erase(
      std::remove_if(failure.changes.begin(), failure.changes.end(), app::isEntityList),
      failure.changes.end());
  failure.isMinimal = json.at("minimal").get<bool>();
  failure.isRepeated = json.at("repeated").get<bool>();
  return failure;
}

/// The worst run is not shrunk: it has all values that were drawn for it.
void readWorstRun(const OutputJson& json, SearchOutput& output) {
  if (json.is_null()) {
    return;
  }
  SearchOutput::Failure worst;
  worst.file = stringIn(json, "file");
  worst.scenario = stringIn(json, "scenario");
  worst.seed = json.at("seed").get<long long>();
  worst.reason = stringIn(json, "reason");
  worst.end = base::parseDouble(stringIn(json, "simulated")).value_or(statistics::kUndefined);
  for (const auto& [path, value] : json.at("values").items()) {
    worst.changes.push_back(path + "=" + value.get<std::string>());
  }
  worst.isRepeated = json.at("repeated").get<bool>();
  output.worstValue = numberIn(json, "value");
  output.worst = std::move(worst);
}

void readCells(const OutputJson& json, SearchOutput& output) {
  for (const OutputJson& each : json.at("descriptors")) {
    app::Descriptor descriptor{stringIn(each, "key"), numberIn(each, "low"), numberIn(each, "high"),
                               each.at("cells").get<int>()};
    if (descriptor.cells < 1 || descriptor.cells > kMostCells) {
      throw BadOutput();
    }
    output.descriptors.push_back(std::move(descriptor));
  }
  if (output.descriptors.size() != 2) {
    throw BadOutput();
  }
  for (const OutputJson& each : json.at("cells")) {
    SearchOutput::Cell cell{each.at("cell").get<app::EliteArchive::Cell>(),
                            numberIn(each, "fitness"),
                            stringIn(each, "kind"),
                            stringIn(each, "scenario"),
                            each.at("seed").get<long long>(),
                            stringIn(each, "reason")};
    for (std::size_t k = 0; k < 2; ++k) {
      if (cell.at[k] < app::Descriptor::kUndefinedCell ||
          cell.at[k] >= output.descriptors[k].cells) {
        throw BadOutput();
      }
    }
    output.cells.push_back(std::move(cell));
  }
}

SearchOutput searchOutputOf(const OutputJson& json) {
  SearchOutput output;
  output.worstMetric = stringIn(json, "worst");
  output.runs = countIn(json, "runs");
  output.notSimulated = countIn(json, "not_simulated");
  output.unavoidable = countIn(json, "unavoidable_contacts");
  output.failures = listIn(json, "failures", failureOutputOf);
  readWorstRun(json.at("worst_run"), output);
  readCells(json, output);
  return output;
}

CoverOutput::Tree coveredTreeOf(const OutputJson& json) {
  return {countIn(json, "tree"),          stringIn(json, "owners"),    textsIn(json, "scenarios"),
          countIn(json, "runs"),          countIn(json, "nodes"),      countIn(json, "reached"),
          textsIn(json, "never_reached"), textsIn(json, "unreachable")};
}

CoverOutput::Run coveringRunOf(const OutputJson& json) {
  const auto nodeText = [](const OutputJson& node) {
    return std::to_string(countIn(node, "tree")) + ": " + stringIn(node, "node");
  };
  return {
      countIn(json, "run"),     stringIn(json, "scenario"),      json.at("seed").get<long long>(),
      stringIn(json, "reason"), listIn(json, "nodes", nodeText), stringIn(json, "play")};
}

CoverOutput coverOutputOf(const OutputJson& json) {
  return {countIn(json, "runs"),
          countIn(json, "not_simulated"),
          countIn(json, "nodes"),
          countIn(json, "reached"),
          countIn(json, "unreachable"),
          listIn(json, "trees", coveredTreeOf),
          listIn(json, "archive", coveringRunOf)};
}

StudyOutput outputOf(const std::string& name, const OutputJson& json) {
  if (name == kTuneFile) {
    return tuneOutputOf(json);
  }
  if (name == kGateFile) {
    return gateOutputOf(json);
  }
  if (name == kSensitivityFile) {
    return sensitivityOutputOf(json);
  }
  if (json.contains("cover")) {
    return coverOutputOf(json);
  }
  return searchOutputOf(json);
}

const char* commandOfOutput(const std::string& name) {
  return name == kTuneFile          ? "tune"
         : name == kGateFile        ? "gate"
         : name == kSensitivityFile ? "sensitivity"
                                    : "search";
}

bool isRegularFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

std::optional<std::string> studyOutputFile(const std::string& path) {
  const fs::path given(path);
  const auto isOutput = [](const fs::path& file) {
    return isRegularFile(file) && isRegularFile(file.parent_path() / "manifest.json");
  };
  for (const char* name : kOutputFiles) {
    if (given.filename() == name && isOutput(given)) {
      return path;
    }
  }
  for (const char* name : kOutputFiles) {
    if (isOutput(given / name)) {
      return (given / name).string();
    }
  }
  return std::nullopt;
}

std::string studyOutputPage(const StudyOutput& output) {
  return std::holds_alternative<GateOutput>(output) ? "gate.html" : "report.html";
}

base::Result<StudyOutput> readStudyOutput(const std::string& file) {
  const base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  const fs::path path(file);
  const std::string name = path.filename().string();
  try {
    StudyOutput output = outputOf(name, OutputJson::parse(base::shallowJson(*text)));
    if (auto* const tuned = std::get_if<TuneOutput>(&output)) {
      const std::string diff = (path.parent_path() / "changes.diff").string();
      const base::Result<std::string> changes =
          isRegularFile(diff) ? base::readTextFile(diff) : base::Result<std::string>(std::string());
      if (!changes) {
        return changes.diagnostics();
      }
      tuned->diff = *changes;
    }
    return output;
  } catch (const OutputJson::exception&) {
  } catch (const BadOutput&) {
  }
  return base::error("study.bad-output", {commandOfOutput(name)}, file);
}

}  // namespace report
