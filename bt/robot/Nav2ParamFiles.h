#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// Parameter files and single values of Nav2 that are read as one.
namespace bt {

/// `entries` are files and `name:=value`, as `--nav2-params` has them, in their order: later ones
/// win. Files are relative to `folder`, else shipped ones by their names; without a file in
/// `entries` the shipped one of a robot that names none.
class Nav2ParamFiles {
 public:
  Nav2ParamFiles(const std::vector<std::string>& entries, const std::string& folder,
                 const Nav2Folders& shipped);

  /// What is wrong with the files as text; with errors they cannot be read as one.
  const base::Diagnostics& problems() const { return problems_; }
  const std::vector<std::string>& paths() const { return paths_; }  // of those that were found
  const std::vector<std::string>& overrides() const { return overrides_; }

  /// All of it, with the values of a scenario (`values`, see `setNav2Value`) over it. The branch is
  /// that of `options`, else guessed from the files alone. Values that no parameter fits are put
  /// into `wrong`. Needs `problems()` without errors.
  sim2d::nav2::Nav2Reading read(const std::vector<std::pair<std::string, std::string>>& values,
                                sim2d::nav2::Nav2ReadOptions options,
                                base::Diagnostics& wrong) const;

 private:
  struct Entry {
    std::optional<sim2d::nav2::ParameterFile> file;  // none: a single value
    sim2d::nav2::ParameterOverride single = {};
  };

  void addFile(const std::string& named, const std::string& folder, const Nav2Folders& shipped);
  sim2d::nav2::ParameterFile merged() const;
  sim2d::nav2::ParameterFile overridden(sim2d::nav2::Nav2Reading reading,
                                        const sim2d::nav2::Nav2ReadOptions& options,
                                        base::Diagnostics& wrong) const;

  std::vector<Entry> entries_;
  std::vector<std::string> paths_, overrides_;
  base::Diagnostics problems_;
};

}  // namespace bt
