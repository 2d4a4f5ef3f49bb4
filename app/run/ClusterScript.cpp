#include "app/run/ClusterScript.h"

#include <vector>

#include "sim2d/base/Text.h"

namespace app {

namespace {

/// A word that the shell takes as it is.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char each : word) {
    text += each == '\'' ? std::string("'\\''") : std::string(1, each);
  }
  return text + "'";
}

/// Options of `batch` that every part gets.
std::string moreOf(const ClusterJob& job) {
  std::vector<std::string> words;
  if (job.allowCode) {
    words.emplace_back("--allow-code");
  }
  if (job.retryFailed) {
    words.emplace_back("--retry-failed");
  }
  if (job.timeLimit > 0.0) {
    words.push_back("--time-limit " + base::formatDouble(job.timeLimit));
  }
  return base::join(words, " ");
}

/// What both scripts begin with.
std::string beginning(const ClusterJob& job, const std::string& use) {
  return "#!/bin/bash\n" + use +
         "# Start it again when it was interrupted: finished runs are not repeated, except for "
         "runs whose\n# process was killed or ran out of memory.\n"
         "set -u\n"
         "export PROGRAM=" +
         quoted(job.program) +
         "\n"
         "export EXPERIMENT=" +
         quoted(job.experiment) +
         "\n"
         "export OUTPUT=" +
         quoted(job.output) +
         "\n"
         "export CHUNKS=" +
         std::to_string(job.chunks) +
         "\n"
         "export MORE=" +
         quoted(moreOf(job)) +
         "\n"
         "mkdir -p \"$OUTPUT/shards\" || exit\n";
}

}  // namespace

std::string slurmScript(const ClusterJob& job) {
  return beginning(
             job,
             "# An array job of Slurm and a job that merges its parts. Start it where sbatch "
             "is: bash FILE\n"
             "# Words of this script go to sbatch: bash FILE --partition=long --time=2:00:00\n"
             "# The folders must be the same on all nodes.\n") +
         R"(part=$(sbatch --parsable "$@" --job-name=hunavsim --array="1-$CHUNKS" --requeue --open-mode=append \
  --output="$OUTPUT/shards/%a.log" <<'PART'
#!/bin/bash
shard=$SLURM_ARRAY_TASK_ID
exec "$PROGRAM" batch "$EXPERIMENT" -o "$OUTPUT/shards/$shard" --shard "$shard/$CHUNKS" --resume \
  --jobs "${SLURM_CPUS_PER_TASK:-1}" $MORE
PART
) || exit
merge=$(sbatch --parsable "$@" --job-name=hunavsim-merge --dependency="afterany:${part%%;*}" \
  --open-mode=append --output="$OUTPUT/shards/merge.log" <<'MERGE'
#!/bin/bash
shards=()
for ((k = 1; k <= CHUNKS; ++k)); do shards+=("$OUTPUT/shards/$k"); done
exec "$PROGRAM" merge --force -o "$OUTPUT" "${shards[@]}"
MERGE
) || exit
echo "jobs ${part%%;*} (parts) and ${merge%%;*} (merge); then $OUTPUT/results.csv"
)";
}

std::string parallelScript(const ClusterJob& job) {
  return beginning(job,
                   "# GNU parallel on this machine, or on others that share its folders:\n"
                   "#   MACHINES=node1,8/node2,: bash FILE   (8/: eight parts at a time; : is this "
                   "one)\n") +
         R"(# A part that holds failed runs ends with 1; what is missing is told by merge.
seq "$CHUNKS" | parallel --sshlogin "${MACHINES:-:}" --env PROGRAM --env EXPERIMENT --env OUTPUT \
  --env CHUNKS --env MORE --workdir / --joblog "$OUTPUT/shards/parallel.log" \
  '"$PROGRAM" batch "$EXPERIMENT" -o "$OUTPUT/shards/{}" --shard "{}/$CHUNKS" --resume --jobs 1 $MORE'
shards=()
for ((k = 1; k <= CHUNKS; ++k)); do shards+=("$OUTPUT/shards/$k"); done
exec "$PROGRAM" merge --force -o "$OUTPUT" "${shards[@]}"
)";
}

}  // namespace app
