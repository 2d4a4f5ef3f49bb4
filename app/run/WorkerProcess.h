#pragma once

#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>

namespace app {

/// A copy of this process that answers questions, one at a time, for as long as it is wanted. It
/// does not outlive its parent, hears nothing of Ctrl-C in the terminal, says nothing on standard
/// output or error, and holds none of the parent's open files. Messages are texts behind their
/// length of four bytes, over a pair of sockets. Of the parent only one thread may be running.
class WorkerProcess {
 public:
  /// Sends a message before the answer; it is received even if the process ends without an answer.
  using Tell = std::function<void(const std::string& text)>;
  /// Called in the new process for each question; what it throws ends the process.
  using Serve = std::function<std::string(const std::string& question, const Tell& tell)>;

  /// Nothing: the system gives no more processes or files.
  static std::optional<WorkerProcess> start(const Serve& serve);
  ~WorkerProcess();  // ends it
  WorkerProcess(WorkerProcess&& other) noexcept;
  WorkerProcess& operator=(WorkerProcess&& other) noexcept;
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// False: it is gone.
  bool ask(const std::string& question) const;

  int descriptor() const { return socket_; }  // readable when there is something to hear
  enum class Heard { Part, Answer, End };
  /// Reads the available data without waiting for more; an answer, or a message before it, is then
  /// in `answer`. More messages may have arrived with it, which descriptor() does not indicate.
  Heard hear(std::string& answer);

  /// Ends it, unless it has ended by itself; returns what waitpid tells.
  int end();
  std::size_t residentBytes() const;  // memory that it takes now; 0 = not known

 private:
  WorkerProcess(pid_t process, int socket) : process_(process), socket_(socket) {}

  pid_t process_ = -1;
  int socket_ = -1;
  std::string heard_;  // of the next answer
};

}  // namespace app
