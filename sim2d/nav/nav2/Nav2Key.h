#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// Parameters of Nav2 as tables: each component is a plain struct with the defaults of Nav2's code
/// (not those of its bringup files), and one row per key. Who reads a file, checks one, shows a
/// form or writes a page goes over the rows.
namespace sim2d::nav2 {

/// A branch of Nav2, which determines defaults, formulas and names. In the order of their release,
/// so that `distro >= Distro::Lyrical` is Lyrical and main.
enum class Distro : std::uint8_t { Humble, Jazzy, Kilted, Lyrical, Main };
constexpr Distro kEachDistro[] = {Distro::Humble, Distro::Jazzy, Distro::Kilted, Distro::Lyrical,
                                  Distro::Main};

/// In which of them a key exists: a sum of these.
constexpr unsigned kHumble = 1, kJazzy = 2, kKilted = 4, kLyrical = 8, kMain = 16;
constexpr unsigned kSinceLyrical = kLyrical | kMain, kSinceKilted = kKilted | kSinceLyrical,
                   kSinceJazzy = kJazzy | kSinceKilted;
constexpr unsigned kUntilJazzy = kHumble | kJazzy, kUntilKilted = kUntilJazzy | kKilted;
constexpr unsigned kEveryDistro = kHumble | kSinceJazzy;

inline bool isIn(unsigned distros, Distro distro) {
  return (distros >> static_cast<unsigned>(distro) & 1U) != 0;
}

/// A key that has an effect here. ROS 2 takes a value of the very type only: 1 is no double.
template <class Parameters>
struct Nav2Key {
  using Member = std::variant<double Parameters::*, int Parameters::*, bool Parameters::*,
                              std::string Parameters::*, std::vector<double> Parameters::*,
                              std::vector<std::string> Parameters::*>;
  const char* name;  // below the component's own: "desired_linear_vel", "smoother.w_data"
  Member member;
  const char* unit;     // "m", "rad/s", "" for none
  const char* meaning;  // a sentence
  unsigned distros = kEveryDistro;
};

/// A key that is known and has no effect here, and why: "no TF here".
struct IdleKey {
  const char* name;
  const char* why;
  unsigned distros = kEveryDistro;
};

}  // namespace sim2d::nav2
