#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <thread>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/external/Descriptor.h"

namespace sim2d {

/// A program that runs beside us, in a process group of its own, with pipes at its standard input,
/// output and error and nothing else of ours. It ends with this object at the latest, and all that
/// it has started in its group; it is killed when we are. Thread: one at a time.
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
  int input() const { return input_.number(); }  // of it: we write; does not block, nor do the rest
  int output() const { return output_.number(); }
  int errors() const { return errors_.number(); }
  void closeInput() { input_.close(); }

  bool hasEnded() const;
  /// How it ended ("with exit code 3", "by signal 9 (Killed)"); none: it has not within `patience`.
  std::optional<std::string> ending(Milliseconds patience) const;

 private:
  ChildProcess() = default;
  /// The next two: 0, or why it did not work (errno).
  int openPipes(Descriptor (&theirs)[3]);
  int startBy(const std::string& file, std::vector<std::string>& words);

  pid_t id_ = -1;
  Descriptor input_, output_, errors_;
  /// Starts the program and stays: the kernel kills a child when the thread that started it ends.
  std::thread starter_;
  std::promise<void> isOver_;  // tells the starter to end
};

}  // namespace sim2d
