#pragma once

#include <string>

namespace app {

/// A study split over many processes or machines.
struct ClusterJob {
  std::string program, experiment, output;  // absolute paths, the same on all machines
  std::size_t chunks = 1;                   // shards: at most as many work at a time
  bool allowCode = false;                   // programs that scenarios name may start
  bool retryFailed = false;                 // a restarted part repeats failed runs
  double timeLimit = 0.0;                   // of a run [s]; 0 = none
};

/// A script for bash that hands the shards to Slurm as an array job and merges them behind it. Each
/// part begins with --resume: it may be stopped and queued again at any time.
std::string slurmScript(const ClusterJob& job);
/// The same by GNU parallel, on this machine or those of the variable MACHINES (--sshlogin).
std::string parallelScript(const ClusterJob& job);

}  // namespace app
