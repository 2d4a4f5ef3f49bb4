#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace app {

/// Independent tasks, each in a copy of this process. The calling process must have one thread.
struct WorkerTasks {
  std::size_t count = 0;
  int jobs = 1;  // copies at a time
  /// In the copy: the result of a task as text.
  std::function<std::string(std::size_t task)> work;
  /// In this process, in the order in which the tasks end. Empty text: the copy ended unexpectedly.
  std::function<void(std::size_t task, const std::string& text)> take;
  std::function<bool()> wantsStop;  // called often
};

/// Returns when all tasks have ended or `wantsStop` returns true. False: the system has no more
/// processes.
bool runTasks(const WorkerTasks& tasks);

}  // namespace app
