#include "app/run/Batch.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/PlannerFiles.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/trace/Csv.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr int kPollMs = 100;
constexpr std::chrono::seconds kPatience{3};  // for children to end after they were asked to
constexpr int kNotStarted = 127;              // exit code of a child that is not the program
constexpr const char* kCannotStart = "the process could not be started";

Json readJson(const fs::path& path) {
  const base::Result<std::string> text = base::readTextFile(path.string());
  return text ? Json::parse(*text, nullptr, false) : Json();
}

/// The first line that says what went wrong.
std::string firstError(const std::string& output) {
  for (const std::string& line : base::split(output, '\n')) {
    const std::size_t at = line.find("error: ");
    if (at != std::string::npos) {
      return base::trimmed(line.substr(at + 7));
    }
  }
  return {};
}

BatchRow readRow(const fs::path& folder) {
  BatchRow row;
  const Json manifest = readJson(folder / "manifest.json");
  if (manifest.is_object()) {
    row.ok = manifest.value("status", "") == "finished";
    row.reason = manifest.value("reason", "");
    if (manifest.contains("simulated_seconds") && manifest["simulated_seconds"].is_number()) {
      row.simulated = base::formatDouble(manifest["simulated_seconds"].get<double>());
    }
  }
  const base::Result<std::string> metrics = base::readTextFile((folder / "metrics.json").string());
  row.values = metrics ? resultValues(*metrics) : ResultValues();
  return row;
}

std::vector<std::string> wordsOf(const Experiment& experiment, std::size_t run,
                                 const std::string& folder) {
  const Experiment::Run values = experiment.run(run);
  std::vector<std::string> words = {programPath(), "run", experiment.scenarioPaths[values.scenario],
                                    "--quiet",     "-o",  folder};
  if (experiment.record == Experiment::Record::Metrics) {
    words.emplace_back("--totals");  // nothing else of the folder is looked at
  }
  if (experiment.allowCode) {
    words.emplace_back("--allow-code");
  }
  words.insert(words.end(), {"--seed", std::to_string(values.seed)});
  for (const auto& [option, value] : experiment.options) {
    words.insert(words.end(), {option, value});
  }
  for (std::size_t k = 0; k < experiment.values.size(); ++k) {
    words.insert(words.end(), {"--set", experiment.values[k].first + "=" + values.values[k]});
  }
  return words;
}

/// A run in a process of its own; what it says on standard error is kept.
struct Child {
  std::size_t run = 0;
  pid_t process = -1;
  int said = -1;  // pipe from its standard error
  std::string errors;
};

/// In the new process. Out of the reach of Ctrl-C in the terminal: the parent asks it to end, once.
/// It does not outlive the parent.
[[noreturn]] void becomeProgram(char* const* words, int errors) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execv(words[0], words);
  ::_exit(kNotStarted);
}

/// process -1: there is none.
Child startChild(std::size_t run, std::vector<std::string> words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  Child child;
  child.run = run;
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return child;
  }
  child.process = ::fork();
  if (child.process == 0) {
    becomeProgram(pointers.data(), ends[1]);
  }
  ::close(ends[1]);
  child.said = ends[0];
  return child;
}

/// What it said since; false when it will say no more.
bool listen(Child& child) {
  char bytes[4096];
  const ssize_t count = ::read(child.said, bytes, sizeof bytes);
  if (count > 0) {
    child.errors.append(bytes, static_cast<std::size_t>(count));
  }
  return count > 0 || (count < 0 && errno == EINTR);
}

/// How it ended, as waitpid tells.
int waitFor(Child& child) {
  int status = 0;
  while (::waitpid(child.process, &status, 0) < 0 && errno == EINTR) {
  }
  ::close(child.said);
  return status;
}

class Batch {
 public:
  Batch(const Experiment& experiment, const BatchJob& job)
      : experiment_(experiment), job_(job), rows_(experiment.runCount()) {}

  BatchRows run() {
    startMore();
    while (!children_.empty()) {
      if (!stopping_ && job_.wantsStop()) {
        stopping_ = true;
        deadline_ = Clock::now() + kPatience;
        signalAll(SIGTERM);
      } else if (stopping_ && Clock::now() > deadline_) {
        signalAll(SIGKILL);
      }
      listenToAll();
    }
    return std::move(rows_);
  }

 private:
  std::string folderOf(std::size_t run) const {
    return (fs::path(job_.runsFolder) / std::to_string(run)).string();
  }

  void removeFolder(std::size_t run) const { removeRun(folderOf(run)); }

  void startMore() {
    while (!stopping_ && next_ < rows_.size() &&
           children_.size() < static_cast<std::size_t>(job_.jobs)) {
      const std::size_t run = next_++;
      removeFolder(run);  // of an earlier batch: this run may fail before it writes
      Child child = startChild(run, wordsOf(experiment_, run, folderOf(run)));
      if (child.process > 0) {
        children_.push_back(std::move(child));
      } else {
        finish(run, {false, kCannotStart, {}, {}});
      }
    }
  }

  void signalAll(int signal) const {
    for (const Child& child : children_) {
      ::kill(child.process, signal);
    }
  }

  void listenToAll() {
    std::vector<pollfd> pipes;
    for (const Child& child : children_) {
      pipes.push_back({child.said, POLLIN, 0});
    }
    if (::poll(pipes.data(), pipes.size(), kPollMs) <= 0) {
      return;
    }
    for (std::size_t k = pipes.size(); k-- > 0;) {
      if (pipes[k].revents != 0 && !listen(children_[k])) {
        Child child = std::move(children_[k]);
        children_.erase(children_.begin() + static_cast<std::ptrdiff_t>(k));
        const int status = waitFor(child);
        if (stopping_) {
          removeFolder(child.run);  // cut short: not a result
        } else {
          finish(child.run, rowOf(child, status));
        }
      }
    }
    startMore();
  }

  BatchRow rowOf(const Child& child, int status) const {
    BatchRow row = readRow(folderOf(child.run));
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (row.ok && code != 0) {
      row.ok = false;
      row.reason.clear();  // is that of a fine run
    }
    if (!WIFEXITED(status)) {
      row.reason = "the process crashed";
    } else if (code == kNotStarted) {
      row.reason = kCannotStart;
    } else if (code != 0 && row.reason.empty()) {
      row.reason = firstError(child.errors);
    }
    if (!row.ok && row.reason.empty()) {
      row.reason = "exit code " + std::to_string(code);
    }
    return row;
  }

  void finish(std::size_t run, BatchRow row) {
    const bool isKept = experiment_.record == Experiment::Record::All ||
                        (experiment_.record == Experiment::Record::Failed && !row.ok);
    if (!isKept) {
      removeFolder(run);
    }
    rows_[run] = std::move(row);
    ++finished_;
    job_.onProgress(finished_);
  }

  const Experiment& experiment_;
  const BatchJob& job_;
  BatchRows rows_;
  std::vector<Child> children_;
  std::size_t next_ = 0, finished_ = 0;
  bool stopping_ = false;
  Clock::time_point deadline_;
};

/// Every finished run of a scenario has the same.
std::vector<std::string> metricColumns(const BatchRows& rows) {
  std::set<std::string> present;
  std::vector<std::string> robots;
  for (const std::optional<BatchRow>& row : rows) {
    if (!row) {
      continue;
    }
    for (const auto& [column, field] : row->values.fields) {
      present.insert(column);
    }
    for (const std::string& robot : row->values.robots) {
      if (std::find(robots.begin(), robots.end(), robot) == robots.end()) {
        robots.push_back(robot);
      }
    }
  }
  return resultColumns(present, robots);
}

/// Code that runs want to start and may not: those of the first values, and of each other value
/// beside them.
base::Diagnostics codeOfRuns(const Experiment& experiment, const sim2d::Scenario& first,
                             const std::string& scenarioPath) {
  std::vector<ForeignCode> all = foreignCodeOf(first);
  for (const auto& [path, texts] : experiment.values) {
    for (const std::string& text : texts) {
      sim2d::Scenario changed = first;
      if (base::hasErrors(sim2d::setValue(changed, path, text))) {
        continue;  // told by who read the experiment
      }
      for (const ForeignCode& code : foreignCodeOf(changed)) {
        if (std::find(all.begin(), all.end(), code) == all.end()) {
          all.push_back(code);
        }
      }
    }
  }
  return tellForeignCode(all, base::Severity::Error, scenarioPath);
}

}  // namespace

base::Diagnostics checkExperiment(const Experiment& experiment, const sim2d::ImageLoader& loader) {
  base::Diagnostics problems;
  for (const std::string& scenario : experiment.scenarioPaths) {
    RunOptions options;
    options.scenario = scenario;
    for (const auto& [path, texts] : experiment.values) {
      options.set.push_back(path + "=" + texts.front());
    }
    for (const auto& [name, option] :
         {std::pair("--model", &RunOptions::model), std::pair("--planner", &RunOptions::planner),
          std::pair("--robot", &RunOptions::robot)}) {
      if (const auto value = experiment.options.find(name); value != experiment.options.end()) {
        options.*option = value->second;
      }
    }
    const Bundle bundle = readBundle(options, {}, loader);
    const Verdict verdict = check(bundle);
    for (base::Diagnostic diagnostic : verdict.wrongWords) {
      diagnostic.file = diagnostic.file.empty() ? experiment.path : diagnostic.file;
      problems.push_back(std::move(diagnostic));
    }
    base::append(problems, errorsOf(verdict.problems));
    if (!experiment.allowCode) {
      base::append(problems, codeOfRuns(experiment, *bundle.scenario, scenario));
    }
  }
  return problems;
}

/// How many runs a batch of before had in this folder; none where its manifest is of no batch.
std::optional<std::size_t> runsOfBatchIn(const fs::path& folder) {
  const Json manifest = readJson(folder / "manifest.json");
  const auto runs = manifest.is_object() ? manifest.find("runs") : manifest.end();
  return runs != manifest.end() && runs->is_number_unsigned()
             ? std::optional(runs->get<std::size_t>())
             : std::nullopt;
}

base::Diagnostics checkRunFolders(const Experiment& experiment, const std::string& runsFolder) {
  constexpr std::size_t kMostTold = 5;
  std::error_code ignored;
  const fs::path folder = fs::path(runsFolder).parent_path();
  const std::optional<std::size_t> known = runsOfBatchIn(folder);
  for (const char* name : {"manifest.json", "results.csv"}) {
    if (!known && fs::exists(fs::symlink_status(folder / name, ignored))) {
      return {base::error("batch.stranger", {}, (folder / name).string())};
    }
  }
  if (fs::is_symlink(fs::symlink_status(runsFolder, ignored))) {
    return {base::error("batch.stranger", {}, runsFolder)};
  }
  base::Diagnostics problems;
  for (std::size_t run = 0; run < experiment.runCount() && problems.size() < kMostTold; ++run) {
    const std::string place = (fs::path(runsFolder) / std::to_string(run)).string();
    if (const auto stranger = strangerIn(place, run < known.value_or(0))) {
      problems.push_back(base::error("batch.stranger", {}, *stranger));
    }
  }
  return problems;
}

BatchRows runBatch(const Experiment& experiment, const BatchJob& job) {
  return Batch(experiment, job).run();
}

BatchCount countOf(const BatchRows& rows) {
  BatchCount count;
  for (const std::optional<BatchRow>& row : rows) {
    count.finished += row ? 1 : 0;
    count.failed += row && !row->ok ? 1 : 0;
  }
  return count;
}

std::string resultsCsv(const Experiment& experiment, const BatchRows& rows) {
  const std::vector<std::string> keys = metricColumns(rows);
  std::string text = "run,scenario,seed";
  const auto add = [&text](const std::string& field) {
    text += ',';
    sim2d::appendCsvField(text, field);
  };
  for (const auto& [path, texts] : experiment.values) {
    add(path);
  }
  text += ",status,reason,simulated";
  for (const std::string& key : keys) {
    add(key);
  }
  text += '\n';
  for (std::size_t index = 0; index < rows.size(); ++index) {
    const std::optional<BatchRow>& row = rows[index];
    if (!row) {
      continue;
    }
    const Experiment::Run run = experiment.run(index);
    text += std::to_string(index);
    add(experiment.scenarios[run.scenario]);
    add(std::to_string(run.seed));
    for (const std::string& value : run.values) {
      add(value);
    }
    add(row->ok ? "ok" : "failed");
    add(row->reason);
    add(row->simulated);
    for (const std::string& key : keys) {
      const auto found = row->values.fields.find(key);
      add(found == row->values.fields.end() ? std::string() : found->second);
    }
    text += '\n';
  }
  return text;
}

}  // namespace app
