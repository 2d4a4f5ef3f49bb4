#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/Result.h"

namespace capsule {

// Names of members (FORMAT.md).
constexpr char kTypeMember[] = "mimetype";
constexpr char kTypeText[] = "application/x-hunavsim-capsule";
constexpr char kManifestMember[] = "manifest.json";
constexpr char kSumsMember[] = "SHA256SUMS";
constexpr char kInputsFolder[] = "inputs/";
constexpr char kSharedFolder[] = "inputs/shared/";
constexpr char kStudyFolder[] = "study/";

/// An input file of the study.
struct CapsuleInput {
  std::string path;    // as the study of the capsule records it (StudyMembers.h)
  std::string sha256;  // as the study recorded it
  std::string member;  // empty: external code that was not packed
};

/// manifest.json of a capsule: what it contains.
struct CapsuleManifest {
  static constexpr int kFormat = 1;

  bool isBatch = true;          // otherwise a single run
  std::string version, commit;  // of the program that made the study
  std::size_t runs = 1;         // of the study
  std::size_t finished = 1;     // among them, with a result
  bool allowsCode = false;      // runs may have started external programs
  /// For a batch the experiment first, for a run the scenario.
  std::vector<CapsuleInput> inputs;
  app::FileHashes members;  // all but the manifest itself and SHA256SUMS
};

/// The first program or library that was not packed; null: none.
const CapsuleInput* omittedCode(const CapsuleManifest& manifest);

/// The file content, with the version of this program.
std::string manifestText(const CapsuleManifest& manifest);
/// Errors: not the manifest of a capsule, or of a newer format.
base::Result<CapsuleManifest> parseCapsuleManifest(const std::string& text,
                                                   const std::string& file);

/// SHA256SUMS as sha256sum(1) writes it: all members, by name.
std::string sumsText(const app::FileHashes& members);
/// Lines that are not of that form are skipped.
app::FileHashes parseSums(const std::string& text);

}  // namespace capsule
