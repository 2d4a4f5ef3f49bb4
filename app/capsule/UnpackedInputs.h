#pragma once

#include <string>

#include "app/capsule/CapsuleManifest.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace capsule {

/// Reads the scenarios of an unpacked study with their maps, trees and parameters, without running
/// them. Errors: they cannot be read, or files are read that are not inputs of the capsule. `file`:
/// its name. A study that is a single run has to be relocated first.
base::Diagnostics checkUnpackedInputs(const CapsuleManifest& manifest, const std::string& root,
                                      const std::string& file, const sim2d::ImageLoader& loader);

/// The options of an unpacked single run, which has been relocated.
base::Result<app::RunSpec> specOfUnpackedRun(const CapsuleManifest& manifest,
                                             const std::string& root);

}  // namespace capsule
