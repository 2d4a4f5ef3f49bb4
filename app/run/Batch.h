#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "app/run/ResultRow.h"

namespace app {

/// A forked copy of this process that answers requests one at a time. It ends with its parent,
/// ignores Ctrl-C in the terminal, writes nothing to standard output or error, and has none of the
/// parent's open files. Messages are text with a four-byte length prefix over a socket pair. The
/// parent must have only one thread at the fork.
class WorkerProcess {
 public:
  /// Sends a message before the answer; it is received even if the process ends without an answer.
  using SendMessage = std::function<void(const std::string& text)>;
  /// Called in the worker for each request; an exception ends the process.
  using RequestHandler =
      std::function<std::string(const std::string& request, const SendMessage& tell)>;

  /// nullopt: the system has no more processes or file descriptors.
  static std::optional<WorkerProcess> start(const RequestHandler& serve);
  ~WorkerProcess();  // kills the process
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&& other) noexcept;
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// False: the process has ended.
  bool sendRequest(const std::string& request) const;

  int descriptor() const { return socket_; }  // readable when data has arrived
  enum class ReadResult { Part, Answer, End };
  /// Reads the available data without blocking; an answer, or a message before it, is then in
  /// `answer`. More messages may have arrived with it, which descriptor() does not indicate.
  ReadResult readMessage(std::string& answer);

  /// Kills the process if it is still running; returns its waitpid status.
  int end();
  std::size_t residentBytes() const;  // current memory; 0 = unknown

 private:
  WorkerProcess(pid_t process, int socket) : process_(process), socket_(socket) {}

  pid_t process_ = -1;
  int socket_ = -1;
  std::string buffer_;  // received bytes of the next message
};

/// Waits up to 100 ms until one of these has data or is closed. Returns the indices of those, the
/// last one first.
std::vector<std::size_t> waitForData(const std::vector<int>& descriptors);

/// The number of processors that this process may use, at least 1: how many workers run by default.
int processorCount();

/// The runs of a batch and how to execute them.
struct BatchJob {
  std::vector<std::size_t> runs;                               // indices, in starting order
  int jobs = 1;                                                // maximum number of worker processes
  double timeLimit = std::numeric_limits<double>::infinity();  // of one run [s], wall-clock time
  std::size_t runsPerWorker = 1000;  // a worker is then replaced, which bounds its memory
  std::size_t maxGrowth = std::size_t{512}
                          << 20U;  // likewise, for memory growth after its first run [B]
  /// Executes a run in a worker. Error: its files cannot be written, which ends the batch.
  /// `reportInputs` receives the input files as soon as they are known, for the row of a run that
  /// crashes or exceeds its time limit.
  using ReportInputs = std::function<void(const std::vector<InputHash>& files)>;
  std::function<base::Result<ResultRow>(std::size_t run, const ReportInputs& reportInputs)> execute;
  /// Receives each row in this process as soon as it exists. An error ends the batch.
  std::function<base::Diagnostics(std::size_t run, const ResultRow& row)> storeRow;
  std::function<bool()> wantsStop;  // called often
};

/// Executes the runs in worker processes, each of which executes many (Box2D has process-wide
/// statics, so parallel worlds need processes). A worker that crashes or is killed is replaced and
/// its run repeated once; a run whose worker ends twice has failed (ResultRow::failedBy). Returns
/// when all runs have ended or `wantsStop` returns true; unfinished runs leave no result. One
/// thread.
base::Diagnostics runBatch(const BatchJob& job);

}  // namespace app
