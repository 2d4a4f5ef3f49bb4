#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/Result.h"

namespace capsule {

/// An input file that a study recorded, and where it is now.
struct SourceInput {
  app::InputHash recorded;
  std::string path;     // absolute
  std::string content;  // used instead of the file if it is not empty
  bool isCode = false;  // a program or library that runs start
};

/// The folder of a batch or of a single run, checked and ready to be packed.
struct StudySource {
  std::string folder;
  bool isBatch = true;
  std::string version, commit;  // of the program that made it
  std::size_t runs = 1, finished = 1;
  bool allowsCode = false;
  std::vector<SourceInput> inputs;  // the experiment or the scenario first
  std::vector<std::string> files;   // of the folder, relative names, sorted
};

/// Reads the folder. All problems are reported. Errors: not a finished run or a batch, in use,
/// files of it or inputs that have changed, a run that continues another one.
base::Result<StudySource> readStudySource(const std::string& folder);

}  // namespace capsule
