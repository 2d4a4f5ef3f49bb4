#include "app/run/Batch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <exception>
#include <fcntl.h>
#include <iterator>
#include <map>
#include <new>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using Length = std::uint32_t;  // in host byte order: both ends are on one machine

/// Sends all bytes; false: the other end has closed.
bool sendAll(int socket, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) {
      return false;
    }
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

bool sendMessage(int socket, const std::string& text) {
  const auto length = static_cast<Length>(text.size());
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return sendAll(socket, bytes + text);
}

/// Moves the first complete message from `bytes` to `text`.
bool takeMessage(std::string& bytes, std::string& text) {
  Length length = 0;
  if (bytes.size() < sizeof length) {
    return false;
  }
  std::memcpy(&length, bytes.data(), sizeof length);
  if (bytes.size() < sizeof length + length) {
    return false;
  }
  text = bytes.substr(sizeof length, length);
  bytes.erase(0, sizeof length + length);
  return true;
}

/// Appends the available data; 0 = the other end has closed, negative = no data now.
ssize_t receive(int socket, std::string& bytes, int flags) {
  std::array<char, 16384> piece;  // NOLINT: written before it is read
  const ssize_t count = ::recv(socket, piece.data(), piece.size(), flags);
  if (count > 0) {
    bytes.append(piece.data(), static_cast<std::size_t>(count));
  } else if (count < 0 && errno != EINTR && errno != EAGAIN) {
    return 0;
  }
  return count;
}

/// In the worker: keeps only its socket, as file descriptor `kSocket`.
constexpr int kSocket = 3;
void isolateFromParent(int socket, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) {
    ::_exit(0);  // the parent has ended already
  }
  ::setpgid(0, 0);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::signal(SIGHUP, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::dup2(nowhere, standard);
  }
  ::dup2(socket, kSocket);
  ::close_range(kSocket + 1, ~0U, 0);  // including locks and the sockets of other workers
}

[[noreturn]] void serveRequests(const WorkerProcess::RequestHandler& serve) noexcept {
  std::string bytes, request;
  const WorkerProcess::SendMessage tell = [](const std::string& text) {
    sendMessage(kSocket, text);
  };
  while (true) {
    if (!takeMessage(bytes, request)) {
      if (receive(kSocket, bytes, 0) == 0) {
        ::_exit(0);
      }
      continue;
    }
    if (!sendMessage(kSocket, serve(request, tell))) {
      ::_exit(0);
    }
  }
}

}  // namespace

std::optional<WorkerProcess> WorkerProcess::start(const RequestHandler& serve) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return std::nullopt;
  }
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process == 0) {
    isolateFromParent(ends[1], parent);
    serveRequests(serve);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    return std::nullopt;
  }
  return WorkerProcess(process, ends[0]);
}

WorkerProcess::~WorkerProcess() {
  end();
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      socket_(std::exchange(other.socket_, -1)),
      buffer_(std::move(other.buffer_)) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(socket_, other.socket_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

bool WorkerProcess::sendRequest(const std::string& request) const {
  return sendMessage(socket_, request);
}

WorkerProcess::ReadResult WorkerProcess::readMessage(std::string& answer) {
  if (takeMessage(buffer_, answer)) {
    return ReadResult::Answer;  // it arrived together with the previous one
  }
  if (receive(socket_, buffer_, MSG_DONTWAIT) == 0) {
    return ReadResult::End;
  }
  return takeMessage(buffer_, answer) ? ReadResult::Answer : ReadResult::Part;
}

int WorkerProcess::end() {
  int status = 0;
  if (process_ > 0) {
    ::kill(process_, SIGKILL);  // no effect if it has ended: waitpid follows
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    ::close(socket_);
    process_ = socket_ = -1;
  }
  return status;
}

int processorCount() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::vector<std::size_t> waitForData(const std::vector<int>& descriptors) {
  constexpr int kPollMs = 100;
  std::vector<pollfd> polled;
  polled.reserve(descriptors.size());
  for (const int descriptor : descriptors) {
    polled.push_back({descriptor, POLLIN, 0});
  }
  std::vector<std::size_t> ready;
  const bool isAnyReady = ::poll(polled.data(), polled.size(), kPollMs) > 0;
  for (std::size_t k = polled.size(); isAnyReady && k-- > 0;) {
    if (polled[k].revents != 0) {
      ready.push_back(k);
    }
  }
  return ready;
}

std::size_t WorkerProcess::residentBytes() const {
  const base::Result<std::string> text =
      base::readTextFile("/proc/" + std::to_string(process_) + "/statm");
  const std::vector<std::string> words =
      base::split(text ? *text : std::string(), ' ');  // pages: all, resident, …
  const std::optional<long long> pages = words.size() > 1 ? base::parseInt(words[1]) : std::nullopt;
  return pages ? static_cast<std::size_t>(*pages) * static_cast<std::size_t>(::getpagesize()) : 0;
}

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

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
  const Json json = Json::parse(base::shallowJson(text), nullptr, false);
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
    row.reason = base::exceptionMessage(problem);
    const bool hadNoMemory = dynamic_cast<const std::bad_alloc*>(&problem) != nullptr;
    row.failedBy = hadNoMemory ? FailedBy::Machine : FailedBy::Run;
    return serializeRow(row);
  }
}

/// Signals from outside the run: by the system when memory is exhausted, by a queue at its time
/// limit, by users. All other signals are caused by the run itself.
bool isExternalSignal(int signal) {
  constexpr int kExternal[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGXCPU};
  return std::count(std::begin(kExternal), std::end(kExternal), signal) > 0;
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
    std::vector<int> sockets;
    sockets.reserve(workers_.size());
    for (const Worker& worker : workers_) {
      sockets.push_back(worker.process.descriptor());
    }
    for (const std::size_t k : waitForData(sockets)) {
      if (problems_.empty()) {
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
    if (!base::startsWith(message, kInputsPrefix)) {
      return false;
    }
    worker.reportInputs = parseRow(message.substr(std::strlen(kInputsPrefix))).inputs;
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
