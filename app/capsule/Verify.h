#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/capsule/Rerun.h"
#include "sim2d/base/Result.h"

namespace capsule {

struct VerifyOptions : RerunOptions {
  std::string file;                 // the capsule
  double share = 0.05;              // of the runs of a batch that are repeated, at least one run
  std::optional<std::size_t> runs;  // number of runs that are repeated, instead; 0: none
  std::uint64_t seed = 1;           // of the choice of these runs
};

/// What verify() has found.
struct Verification {
  std::string identity;         // SHA-256 of SHA256SUMS: equal for equal content
  std::string version, commit;  // of the program that made the study
  bool isBatch = true;
  std::size_t members = 0;
  std::size_t runs = 0;               // with a result
  std::vector<std::size_t> sample;    // indices of the runs that were chosen, sorted
  std::vector<std::size_t> repeated;  // those of them that have ended
  base::Diagnostics differences;      // errors, each with its place "FILE.hnv/MEMBER:LINE"
  base::Diagnostics warnings;         // another version of the program
  bool isEqual() const { return differences.empty() && repeated.size() == sample.size(); }
};

/// Compares all checksums of a capsule, its tables with each other and with the experiment, and a
/// sample of its runs with their repetition. Unpacks into a temporary folder. Errors: not a
/// capsule, damaged, not readable by this program; external code that was not packed; those of
/// rerunBatch().
base::Result<Verification> verify(const VerifyOptions& options);

/// Chooses `count` of these at random, without repetition; sorted.
std::vector<std::size_t> chooseRuns(std::vector<std::size_t> all, std::size_t count,
                                    std::uint64_t seed);

}  // namespace capsule
