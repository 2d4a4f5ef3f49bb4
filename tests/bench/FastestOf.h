#pragma once

#include <algorithm>
#include <ctime>

#include <QElapsedTimer>

/// Processor time of this process [ms].
inline double processorMs() {
  timespec now = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The time of the fastest of some rounds [ms]: what else the machine does only adds to it.
template <typename Work>
double fastestOf(int rounds, const Work& work) {
  double best = 1e18;
  for (int round = 0; round < rounds; ++round) {
    QElapsedTimer timer;
    timer.start();
    work();
    best = std::min(best, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
  }
  return best;
}
