#pragma once

#include <string>
#include <vector>

#include "app/run/BatchFolder.h"

namespace app {

/// Joins the folders of all shards of one study in `output`: results.csv is identical to that of a
/// batch without shards; kept run folders are copied. Errors, all of them at a time: shards of
/// different studies, duplicated, missing or incomplete.
base::Result<std::unique_ptr<BatchFolder>> mergeShards(const std::string& output,
                                                       const std::vector<std::string>& shards,
                                                       ExistingBatch earlier);

/// A study that is split over several processes or machines.
struct ClusterJob {
  std::string program, experiment, output;  // absolute paths, the same on all machines
  std::size_t chunks = 1;                   // number of shards
  bool allowCode = false;                   // external programs of scenarios may start
  bool retryFailed = false;                 // a restarted shard repeats failed runs
  double timeLimit = 0.0;                   // of a run [s]; 0 = none
};

/// A bash script that submits the shards to Slurm as an array job and a dependent job that merges
/// them. Each shard starts with --resume: it can be stopped and requeued at any time.
std::string slurmScript(const ClusterJob& job);
/// The same with GNU parallel, on this machine or those of the variable MACHINES (--sshlogin).
std::string parallelScript(const ClusterJob& job);

}  // namespace app
