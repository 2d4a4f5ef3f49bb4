#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/ManifestFiles.h"
#include "app/run/ResultRow.h"

namespace app {

/// Reads the bundles of many runs. Shared data (scenarios, maps, trees) is read and computed once,
/// and not changed by runs; input files are hashed at first use. One thread.
class BundleReader {
 public:
  /// `loader` reads map images other than PGM.
  explicit BundleReader(sim2d::ImageLoader loader)
      : loader_(std::move(loader)), files_(std::make_unique<FileCache>(loader_)) {}

  /// Indices of files among inputs().
  using FileIndices = std::vector<std::size_t>;
  /// The bundle of a run. `used` receives the files that the run reads, and the code that it
  /// starts.
  Bundle read(const RunSpec& spec, const RunSettings& settings, FileIndices& used);
  /// The bundle of a run that is only checked: its files do not become inputs().
  Bundle readToCheck(const RunSpec& spec) { return readBundle(spec, RunSettings(), *files_); }

  /// All files so far as they were at first use, each once.
  const std::vector<InputHash>& inputs() const { return fingerprints_.all(); }
  /// These files as they were at first use; one that has changed since is followed by a second
  /// entry.
  std::vector<InputHash> withChanges(const FileIndices& files) {
    return fingerprints_.withChanges(files);
  }

 private:
  const FileIndices& filesOf(const Bundle& bundle);

  const sim2d::ImageLoader loader_;
  std::unique_ptr<FileCache> files_;
  InputFingerprints fingerprints_;
  std::map<std::vector<std::string>, FileIndices>
      inputsByBundle_;  // named inputs of a bundle -> all input files
};

/// Runs the world of a bundle in memory and measures it; nothing is written. A run that cannot
/// start is a failed row. The row has no inputs, and trees only if it `keepsTrees`.
ResultRow measureRun(const Bundle& bundle, bool keepsTrees = false);

}  // namespace app
