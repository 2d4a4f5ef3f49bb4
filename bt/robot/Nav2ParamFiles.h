#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// Merges parameter files and single values of Nav2.
namespace bt {

/// `entries` are files and `name:=value` in the order of `--nav2-params`; later ones override
/// earlier ones. Files are relative to `folder`, otherwise names of shipped files. Without a file
/// in `entries` the default shipped file is used.
class Nav2ParamFiles {
 public:
  Nav2ParamFiles(const std::vector<std::string>& entries, const std::string& folder,
                 const Nav2Folders& shipped);

  /// Syntax problems of the files; with errors they cannot be merged.
  const base::Diagnostics& problems() const { return problems_; }
  const std::vector<std::string>& paths() const { return paths_; }  // of the files found
  const std::vector<std::string>& overrides() const { return overrides_; }

  /// Reads all entries with the scenario's `values` (see `setNav2Value`) applied on top. The
  /// distribution is that of `options`, otherwise guessed from the files only. Values that match no
  /// parameter are reported in `wrong`. Requires `problems()` without errors.
  sim2d::nav2::Nav2ReadResult read(const std::vector<std::pair<std::string, std::string>>& values,
                                   sim2d::nav2::Nav2ReadOptions options,
                                   base::Diagnostics& wrong) const;

 private:
  struct Entry {
    std::optional<sim2d::nav2::ParameterFile> file;  // empty: a single value
    sim2d::nav2::ParameterOverride single = {};
  };

  void addFile(const std::string& named, const std::string& folder, const Nav2Folders& shipped);
  sim2d::nav2::ParameterFile merged() const;
  sim2d::nav2::ParameterFile overridden(sim2d::nav2::Nav2ReadResult reading,
                                        const sim2d::nav2::Nav2ReadOptions& options,
                                        base::Diagnostics& wrong) const;

  std::vector<Entry> entries_;
  std::vector<std::string> paths_, overrides_;
  base::Diagnostics problems_;
};

}  // namespace bt
