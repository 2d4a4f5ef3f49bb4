#pragma once

#include <string>
#include <vector>

#include "app/run/RunBranch.h"

namespace app {

/// What a recorded run was made of, so that it can be replayed.
struct RunProvenance {
  Bundle bundle;                    // of its beginning
  std::vector<RunBranch> branches;  // by rising step
  std::vector<std::string>
      folders;          // of the runs that it continues, the first one first, and its own
  std::string version;  // of the program that made it
};

/// The provenance of the run in a folder, by its manifest and those of the runs that it continues.
/// Errors: a manifest does not contain it, or files that were read have changed since.
base::Result<RunProvenance> provenanceOf(const std::string& folder,
                                         const sim2d::ImageLoader& loader);

/// A warning when another version of the program made the folder.
base::Diagnostics otherProgramWarning(const std::string& folder);

}  // namespace app
