#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

const char* distroName(Distro distro);       // "humble", "jazzy", "kilted", "lyrical", "main"
const char* distroTitle(Distro distro);      // "Humble", …, "main": for display
std::string distroTitles(unsigned distros);  // "Kilted, Lyrical and main"
std::optional<Distro> distroNamed(const std::string& word);

struct DistroGuess {
  Distro distro = Distro::Jazzy;
  std::vector<std::string> reasons;  // "line 12: plugin names with '/'"; empty: no evidence
};
/// The branch that a file was written for, by differences between the branches: keys, nodes,
/// spellings of plugins. Without evidence it is Jazzy; of branches with the same evidence it is the
/// one that was released first, and never main.
DistroGuess guessDistro(const ParameterFile& file);

}  // namespace sim2d::nav2
