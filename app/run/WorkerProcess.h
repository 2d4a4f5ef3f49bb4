#pragma once

#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>

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
  std::size_t residentBytes() const;  // present memory; 0 = unknown

 private:
  WorkerProcess(pid_t process, int socket) : process_(process), socket_(socket) {}

  pid_t process_ = -1;
  int socket_ = -1;
  std::string buffer_;  // received bytes of the next message
};

}  // namespace app
