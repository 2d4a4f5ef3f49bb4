#pragma once

#include <string>

#include "app/capsule/Archive.h"
#include "app/capsule/CapsuleManifest.h"
#include "app/capsule/TableDifferences.h"
#include "sim2d/base/Result.h"

/// Checks of a capsule that need no runs. Differences are errors, located by "FILE.hnv/MEMBER".
namespace capsule {

/// Compares the members (with their SHA-256) with manifest.json and SHA256SUMS: missing, additional
/// and changed members.
base::Diagnostics memberDifferences(const CapsuleManifest& manifest, const std::string& sums,
                                    const app::FileHashes& members, const std::string& file);

/// Compares an unpacked capsule with what its study recorded: inputs, and files that the manifests
/// of the study and of its runs list.
base::Diagnostics recordDifferences(const CapsuleManifest& manifest, const std::string& root,
                                    const std::string& file);

/// Compares the results of an unpacked batch with each other (results.csv, results.sqlite,
/// manifest.json) and with the plan of its experiment: scenario, seed and values of each run.
/// `table`: results.csv.
base::Diagnostics resultDifferences(const CapsuleManifest& manifest, const ResultTable& table,
                                    const std::string& root, const std::string& file);

}  // namespace capsule
