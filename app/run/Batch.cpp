#include "app/run/Batch.h"

#include <chrono>
#include <csignal>
#include <deque>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <poll.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "app/run/ExceptionMessage.h"
#include "app/run/WorkerProcess.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kPollMs = 100;
constexpr int kMaxAttempts = 2;  // of a run whose process crashes

/// An answer: the row of the run, or why its files could not be written.
std::string serializeAnswer(const base::Result<ResultRow>& row) {
  if (row) {
    return serializeRow(*row);
  }
  Json problems = Json::array();
  for (const base::Diagnostic& problem : row.diagnostics()) {
    problems.push_back({{"file", problem.file}, {"message", problem.message}});
  }
  return base::jsonText(problems, -1);
}

base::Result<ResultRow> parseAnswer(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) {
    return parseRow(text);
  }
  base::Diagnostics problems;
  problems.reserve(json.size());
  for (const Json& each : json) {
    problems.push_back(
        base::error("batch.no-files", {each.value("message", "")}, each.value("file", "")));
  }
  return problems;
}

constexpr char kInputsPrefix[] =
    "met";  // prefix of a message with the input files of an active run

/// Called in a worker. An unexpected exception, such as std::bad_alloc, ends only this run.
std::string serveRequest(const BatchJob& job, const std::string& request,
                         const WorkerProcess::SendMessage& tell) {
  ResultRow row;  // of a run that ends with an exception
  try {
    const std::optional<long long> run = base::parseInt(request);
    const auto reportInputs = [&](const std::vector<InputHash>& files) {
      row.inputs = files;
      tell(kInputsPrefix + serializeRow(row));
    };
    return serializeAnswer(job.execute(static_cast<std::size_t>(run.value_or(0)), reportInputs));
  } catch (const std::exception& problem) {
    row.reason = exceptionMessage(problem);
    const bool hadNoMemory = dynamic_cast<const std::bad_alloc*>(&problem) != nullptr;
    row.failedBy = hadNoMemory ? FailedBy::Machine : FailedBy::Run;
    return serializeRow(row);
  }
}

/// Signals from outside the run: by the system when memory is exhausted, by a queue at its time
/// limit, by users. All other signals are caused by the run itself.
bool isExternalSignal(int signal) {
  switch (signal) {
    case SIGKILL:
    case SIGTERM:
    case SIGINT:
    case SIGHUP:
    case SIGQUIT:
    case SIGXCPU:
      return true;
    default:
      return false;
  }
}

/// The row of a run whose process has ended with this status of waitpid.
ResultRow rowOfEndedProcess(int status) {
  ResultRow row;
  if (!WIFSIGNALED(status)) {
    row.reason = "the process ended (code " + std::to_string(WEXITSTATUS(status)) + ")";
    return row;
  }
  const int signal = WTERMSIG(status);
  const bool isKilled = isExternalSignal(signal);
  row.failedBy = isKilled ? FailedBy::Machine : FailedBy::Run;
  row.reason = std::string(isKilled ? "the process was killed" : "the process crashed") +
               " (signal " + std::to_string(signal) + ")";
  return row;
}

/// A worker process and its active run.
struct Worker {
  WorkerProcess process;
  std::size_t run = 0;
  Clock::time_point begin;
  std::size_t made = 0;                 // completed runs
  std::size_t firstBytes = 0;           // resident memory after the first run
  std::vector<InputHash> reportInputs;  // input files that the run has reported so far
};

class Batch {
 public:
  explicit Batch(const BatchJob& job) : job_(job), waiting_(job.runs.begin(), job.runs.end()) {}

  base::Diagnostics run() {
    startWorkers();
    while (!workers_.empty() && problems_.empty() && !job_.wantsStop()) {
      pollWorkers();
      endOverdueRuns();
      startWorkers();
    }
    return problems_;  // the destructor ends remaining workers
  }

 private:
  bool isOver() const { return waiting_.empty() || !problems_.empty(); }

  void startWorkers() {
    while (!isOver() && workers_.size() < static_cast<std::size_t>(job_.jobs)) {
      std::optional<WorkerProcess> process = WorkerProcess::start(
          [this](const std::string& request, const WorkerProcess::SendMessage& tell) {
            return serveRequest(job_, request, tell);
          });
      if (!process) {
        if (workers_.empty()) {
          problems_.push_back(base::error("batch.no-process"));
        }
        return;  // the other workers continue
      }
      workers_.push_back({*std::move(process), 0, {}, 0, 0, {}});
      assignRun(workers_.back());
    }
  }

  void assignRun(Worker& worker) {
    worker.run = waiting_.front();
    waiting_.pop_front();
    worker.begin = Clock::now();
    worker.reportInputs.clear();
    worker.process.sendRequest(std::to_string(worker.run));  // readFrom() reports a failure
  }

  void pollWorkers() {
    std::vector<pollfd> sockets;
    sockets.reserve(workers_.size());
    for (const Worker& worker : workers_) {
      sockets.push_back({worker.process.descriptor(), POLLIN, 0});
    }
    if (::poll(sockets.data(), sockets.size(), kPollMs) <= 0) {
      return;
    }
    for (std::size_t k = sockets.size(); k-- > 0 && problems_.empty();) {
      if (sockets[k].revents != 0) {
        readFrom(k);
      }
    }
  }

  void readFrom(std::size_t index) {
    Worker& worker = workers_[index];
    std::string answer;
    do {
      switch (worker.process.readMessage(answer)) {
        case WorkerProcess::ReadResult::Part:
          return;
        case WorkerProcess::ReadResult::End:
          handleCrash(index);
          return;
        case WorkerProcess::ReadResult::Answer:
          break;
      }
    } while (storeInputs(answer, worker));
    const base::Result<ResultRow> row = parseAnswer(answer);
    if (!row) {
      problems_ = row.diagnostics();
      return;
    }
    storeRow(worker.run, *row);
    if (isOver() || shouldReplace(worker)) {
      remove(index);
    } else {
      assignRun(worker);
    }
  }

  bool shouldReplace(Worker& worker) const {
    const std::size_t bytes = worker.process.residentBytes();
    worker.firstBytes = worker.made == 0 ? bytes : worker.firstBytes;
    ++worker.made;
    return worker.made >= job_.runsPerWorker || bytes > worker.firstBytes + job_.maxGrowth;
  }

  /// Whether the message is from a run that is still active.
  static bool storeInputs(const std::string& message, Worker& worker) {
    const std::string begin = kInputsPrefix;
    if (message.compare(0, begin.size(), begin) != 0) {
      return false;
    }
    worker.reportInputs = parseRow(message.substr(begin.size())).inputs;
    return true;
  }

  void handleCrash(std::size_t index) {
    const std::size_t run = workers_[index].run;
    std::vector<InputHash> files = std::move(workers_[index].reportInputs);
    const int status = workers_[index].process.end();
    remove(index);
    if (++crashes_[run] < kMaxAttempts) {
      waiting_.push_front(run);
      return;
    }
    ResultRow row = rowOfEndedProcess(status);
    row.inputs = std::move(files);
    storeRow(run, row);
  }

  void endOverdueRuns() {
    for (std::size_t k = workers_.size(); k-- > 0 && problems_.empty();) {
      if (Seconds(Clock::now() - workers_[k].begin).count() > job_.timeLimit) {
        const std::size_t run = workers_[k].run;
        ResultRow row;
        row.inputs = std::move(workers_[k].reportInputs);
        remove(k);
        row.reason = "not finished within " + base::formatDouble(job_.timeLimit) + " s";
        storeRow(run, row);
      }
    }
  }

  void storeRow(std::size_t run, const ResultRow& row) { problems_ = job_.storeRow(run, row); }

  void remove(std::size_t index) {
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
  }

  const BatchJob& job_;
  std::deque<std::size_t> waiting_;
  std::vector<Worker> workers_;
  std::map<std::size_t, int> crashes_;
  base::Diagnostics problems_;
};

}  // namespace

base::Diagnostics runBatch(const BatchJob& job) {
  return Batch(job).run();
}

}  // namespace app
