#include "app/run/WorkerTasks.h"

#include <optional>
#include <utility>
#include <vector>

#include "app/run/Batch.h"

namespace app {

namespace {

struct RunningTask {
  WorkerProcess process;
  std::size_t task = 0;
};

/// Waits a little and takes the results of tasks that have ended.
void takeResults(const WorkerTasks& tasks, std::vector<RunningTask>& running) {
  std::vector<int> sockets;
  sockets.reserve(running.size());
  for (const RunningTask& each : running) {
    sockets.push_back(each.process.descriptor());
  }
  for (const std::size_t k : waitForData(sockets)) {
    std::string text;
    const WorkerProcess::ReadResult read = running[k].process.readMessage(text);
    if (read == WorkerProcess::ReadResult::Part) {
      continue;
    }
    const std::size_t task = running[k].task;
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(k));
    tasks.take(task, read == WorkerProcess::ReadResult::Answer ? text : std::string());
  }
}

}  // namespace

bool runTasks(const WorkerTasks& tasks) {
  std::vector<RunningTask> running;
  std::size_t next = 0;
  while ((next < tasks.count || !running.empty()) && !tasks.wantsStop()) {
    while (next < tasks.count && running.size() < static_cast<std::size_t>(tasks.jobs)) {
      std::optional<WorkerProcess> process = WorkerProcess::start(
          [&tasks, next](const std::string& /*request*/,
                         const WorkerProcess::SendMessage& /*tell*/) { return tasks.work(next); });
      if (!process) {
        break;
      }
      process->sendRequest({});
      running.push_back({*std::move(process), next++});
    }
    if (running.empty()) {
      return false;
    }
    takeResults(tasks, running);
  }
  return true;
}

}  // namespace app
