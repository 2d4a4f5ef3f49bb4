#include "app/studies/RunPool.h"

#include <cmath>
#include <fcntl.h>
#include <optional>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/Batch.h"
#include "app/run/DataPaths.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/OutputFolder.h"
#include "app/run/PlannerFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

constexpr char kFormat[] = "hunavsim_journal";
constexpr int kFormatVersion = 1;

std::string headerLine() {
  return base::jsonText(
      Json{{kFormat, kFormatVersion}, {"version", programVersion()}, {"commit", programCommit()}},
      -1);
}

/// "1.0.0 (0123abcd)"; nullopt if the header does not say it.
std::optional<std::string> programOf(const Json& header) {
  const Json version = header.value("version", Json()), commit = header.value("commit", Json());
  return version.is_string() && commit.is_string()
             ? std::optional(version.get<std::string>() + " (" + commit.get<std::string>() + ")")
             : std::nullopt;
}

/// The problems of the first line of a journal.
base::Diagnostics headerProblems(const std::string& line, const std::string& path) {
  const Json header = Json::parse(base::shallowJson(line), nullptr, false);
  const bool isHeader = header.is_object() && header.value(kFormat, Json()) == Json(kFormatVersion);
  const std::optional<std::string> was = isHeader ? programOf(header) : std::nullopt;
  if (!was) {
    return {base::error("study.no-journal", {}, path, 1)};
  }
  const std::string now = *programOf(Json::parse(headerLine()));
  return *was == now ? base::Diagnostics()
                     : base::Diagnostics{base::error("study.other-program", {*was, now}, path, 1)};
}

/// The file that changed during a run; null: none has.
const InputHash* changedInput(const ResultRow& row) {
  for (std::size_t k = 1; k < row.inputs.size(); ++k) {
    if (row.inputs[k].path == row.inputs[k - 1].path) {
      return &row.inputs[k];
    }
  }
  return nullptr;
}

/// The settings of a run; invalid ones are in the diagnostics.
base::Result<RunSettings> poolSettingsOf(const RunSpec& spec) {
  base::Result<RunSettings> settings = runSettingsOf(spec);
  if (settings && !spec.allowCode) {
    settings->code = sim2d::ExternalCodePolicy::Refused;
  }
  return settings;
}

}  // namespace

RunSpec specOf(const RunRequest& request) {
  RunSpec spec = request.spec;
  spec.scenario = request.scenario;
  spec.seed = request.seed;
  return spec;
}

RunPool::RunPool(RunPoolOptions options) : options_(std::move(options)), reader_(options_.loader) {
  if (!options_.wantsStop) {
    options_.wantsStop = [] { return false; };
  }
}

base::Result<std::unique_ptr<RunPool>> RunPool::open(RunPoolOptions options) {
  std::unique_ptr<RunPool> pool(new RunPool(std::move(options)));
  if (!pool->options_.journal.empty()) {
    base::Diagnostics problems =
        entryExists(pool->options_.journal) ? pool->readJournal() : pool->createJournal();
    if (base::hasErrors(problems)) {
      return problems;
    }
  }
  return pool;
}

base::Diagnostics RunPool::createJournal() {
  base::Diagnostics problems = base::writeFileAtomically(options_.journal, headerLine() + "\n");
  if (!problems.empty()) {
    return problems;
  }
  journal_ =
      base::FileDescriptor(::open(options_.journal.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  return journal_.isOpen() ? base::Diagnostics()
                           : base::Diagnostics{writeProblem(options_.journal)};
}

base::Diagnostics RunPool::readJournal() {
  base::Result<std::string> text = base::readTextFile(options_.journal, base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  const std::size_t complete = text->rfind('\n') + 1;  // 0 if there is no line
  const std::vector<std::string> lines = base::split(text->substr(0, complete), '\n');
  base::Diagnostics problems = headerProblems(lines.front(), options_.journal);
  if (!problems.empty()) {
    return problems;
  }
  std::map<std::string, std::string> hashes;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    addLine(lines[k], hashes);
  }
  journal_ =
      base::FileDescriptor(::open(options_.journal.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!journal_.isOpen() || ::ftruncate(journal_.number(), static_cast<off_t>(complete)) != 0) {
    return {writeProblem(options_.journal)};
  }
  return {};
}

/// Skips damaged lines and results whose input files have changed. `hashes`: of files so far.
void RunPool::addLine(const std::string& line, std::map<std::string, std::string>& hashes) {
  const Json entry = Json::parse(base::shallowJson(line), nullptr, false);
  if (!entry.is_object() || !entry.contains("key") || !entry["key"].is_string() ||
      !entry.contains("row")) {
    return;
  }
  std::optional<ResultRow> row = tryParseRow(base::jsonText(entry["row"], -1));
  if (!row) {
    return;
  }
  for (const InputHash& input : row->inputs) {
    const auto [found, isNew] = hashes.try_emplace(input.path);
    if (isNew) {
      found->second = sha256OfFile(input.path).value_or("");
    }
    if (found->second != input.sha256) {
      return;
    }
  }
  known_[entry["key"].get<std::string>()] = *std::move(row);
}

base::Diagnostics RunPool::store(const std::string& key, const ResultRow& row) {
  if (const InputHash* const changed = changedInput(row)) {
    return {base::error("study.input-changed", {}, changed->path)};
  }
  const bool isRepeated = !row.ok && row.failedBy == FailedBy::Machine;
  if (journal_.isOpen() && !isRepeated) {
    const std::string line = "{\"key\":\"" + key + "\",\"row\":" + serializeRow(row) + "}\n";
    std::size_t written = 0;
    while (written < line.size()) {
      const ssize_t count =
          ::write(journal_.number(), line.data() + written, line.size() - written);
      if (count < 0) {
        return {writeProblem(options_.journal)};
      }
      written += static_cast<std::size_t>(count);
    }
  }
  return {};
}

std::string RunPool::keyOf(const RunSpec& spec) const {
  Json content = commandLineOf(spec);
  if (std::isfinite(options_.timeLimit)) {
    content.push_back(base::formatDouble(options_.timeLimit));
  }
  if (options_.keepsTrees) {
    content.push_back("tree_coverage");
  }
  return sha256Of(base::jsonText(content, -1));
}

/// Reads scenario, map and trees into the memory that the worker processes inherit. Problems are
/// reported by the runs.
void RunPool::warmUp(const RunSpec& spec) {
  const base::Result<RunSettings> settings = poolSettingsOf(spec);
  if (settings && warm_.insert(spec.scenario + "\n" + spec.map).second) {
    BundleReader::FileIndices used;
    app::check(reader_.read(spec, *settings, used));
  }
}

base::Diagnostics RunPool::check(const std::vector<RunRequest>& requests) {
  base::Diagnostics problems;
  for (const RunRequest& request : requests) {
    RunSpec spec = specOf(request);
    spec.allowCode = options_.allowCode;
    const base::Result<RunSettings> settings = poolSettingsOf(spec);
    base::append(problems, newDiagnostics(problems, settings.diagnostics()));
    if (!settings) {
      continue;
    }
    RunSettings checked = *settings;
    if (!options_.allowCode) {
      checked.code = sim2d::ExternalCodePolicy::Skipped;  // reported below
    }
    BundleReader::FileIndices used;
    const Bundle bundle = reader_.read(spec, checked, used);
    const Verdict verdict = app::check(bundle);
    base::Diagnostics found = errorsOf(verdict.wrongOptions);
    base::append(found, errorsOf(verdict.problems));
    if (!options_.allowCode) {
      base::append(found, externalCodeProblems(externalCodeOf(*bundle.scenario),
                                               base::Severity::Error, bundle.path));
    }
    base::append(problems, newDiagnostics(problems, found));
  }
  return problems;
}

base::Diagnostics RunPool::execute(const std::vector<std::pair<std::string, RunSpec>>& missing) {
  BatchJob job;
  for (std::size_t k = 0; k < missing.size(); ++k) {
    warmUp(missing[k].second);
    job.runs.push_back(k);
  }
  job.jobs = options_.jobs;
  job.timeLimit = options_.timeLimit;
  job.execute = [&](std::size_t run,
                    const BatchJob::ReportInputs& reportInputs) -> base::Result<ResultRow> {
    const RunSpec& spec = missing[run].second;
    const base::Result<RunSettings> settings = poolSettingsOf(spec);
    if (!settings) {
      return rowOf(settings.diagnostics());
    }
    BundleReader::FileIndices used;
    const Bundle bundle = reader_.read(spec, *settings, used);
    reportInputs(reader_.withChanges(used));
    ResultRow row = measureRun(bundle, options_.keepsTrees);
    row.inputs = reader_.withChanges(used);
    return row;
  };
  job.storeRow = [&](std::size_t run, const ResultRow& row) {
    known_[missing[run].first] = row;
    ++executed_;
    ++finished_;
    showProgress();
    return store(missing[run].first, row);
  };
  job.wantsStop = options_.wantsStop;
  return runBatch(job);
}

void RunPool::showProgress() const {
  if (options_.showProgress) {
    options_.showProgress(finished_, executed_);
  }
}

base::Result<std::vector<ResultRow>> RunPool::run(const std::vector<RunRequest>& requests) {
  std::vector<std::string> keys;
  std::vector<std::pair<std::string, RunSpec>> missing;
  for (const RunRequest& request : requests) {
    RunSpec spec = specOf(request);
    spec.allowCode = options_.allowCode;
    keys.push_back(keyOf(spec));
    if (requests_.insert(keys.back()).second) {
      ++requested_;
      if (known_.count(keys.back()) > 0) {
        ++finished_;
      } else {
        missing.emplace_back(keys.back(), std::move(spec));
      }
    }
  }
  showProgress();
  base::Diagnostics problems = execute(missing);
  std::vector<ResultRow> rows;
  for (const std::string& key : keys) {
    if (const auto found = known_.find(key); found != known_.end()) {
      rows.push_back(found->second);
    }
  }
  if (!base::hasErrors(problems) && (rows.size() < keys.size() || options_.wantsStop())) {
    problems.push_back(base::error("study.stopped", {finished_}));
  }
  return base::resultOf(std::move(rows), std::move(problems));
}

}  // namespace app
