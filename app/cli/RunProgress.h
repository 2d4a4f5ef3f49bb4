#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "app/cli/Console.h"

namespace app {

/// The progress line of many runs: "search: 120 / at most 2000 runs, 3.4 runs/s, at most 9 min 12 s
/// left".
class RunProgress {
 public:
  /// `total`: number of runs; `mayEndEarlier`: it is a limit.
  RunProgress(bool quiet, std::size_t total, bool mayEndEarlier)
      : progress_(quiet), total_(total), mayEndEarlier_(mayEndEarlier) {}

  void setTotal(std::size_t total) { total_ = total; }
  void setStage(const std::string& stage) { stage_ = stage; }  // before the numbers
  void setNote(const std::string& note) { note_ = note; }      // after the numbers
  /// `executed`: the finished runs since the start of the command, without earlier results.
  void show(std::size_t finished, std::size_t executed);
  void clear() { progress_.clear(); }  // before other output on the terminal

 private:
  Progress progress_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::size_t total_;
  const bool mayEndEarlier_;
  std::string stage_, note_;
};

/// The numbers of the line. `rate`: runs per second; 0: not yet known. More runs than `total`: only
/// their number and the rate.
std::string runProgressText(std::size_t finished, std::size_t total, double rate,
                            bool mayEndEarlier);

}  // namespace app
