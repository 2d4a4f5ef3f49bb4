#include "app/capsule/Verify.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "app/capsule/Archive.h"
#include "app/capsule/Integrity.h"
#include "app/capsule/Unpacked.h"
#include "app/run/DataPaths.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSums = std::size_t{256} << 20U;  // [B]

/// The working folder of this process while it exists.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::string& folder) {
    std::error_code ignored;
    former_ = fs::current_path(ignored);
    if (!folder.empty()) {
      fs::current_path(folder, ignored);
    }
  }
  ~WorkingFolder() {
    std::error_code ignored;
    fs::current_path(former_, ignored);
  }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;
  WorkingFolder(WorkingFolder&&) = delete;
  WorkingFolder& operator=(WorkingFolder&&) = delete;

 private:
  fs::path former_;
};

/// Verifies one capsule that has been opened.
class Verifier {
 public:
  Verifier(const VerifyOptions& options, const ArchiveReader& archive,
           const CapsuleManifest& manifest, std::string root)
      : options_(options),
        archive_(archive),
        manifest_(manifest),
        root_(std::move(root)),
        capsule_{manifest, root_, options.file} {}

  base::Result<Verification> run() {
    result_.version = manifest_.version;
    result_.commit = manifest_.commit;
    result_.isBatch = manifest_.isBatch;
    warnOfOtherProgram();
    base::Diagnostics problems = compareMembers();
    if (problems.empty()) {
      problems = manifest_.isBatch ? verifyBatch() : verifySingle();
    }
    return base::resultOf(std::move(result_), std::move(problems));
  }

 private:
  void warnOfOtherProgram() {
    const std::string then = manifest_.version + " (" + manifest_.commit + ")";
    const std::string now = app::programVersion() + " (" + app::programCommit() + ")";
    if (then != now) {
      result_.warnings.push_back(
          base::warning("capsule.other-program", {then, now}, options_.file));
    }
  }

  /// Unpacks everything. Errors: damaged members.
  base::Diagnostics compareMembers() {
    app::FileHashes hashes;
    base::Diagnostics damaged = archive_.extract(
        root_, {},
        [&hashes](const std::string& name, const std::string& sha256) { hashes[name] = sha256; });
    if (!damaged.empty()) {
      return damaged;
    }
    result_.members = hashes.size();
    const base::Result<std::string> sums = archive_.text(kSumsMember, kMaxSums);
    if (sums) {
      result_.identity = app::sha256Of(*sums);
    } else {
      result_.differences = sums.diagnostics();
    }
    base::append(result_.differences,
                 memberDifferences(manifest_, sums ? *sums : "", hashes, options_.file));
    std::set<std::string> places;
    for (const base::Diagnostic& problem : result_.differences) {
      places.insert(problem.file);
    }
    for (const base::Diagnostic& problem : recordDifferences(manifest_, root_, options_.file)) {
      if (problem.code != "capsule.checksum" || places.count(problem.file) == 0) {
        result_.differences.push_back(problem);
      }
    }
    return {};
  }

  base::Diagnostics verifyBatch() {
    const std::string member = std::string(kStudyFolder) + "results.csv";
    const base::Result<std::string> text = base::readTextFile(app::pathIn(root_, member));
    const base::Result<ResultTable> table =
        text ? readResultTable(*text, options_.file + "/" + member)
             : base::Result<ResultTable>(text.diagnostics());
    if (!table) {
      base::append(result_.differences, atMembers(table.diagnostics(), root_, options_.file));
      return {};
    }
    {
      const app::DataFolderOverride shipped(app::pathIn(root_, kSharedFolder));
      base::append(result_.differences, resultDifferences(manifest_, *table, root_, options_.file));
    }
    result_.runs = table->rows.size();
    result_.sample = sampleOf(*table);
    if (result_.sample.empty()) {
      return {};
    }
    if (base::Diagnostics omitted = codeProblems(); !omitted.empty()) {
      return omitted;
    }
    const WorkingFolder working(programFolder());
    base::Result<Rerun> rerun = rerunBatch(capsule_, *table, result_.sample, options_);
    return rerun ? takeRerun(*rerun) : rerun.diagnostics();
  }

  base::Diagnostics verifySingle() {
    result_.runs = 1;
    base::Diagnostics moved = relocateRun(manifest_, root_);
    if (!moved.empty()) {
      base::append(result_.differences, atMembers(moved, root_, options_.file));
      return {};
    }
    if (options_.runs == std::size_t{0}) {
      return {};
    }
    if (base::Diagnostics omitted = codeProblems(); !omitted.empty()) {
      return omitted;
    }
    result_.sample = {0};
    const WorkingFolder working(programFolder());
    base::Result<Rerun> rerun = rerunSingle(capsule_, options_);
    return rerun ? takeRerun(*rerun) : rerun.diagnostics();
  }

  /// Where commands of external planners begin; empty: none may start.
  std::string programFolder() const {
    return options_.allowCode ? workingFolderOf(manifest_, root_) : std::string();
  }

  /// Error: runs would start code that was not packed.
  base::Diagnostics codeProblems() const {
    const CapsuleInput* const omitted = omittedCode(manifest_);
    return omitted == nullptr ? base::Diagnostics()
                              : base::Diagnostics{base::error("capsule.code-omitted",
                                                              {omitted->path}, options_.file)};
  }

  base::Diagnostics takeRerun(const Rerun& rerun) {
    result_.repeated = rerun.finished;
    base::append(result_.differences, rerun.differences);
    return {};
  }

  std::vector<std::size_t> sampleOf(const ResultTable& table) const {
    std::vector<std::size_t> all;
    for (const auto& [run, row] : table.rows) {
      if (run >= 0) {
        all.push_back(static_cast<std::size_t>(run));
      }
    }
    const auto share = std::ceil(options_.share * static_cast<double>(all.size()));
    const std::size_t count = options_.runs.value_or(static_cast<std::size_t>(share));
    return chooseRuns(std::move(all), count, options_.seed);
  }

  const VerifyOptions& options_;
  const ArchiveReader& archive_;
  const CapsuleManifest& manifest_;
  const std::string root_;
  const UnpackedCapsule capsule_;
  Verification result_;
};

}  // namespace

std::vector<std::size_t> chooseRuns(std::vector<std::size_t> all, std::size_t count,
                                    std::uint64_t seed) {
  count = std::min(count, all.size());
  const base::AgentRng random(seed, 0);
  for (std::size_t k = 0; k < count; ++k) {  // Fisher and Yates
    const double draw = random.uniform01(base::DrawPurpose::Audit, static_cast<std::uint32_t>(k));
    const auto left = static_cast<double>(all.size() - k);
    std::swap(all[k], all[k + static_cast<std::size_t>(draw * left)]);
  }
  all.resize(count);
  std::sort(all.begin(), all.end());
  return all;
}

base::Result<Verification> verify(const VerifyOptions& options) {
  const base::Result<std::unique_ptr<ArchiveReader>> archive = ArchiveReader::open(options.file);
  if (!archive) {
    return archive.diagnostics();
  }
  const base::Result<CapsuleManifest> manifest = readCapsuleManifest(**archive, options.file);
  if (!manifest) {
    return manifest.diagnostics();
  }
  const base::Result<TemporaryFolder> folder = TemporaryFolder::create();
  if (!folder) {
    return folder.diagnostics();
  }
  return Verifier(options, **archive, *manifest, app::pathIn(folder->path(), "capsule")).run();
}

}  // namespace capsule
