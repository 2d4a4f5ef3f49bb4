#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/run/BatchFolder.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/SystemError.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct Part {
  std::string folder;
  LockedResults results;
  const ResultStore& store() const { return *results.store; }
};

/// The study of the given folders; shards by number.
class ShardSet {
 public:
  base::Diagnostics add(const std::string& folder) {
    std::error_code ignored;
    for (const auto& [number, part] : parts_) {  // this process already has its lock
      if (fs::equivalent(part.folder, folder, ignored)) {
        return {
            base::error("merge.twice", {part.store().study().shard.text(), part.folder}, folder)};
      }
    }
    base::Result<LockedResults> results = readResults(folder);
    return results ? place({folder, *std::move(results)}) : results.diagnostics();
  }

  /// Reports missing shards.
  base::Diagnostics check() const {
    base::Diagnostics problems;
    if (parts_.empty()) {
      return problems;
    }
    const std::size_t count = study().shard.count;
    for (std::size_t number = 1; number <= count; ++number) {
      if (parts_.count(number) == 0) {
        problems.push_back(base::error("merge.not-given", {Shard{number, count}.text()}));
      }
    }
    return problems;
  }

  /// The complete study, with the input files of all shards.
  const Study& study() const { return study_; }
  const std::map<std::size_t, Part>& all() const { return parts_; }

 private:
  base::Diagnostics place(Part part) {
    const Study& study = part.store().study();
    base::Diagnostics problems;
    if (!parts_.empty()) {
      for (base::Diagnostic problem : studyDifferences(study_, study)) {
        problem.file = part.folder + (problem.file.empty() ? "" : ": " + problem.file);
        problems.push_back(std::move(problem));
      }
    }
    if (!problems.empty()) {
      return problems;
    }
    if (const auto found = parts_.find(study.shard.number); found != parts_.end()) {
      return {base::error("merge.twice", {study.shard.text(), found->second.folder}, part.folder)};
    }
    if (!part.store().isComplete()) {
      problems.push_back(base::error(
          "merge.incomplete",
          {study.shard.text(), part.store().finished(), study.shard.runCount(study.runs)},
          part.folder));
    }
    addToStudy(study);
    parts_[study.shard.number] = std::move(part);
    return problems;
  }

  void addToStudy(const Study& study) {
    if (parts_.empty()) {
      study_ = study;
      return;
    }
    for (const InputHash& input : study.inputs) {
      const auto isIt = [&input](const InputHash& each) { return each.path == input.path; };
      if (std::none_of(study_.inputs.begin(), study_.inputs.end(), isIt)) {
        study_.inputs.push_back(input);
      }
    }
    if (study.timeLimit != study_.timeLimit) {
      study_.timeLimit = 0.0;  // the shards have different limits
    }
  }

  std::map<std::size_t, Part> parts_;
  Study study_;
};

base::Diagnostics copyFile(const std::string& from, const std::string& to) {
  base::AtomicFileWriter copy(to);
  const bool isRead = readPieces(from, [&copy](std::string_view piece) { copy.append(piece); });
  return isRead || copy.hasFailed() ? copy.finish()
                                    : base::Diagnostics{base::error(
                                          "file.cannot-read", {"it is missing or damaged"}, from)};
}

/// Copies kept run folders; trace.json last, because it makes a folder a run.
base::Diagnostics copyRuns(const std::string& from, const std::string& to) {
  const fs::path runs = fs::path(from) / "runs";
  std::error_code error;
  std::vector<fs::path> files;
  if (fs::is_directory(runs, error)) {
    constexpr auto kFollow = fs::directory_options::follow_directory_symlink;
    for (fs::recursive_directory_iterator at(runs, kFollow, error), end; !error && at != end;
         at.increment(error)) {
      if (!at->is_directory(error) && !error) {
        files.push_back(at->path().lexically_relative(runs));
      }
    }
  }
  if (error && error != std::errc::no_such_file_or_directory) {
    return {base::error("file.cannot-read", {base::systemErrorMessage(error)}, runs.string())};
  }
  std::stable_partition(files.begin(), files.end(),
                        [](const fs::path& file) { return file.filename() != "trace.json"; });
  base::Diagnostics problems;
  for (const fs::path& file : files) {
    if (problems.empty()) {
      problems = copyFile((runs / file).string(), (fs::path(to) / file).string());
    }
  }
  return problems;
}

base::Diagnostics join(const ShardSet& parts, BatchFolder& output) {
  base::Diagnostics problems;
  for (const auto& [number, part] : parts.all()) {
    const base::Diagnostics unreadable = part.store().forEach([&](const StoredRun& stored) {
      if (problems.empty()) {
        problems = output.add(stored);
      }
    });
    base::append(problems, unreadable);
    if (problems.empty()) {
      problems = copyRuns(part.folder, output.runsFolder());
    }
    if (!problems.empty()) {
      return problems;
    }
  }
  return output.finish();
}

}  // namespace

base::Result<std::unique_ptr<BatchFolder>> mergeShards(const std::string& output,
                                                       const std::vector<std::string>& shards,
                                                       ExistingBatch earlier) {
  ShardSet parts;
  base::Diagnostics problems;
  for (const std::string& shard : shards) {
    std::error_code ignored;
    if (fs::equivalent(shard, output, ignored)) {
      problems.push_back(base::error("merge.own-shard", {}, output));
    }
    base::append(problems, parts.add(shard));
  }
  base::append(problems, parts.check());
  if (base::hasErrors(problems)) {
    return problems;
  }
  Study study = parts.study();
  study.shard = Shard();
  base::Result<std::unique_ptr<BatchFolder>> folder = BatchFolder::open(output, study, earlier);
  if (!folder) {
    return folder.diagnostics();
  }
  problems = join(parts, **folder);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return folder;
}

namespace {

/// Quotes a word for the shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char each : word) {
    text += each == '\'' ? std::string("'\\''") : std::string(1, each);
  }
  return text + "'";
}

/// Options of `batch` that every shard receives.
std::string extraOptions(const ClusterJob& job) {
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

/// The common beginning of both scripts.
std::string scriptHeader(const ClusterJob& job, const std::string& use) {
  return "#!/bin/bash\n" + use +
         "# To continue after an interruption, start this script again. Finished runs are not "
         "repeated,\n"
         "# except runs whose process was killed or ran out of memory.\n"
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
         quoted(extraOptions(job)) +
         "\n"
         "mkdir -p \"$OUTPUT/shards\" || exit\n";
}

}  // namespace

std::string slurmScript(const ClusterJob& job) {
  return scriptHeader(
             job,
             "# A Slurm array job and a job that merges its parts. Start it on a host with sbatch: "
             "bash FILE\n"
             "# Arguments are passed to sbatch: bash FILE --partition=long --time=2:00:00\n"
             "# The folders must have the same paths on all nodes.\n") +
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
echo "jobs ${part%%;*} (parts) and ${merge%%;*} (merge); results: $OUTPUT/results.csv"
)";
}

std::string parallelScript(const ClusterJob& job) {
  return scriptHeader(
             job,
             "# Uses GNU parallel on this machine, or on several machines that share its folders:\n"
             "#   MACHINES=node1,8/node2,: bash FILE   (8/: eight parts in parallel; : this "
             "machine)\n") +
         R"(# A part with failed runs exits with code 1; merge reports missing runs.
seq "$CHUNKS" | parallel --sshlogin "${MACHINES:-:}" --env PROGRAM --env EXPERIMENT --env OUTPUT \
  --env CHUNKS --env MORE --workdir / --joblog "$OUTPUT/shards/parallel.log" \
  '"$PROGRAM" batch "$EXPERIMENT" -o "$OUTPUT/shards/{}" --shard "{}/$CHUNKS" --resume --jobs 1 $MORE'
shards=()
for ((k = 1; k <= CHUNKS; ++k)); do shards+=("$OUTPUT/shards/$k"); done
exec "$PROGRAM" merge --force -o "$OUTPUT" "${shards[@]}"
)";
}

}  // namespace app
