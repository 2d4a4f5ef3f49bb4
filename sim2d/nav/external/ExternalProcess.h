#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/base/Stop.h"
#include "sim2d/nav/external/ChildProcess.h"
#include "sim2d/nav/external/LineChannel.h"

namespace sim2d {

/// A program that answers line by line: started by us, or met at a local socket. Thread: one at a
/// time.
class ExternalProcess {
 public:
  /// `command`: see `commandWords`; or "unix:" and the path of a socket at which somebody listens.
  /// `stop` ends every wait at once, by `base::Stopped`. Errors: external.no-command,
  /// external.open-quote, external.not-started, external.not-connected.
  static base::Result<std::unique_ptr<ExternalProcess>> start(const std::string& command,
                                                              base::StopFlagPtr stop);
  static bool isSocket(const std::string& command);
  /// No child is left; neither is anything of its process group.
  ~ExternalProcess() = default;
  ExternalProcess(const ExternalProcess&) = delete;
  ExternalProcess& operator=(const ExternalProcess&) = delete;
  ExternalProcess(ExternalProcess&&) = delete;
  ExternalProcess& operator=(ExternalProcess&&) = delete;

  /// Sends the line and waits `timeout` [s] at most for the answer. After an error the child has
  /// been ended, and every further call gives the same error: external.died, .closed, .too-slow,
  /// .not-reading, .line-too-long, .unasked.
  base::Result<std::string> ask(const std::string& line, double timeout);
  /// Sends a last line, closes the child's input, and leaves it a moment to end by itself, unless
  /// it is to stop.
  void finish(const std::string& line);
  /// Ends the child now, as after an error.
  void abandon();
  pid_t childId() const { return child_ ? child_->id() : -1; }  // -1: none, or a socket

 private:
  ExternalProcess(std::string command, base::StopFlagPtr stop)
      : command_(std::move(command)), stop_(std::move(stop)) {}
  bool hasEnded() const { return child_ && child_->hasEnded(); }
  base::Diagnostic errorOf(LineChannel::Outcome outcome, double timeout);
  base::Diagnostic lossOf(LineChannel::Outcome outcome);

  std::string command_;
  base::StopFlagPtr stop_;
  std::unique_ptr<ChildProcess> child_;  // null: a socket, or ended
  Descriptor socket_;
  std::unique_ptr<LineChannel> channel_;  // null: ended
  std::optional<base::Diagnostic> error_;
};

}  // namespace sim2d
