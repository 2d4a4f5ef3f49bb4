#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/capsule/Archive.h"
#include "app/capsule/StudySource.h"
#include "sim2d/base/Result.h"

/// The files of a study as members of a capsule, without paths of the machine that it was made on.
namespace capsule {

/// Replaces absolute paths in texts: those of inputs by their names in the capsule, that of the
/// study by "study", that of the program by "hunavsim". Relative paths stay.
class PathNames {
 public:
  PathNames() = default;
  /// `members`: names of the inputs in the capsule; empty: not packed.
  PathNames(const StudySource& source, const std::vector<std::string>& members);
  std::string replaced(std::string text) const;

 private:
  void add(const std::string& path, const std::string& name);

  std::vector<std::pair<std::string, std::string>> names_;  // the longest path first
};

/// Results, tables, pages and manifests name the inputs as PathNames does; manifests list the
/// hashes of the changed files. `temporary`: folder for changed files, which must exist until the
/// archive has been written. Errors: a file cannot be read or written.
base::Result<std::vector<ArchiveMember>> studyMembers(const StudySource& source,
                                                      const PathNames& names,
                                                      const std::string& temporary);

}  // namespace capsule
