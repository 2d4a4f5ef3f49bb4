#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace sim2d::nav2 {

const char* distroName(Distro distro);       // "humble", "jazzy", "kilted", "lyrical", "main"
const char* distroTitle(Distro distro);      // "Humble", …, "main": for display
std::string distroTitles(unsigned distros);  // "Kilted, Lyrical and main"
std::optional<Distro> distroFromName(const std::string& word);

struct DistroGuess {
  Distro distro = Distro::Jazzy;
  std::vector<std::string> reasons;  // "line 12: plugin names with '/'"; empty: no evidence
};
/// Guesses the branch that a file was written for from keys, nodes and spellings of plugins that
/// differ between the branches. Without evidence it is Jazzy; among branches with the same evidence
/// it is the one that was released first, and never main.
DistroGuess guessDistro(const ParameterFile& file);

}  // namespace sim2d::nav2
