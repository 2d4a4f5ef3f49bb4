#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/capsule/CapsuleManifest.h"
#include "app/capsule/TableDifferences.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/map/MapReader.h"

/// Repeats runs of an unpacked capsule and compares their results with the stored ones.
namespace capsule {

struct RerunOptions {
  int jobs = 1;               // number of parallel processes
  bool allowCode = false;     // external programs and libraries of the study may start
  sim2d::ImageLoader loader;  // for map images other than PGM
  base::StopFlagPtr stop;     // ends the repetition early; null: never
  std::function<void(std::size_t finished, std::size_t total)> showProgress;
};

/// The unpacked capsule.
struct UnpackedCapsule {
  const CapsuleManifest& manifest;
  std::string root;  // folder
  std::string file;  // name of the capsule, for messages
};

/// What was compared.
struct Rerun {
  std::vector<std::size_t> finished;  // indices of runs
  base::Diagnostics differences;      // errors with their places in the capsule
};

/// Repeats these runs of a batch. Compares rows of results.csv (`table`) and, for runs whose folder
/// was kept, its files. Errors: external code is not allowed, temporary files cannot be written,
/// processes cannot be started.
base::Result<Rerun> rerunBatch(const UnpackedCapsule& capsule, const ResultTable& table,
                               const std::vector<std::size_t>& runs, const RerunOptions& options);

/// Repeats a single run with its recorded inputs; it has been relocated. Errors as above.
base::Result<Rerun> rerunSingle(const UnpackedCapsule& capsule, const RerunOptions& options);

/// Compares files of a run that do not depend on the clock: those of the folder `place` of the
/// capsule ("study/runs/3/") with those of the repeated run. `withMetrics`: also the metrics.
base::Diagnostics runFolderDifferences(const UnpackedCapsule& capsule, const std::string& place,
                                       const std::string& repeated, bool withMetrics);

}  // namespace capsule
