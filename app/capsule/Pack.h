#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace capsule {

struct PackOptions {
  std::string study;          // folder of a batch or of a single run
  std::string output;         // file to write
  bool withCode = false;      // programs and libraries that runs start are packed too
  sim2d::ImageLoader loader;  // for map images other than PGM
};

/// A written capsule.
struct PackedStudy {
  std::string identity;    // SHA-256 of SHA256SUMS: that of all content
  std::uint64_t size = 0;  // [B]
  std::size_t members = 0;
  std::size_t runs = 1;
  std::vector<std::string> omittedCode;  // paths as recorded
};

/// Writes a study as one file. The file is unpacked for a test before it gets its name: all inputs
/// must be found in it. All problems are reported. Errors: those of readStudySource(), inputs that
/// an unpacked study would read from elsewhere, for example by absolute paths.
base::Result<PackedStudy> packStudy(const PackOptions& options);

}  // namespace capsule
