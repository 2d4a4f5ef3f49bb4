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

#include "app/run/Reason.h"
#include "app/run/WorkerProcess.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kPollMs = 100;
constexpr int kMostTries = 2;  // of a run whose process crashes

/// An answer: the row of the run, or why its files could not be written.
std::string answerText(const base::Result<ResultRow>& row) {
  if (row) {
    return rowText(*row);
  }
  Json problems = Json::array();
  for (const base::Diagnostic& problem : row.diagnostics()) {
    problems.push_back({{"file", problem.file}, {"message", problem.message}});
  }
  return base::jsonText(problems, -1);
}

base::Result<ResultRow> readAnswer(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) {
    return rowOfText(text);
  }
  base::Diagnostics problems;
  problems.reserve(json.size());
  for (const Json& each : json) {
    problems.push_back(
        base::error("batch.no-files", {each.value("message", "")}, each.value("file", "")));
  }
  return problems;
}

constexpr char kMet[] = "met";  // prefix of a message with the files of a running run

/// In a worker. What no run foresees, as no memory, is the end of that run alone.
std::string answerTo(const BatchJob& job, const std::string& question,
                     const WorkerProcess::Tell& tell) {
  ResultRow row;  // of a run that ends in this way
  try {
    const std::optional<long long> run = base::parseInt(question);
    const auto met = [&](const std::vector<InputHash>& files) {
      row.inputs = files;
      tell(kMet + rowText(row));
    };
    return answerText(job.make(static_cast<std::size_t>(run.value_or(0)), met));
  } catch (const std::exception& problem) {
    row.reason = reasonOf(problem);
    const bool hadNoMemory = dynamic_cast<const std::bad_alloc*>(&problem) != nullptr;
    row.failedBy = hadNoMemory ? FailedBy::Machine : FailedBy::Run;
    return rowText(row);
  }
}

/// Signals from outside the run: by the system when memory is exhausted, by a queue at its time
/// limit, by users. All other signals are caused by the run itself.
bool isFromOutside(int signal) {
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
ResultRow rowOfEnded(int status) {
  ResultRow row;
  if (!WIFSIGNALED(status)) {
    row.reason = "the process ended (code " + std::to_string(WEXITSTATUS(status)) + ")";
    return row;
  }
  const int signal = WTERMSIG(status);
  const bool isKilled = isFromOutside(signal);
  row.failedBy = isKilled ? FailedBy::Machine : FailedBy::Run;
  row.reason = std::string(isKilled ? "the process was killed" : "the process crashed") +
               " (signal " + std::to_string(signal) + ")";
  return row;
}

/// A process, with the run that it makes.
struct Worker {
  WorkerProcess process;
  std::size_t run = 0;
  Clock::time_point begin;
  std::size_t made = 0;        // runs so far
  std::size_t firstBytes = 0;  // memory after the first
  std::vector<InputHash> met;  // files that the run uses, as far as it has reported them
};

class Batch {
 public:
  explicit Batch(const BatchJob& job) : job_(job), waiting_(job.runs.begin(), job.runs.end()) {}

  base::Diagnostics run() {
    startMore();
    while (!workers_.empty() && troubles_.empty() && !job_.wantsStop()) {
      listenToAll();
      endLate();
      startMore();
    }
    return troubles_;  // workers that are left are ended
  }

 private:
  bool isOver() const { return waiting_.empty() || !troubles_.empty(); }

  void startMore() {
    while (!isOver() && workers_.size() < static_cast<std::size_t>(job_.jobs)) {
      std::optional<WorkerProcess> process = WorkerProcess::start(
          [this](const std::string& question, const WorkerProcess::Tell& tell) {
            return answerTo(job_, question, tell);
          });
      if (!process) {
        if (workers_.empty()) {
          troubles_.push_back(base::error("batch.no-process"));
        }
        return;  // the others go on
      }
      workers_.push_back({*std::move(process), 0, {}, 0, 0, {}});
      giveRun(workers_.back());
    }
  }

  void giveRun(Worker& worker) {
    worker.run = waiting_.front();
    waiting_.pop_front();
    worker.begin = Clock::now();
    worker.met.clear();
    worker.process.ask(std::to_string(worker.run));  // one that is gone is heard of soon
  }

  void listenToAll() {
    std::vector<pollfd> sockets;
    sockets.reserve(workers_.size());
    for (const Worker& worker : workers_) {
      sockets.push_back({worker.process.descriptor(), POLLIN, 0});
    }
    if (::poll(sockets.data(), sockets.size(), kPollMs) <= 0) {
      return;
    }
    for (std::size_t k = sockets.size(); k-- > 0 && troubles_.empty();) {
      if (sockets[k].revents != 0) {
        listenTo(k);
      }
    }
  }

  void listenTo(std::size_t index) {
    Worker& worker = workers_[index];
    std::string answer;
    do {
      switch (worker.process.hear(answer)) {
        case WorkerProcess::Heard::Part:
          return;
        case WorkerProcess::Heard::End:
          noteCrash(index);
          return;
        case WorkerProcess::Heard::Answer:
          break;
      }
    } while (noteMet(answer, worker));
    const base::Result<ResultRow> row = readAnswer(answer);
    if (!row) {
      troubles_ = row.diagnostics();
      return;
    }
    take(worker.run, *row);
    if (isOver() || isUsedUp(worker)) {
      remove(index);
    } else {
      giveRun(worker);
    }
  }

  bool isUsedUp(Worker& worker) const {
    const std::size_t bytes = worker.process.residentBytes();
    worker.firstBytes = worker.made == 0 ? bytes : worker.firstBytes;
    ++worker.made;
    return worker.made >= job_.runsPerWorker || bytes > worker.firstBytes + job_.mostGrowth;
  }

  /// Whether the message is from a run that is still running.
  static bool noteMet(const std::string& message, Worker& worker) {
    const std::string begin = kMet;
    if (message.compare(0, begin.size(), begin) != 0) {
      return false;
    }
    worker.met = rowOfText(message.substr(begin.size())).inputs;
    return true;
  }

  void noteCrash(std::size_t index) {
    const std::size_t run = workers_[index].run;
    std::vector<InputHash> files = std::move(workers_[index].met);
    const int status = workers_[index].process.end();
    remove(index);
    if (++crashes_[run] < kMostTries) {
      waiting_.push_front(run);
      return;
    }
    ResultRow row = rowOfEnded(status);
    row.inputs = std::move(files);
    take(run, row);
  }

  void endLate() {
    for (std::size_t k = workers_.size(); k-- > 0 && troubles_.empty();) {
      if (Seconds(Clock::now() - workers_[k].begin).count() > job_.timeLimit) {
        const std::size_t run = workers_[k].run;
        ResultRow row;
        row.inputs = std::move(workers_[k].met);
        remove(k);
        row.reason = "not finished within " + base::formatDouble(job_.timeLimit) + " s";
        take(run, row);
      }
    }
  }

  void take(std::size_t run, const ResultRow& row) { troubles_ = job_.take(run, row); }

  void remove(std::size_t index) {
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
  }

  const BatchJob& job_;
  std::deque<std::size_t> waiting_;
  std::vector<Worker> workers_;
  std::map<std::size_t, int> crashes_;
  base::Diagnostics troubles_;
};

}  // namespace

base::Diagnostics runBatch(const BatchJob& job) {
  return Batch(job).run();
}

}  // namespace app
