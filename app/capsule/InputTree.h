#pragma once

#include <optional>
#include <string>
#include <vector>

namespace capsule {

/// Absolute path of an input that a study recorded as `named`: the file with this hash at that path
/// relative to the working folder, to the folder of the study or to its parent. nullopt: none.
std::optional<std::string> locateInput(const std::string& named, const std::string& studyFolder,
                                       const std::string& sha256);

/// Names of members for input files (absolute paths), so that relative references between them and
/// names of shipped scenarios and resources keep their meaning: shipped data below
/// inputs/shared/maps and inputs/shared/resources, other files below inputs/files as they lie below
/// their deepest common folder.
std::vector<std::string> inputMembers(const std::vector<std::string>& paths);

}  // namespace capsule
