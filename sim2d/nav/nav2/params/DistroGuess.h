#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

const char* distroName(Distro distro);  // "humble", "jazzy", "main"
std::optional<Distro> distroNamed(const std::string& word);

struct DistroGuess {
  Distro distro = Distro::Jazzy;
  std::vector<std::string> reasons;  // "line 12: plugin names with '/' (Humble)"; empty: none told
};
/// For which branch a file was written, by what only one of them has: spellings of plugins, keys
/// that came or went. Nothing that tells: Jazzy.
DistroGuess guessDistro(const ParameterFile& file);

}  // namespace sim2d::nav2
