#include "app/run/Merge.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

#include "app/run/RunFolder.h"
#include "sim2d/base/Files.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct Part {
  std::string folder;
  std::unique_ptr<FolderLock> lock;
  std::unique_ptr<ResultStore> store;
};

/// The study in their folders; shards by number.
class Parts {
 public:
  base::Diagnostics add(const std::string& folder) {
    std::error_code ignored;
    if (!fs::exists(fs::path(folder) / "results.sqlite", ignored)) {
      return {base::error("batch.no-results", {}, folder)};
    }
    for (const auto& [number, part] : parts_) {  // this process has its lock already
      if (fs::equivalent(part.folder, folder, ignored)) {
        return {
            base::error("merge.twice", {part.store->study().shard.text(), part.folder}, folder)};
      }
    }
    Part part;
    part.folder = folder;
    base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
    base::Result<std::unique_ptr<ResultStore>> store =
        lock ? readResults(folder) : base::Result<std::unique_ptr<ResultStore>>(lock.diagnostics());
    if (!store) {
      return store.diagnostics();
    }
    part.lock = *std::move(lock);
    part.store = *std::move(store);
    return place(std::move(part));
  }

  /// What is not there.
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

  /// The whole, with the files of all.
  const Study& study() const { return study_; }
  const std::map<std::size_t, Part>& all() const { return parts_; }

 private:
  base::Diagnostics place(Part part) {
    const Study& study = part.store->study();
    base::Diagnostics problems;
    if (!parts_.empty()) {
      for (base::Diagnostic problem : differences(study_, study)) {
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
    if (!part.store->isComplete()) {
      problems.push_back(
          base::error("merge.incomplete",
                      {study.shard.text(), part.store->finished(), study.shard.runsOf(study.runs)},
                      part.folder));
    }
    addToWhole(study);
    parts_[study.shard.number] = std::move(part);
    return problems;
  }

  void addToWhole(const Study& study) {
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
      study_.timeLimit = 0.0;  // no one limit is that of all
    }
  }

  std::map<std::size_t, Part> parts_;
  Study study_;
};

base::Diagnostics copyFile(const fs::path& from, const fs::path& to) {
  constexpr std::size_t kPiece = std::size_t{1} << 16U;  // [B]
  std::ifstream file(from, std::ios::binary);
  base::GrowingFile copy(to.string());
  std::vector<char> piece(kPiece);
  while (file && !copy.hasFailed()) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    copy.append({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (!copy.hasFailed() && !file.eof()) {
    return {base::error("file.cannot-read", {"it is gone or damaged"}, from.string())};
  }
  return copy.finish();
}

/// Run folders that the shard kept; trace.json last, which makes a run of each.
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
    return {base::error("file.cannot-read", {error.message()}, runs.string())};
  }
  std::stable_partition(files.begin(), files.end(),
                        [](const fs::path& file) { return file.filename() != "trace.json"; });
  base::Diagnostics problems;
  for (const fs::path& file : files) {
    if (problems.empty()) {
      problems = copyFile(runs / file, fs::path(to) / file);
    }
  }
  return problems;
}

base::Diagnostics join(const Parts& parts, BatchFolder& output) {
  base::Diagnostics problems;
  for (const auto& [number, part] : parts.all()) {
    const base::Diagnostics unreadable = part.store->forEach([&](const StoredRun& stored) {
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
                                                       Earlier earlier) {
  Parts parts;
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

}  // namespace app
