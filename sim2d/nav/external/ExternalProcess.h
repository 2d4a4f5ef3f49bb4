#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <thread>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/nav/external/LineChannel.h"

namespace sim2d {

using base::FileDescriptor;

/// A child process in its own process group, connected by pipes to its standard input, output and
/// error; it inherits no other descriptors. The destructor ends it and all processes of its group;
/// the kernel kills it when this program dies. Not thread-safe.
class ChildProcess {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// `words`: the program and its arguments. Errors: external.not-started.
  static base::Result<std::unique_ptr<ChildProcess>> start(std::vector<std::string> words);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ChildProcess(ChildProcess&&) = delete;
  ChildProcess& operator=(ChildProcess&&) = delete;

  pid_t id() const { return id_; }
  int input() const { return input_.number(); }  // write end; all three are non-blocking
  int output() const { return output_.number(); }
  int errors() const { return errors_.number(); }
  void closeInput() { input_.close(); }

  bool hasEnded() const;
  /// How it ended ("with exit code 3", "by signal 9 (Killed)"); none: it has not ended within
  /// `patience`.
  std::optional<std::string> waitForExit(Milliseconds patience) const;

 private:
  ChildProcess() = default;
  /// openPipes and startBy return 0 or errno.
  int openPipes(FileDescriptor (&theirs)[3]);
  int startBy(const std::string& file, std::vector<std::string>& words);

  pid_t id_ = -1;
  FileDescriptor input_, output_, errors_;
  /// Thread that starts the child and then waits: the kernel kills a child when the thread that
  /// started it ends (PR_SET_PDEATHSIG).
  std::thread starterThread_;
  std::promise<void> isOver_;  // signals the starter thread to end
};

/// A program that answers line by line: a child process or the peer of a local socket. Not
/// thread-safe.
class ExternalProcess {
 public:
  /// `command`: see `splitCommandLine`; or "unix:" and the path of a listening socket. `stop`
  /// interrupts every wait with `base::Stopped`. Errors: external.no-command, external.open-quote,
  /// external.not-started, external.not-connected.
  static base::Result<std::unique_ptr<ExternalProcess>> start(const std::string& command,
                                                              base::StopFlagPtr stop);
  static bool isSocket(const std::string& command);
  /// Ends the child and its process group.
  ~ExternalProcess() = default;
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;
  ExternalProcess(ExternalProcess&&) = delete;
  ExternalProcess& operator=(ExternalProcess&&) = delete;

  /// Sends the line and waits at most `timeout` [s] for the answer. After an error the child has
  /// been ended and every further call returns the same error: external.died, .closed, .too-slow,
  /// .not-reading, .line-too-long, .unasked.
  base::Result<std::string> ask(const std::string& line, double timeout);
  /// Sends a last line, closes the child's input, and waits briefly for its exit, unless the stop
  /// flag is set.
  void finish(const std::string& line);
  /// Ends the child immediately, as after an error.
  void abandon();
  pid_t childId() const { return child_ ? child_->id() : -1; }  // -1: none, or a socket

 private:
  ExternalProcess(std::string command, base::StopFlagPtr stop)
      : command_(std::move(command)), stop_(std::move(stop)) {}
  bool hasEnded() const { return child_ && child_->hasEnded(); }
  base::Diagnostic errorOf(LineChannel::Outcome outcome, double timeout);
  base::Diagnostic connectionLoss(LineChannel::Outcome outcome);

  std::string command_;
  base::StopFlagPtr stop_;
  std::unique_ptr<ChildProcess> child_;  // null: a socket, or ended
  FileDescriptor socket_;
  std::unique_ptr<LineChannel> channel_;  // null: ended
  std::optional<base::Diagnostic> error_;
};

}  // namespace sim2d
