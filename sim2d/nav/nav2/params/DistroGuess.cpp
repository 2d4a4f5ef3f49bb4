#include "sim2d/nav/nav2/params/DistroGuess.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace sim2d::nav2 {
namespace {

/// What a file says only for some branches.
struct Sign {
  std::string_view node, key;  // empty node: any; a key that begins with '.' ends the name
  unsigned distros;
  std::string_view what;
};
constexpr std::array<Sign, 22> kSigns = {{
    {"controller_server", "progress_checker_plugin", kHumble, "key progress_checker_plugin"},
    {"controller_server", "progress_checker_plugins", kSinceJazzy, "key progress_checker_plugins"},
    {"controller_server", "path_handler_plugins", kMain, "key path_handler_plugins"},
    {"controller_server", "costmap_update_timeout", kSinceJazzy, "key costmap_update_timeout"},
    {"planner_server", "costmap_update_timeout", kSinceJazzy, "key costmap_update_timeout"},
    {"planner_server", "allow_partial_planning", kMain, "key allow_partial_planning"},
    {"bt_navigator", "navigators", kSinceJazzy, "key navigators"},
    {"bt_navigator", "error_code_names", kJazzy, "key error_code_names"},
    {"bt_navigator", "error_code_name_prefixes", kMain, "key error_code_name_prefixes"},
    {"bt_navigator", "bt_search_directories", kMain, "key bt_search_directories"},
    {"behavior_server", "costmap_topic", kHumble, "key costmap_topic"},
    {"behavior_server", "local_costmap_topic", kSinceJazzy, "key local_costmap_topic"},
    {"recoveries_server", "", kHumble, "node recoveries_server"},
    {"docking_server", "", kSinceJazzy, "node docking_server"},
    {"route_server", "", kMain, "node route_server"},
    {"collision_monitor", ".max_points", kHumble, "key max_points"},
    {"", ".reset_period", kHumble, "key reset_period"},
    {"", ".ax_max", kSinceJazzy, "key ax_max"},
    {"", ".near_collision_cost", kSinceJazzy, "key near_collision_cost"},
    {"", ".motion_target_dist", kHumble, "key motion_target_dist"},
    {"", ".use_fixed_curvature_lookahead", kSinceJazzy, "key use_fixed_curvature_lookahead"},
    {"", ".use_dynamic_window", kMain, "key use_dynamic_window"},
}};

bool matches(const Sign& sign, const NodeParameters& node, const GivenParameter& given) {
  if (!sign.node.empty() && sign.node != node.node) {
    return false;
  }
  if (sign.key.empty() || sign.key.front() != '.') {
    return given.name == sign.key;
  }
  return given.name.size() > sign.key.size() &&
         given.name.compare(given.name.size() - sign.key.size(), sign.key.size(), sign.key) == 0;
}

class Scores {
 public:
  void add(unsigned distros, int weight, int line, std::string_view what) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      points_[i] += isIn(distros, static_cast<Distro>(i)) ? weight : -weight;
    }
    reasons_.push_back(
        {distros,
         (line > 0 ? "line " + std::to_string(line) + ": " : std::string()) + std::string(what)});
  }
  DistroGuess guess() const {
    DistroGuess best;
    for (const Distro distro : {Distro::Humble, Distro::Main}) {
      if (points_[static_cast<std::size_t>(distro)] >
          points_[static_cast<std::size_t>(best.distro)]) {
        best.distro = distro;
      }
    }
    for (const Reason& reason : reasons_) {
      if (isIn(reason.distros, best.distro)) {  // the others speak against it
        best.reasons.push_back(reason.words);
      }
    }
    return best;
  }

 private:
  struct Reason {
    unsigned distros;
    std::string words;
  };
  std::array<int, 3> points_ = {};
  std::vector<Reason> reasons_;
};

/// Servers load plugins by names with '/' in Humble and '::' since. Costmap layers and controllers
/// were always written with '::'.
bool loadsBySlash(const std::string& node) {
  return node == "planner_server" || node == "behavior_server";
}

void lookAtPlugin(const NodeParameters& node, const GivenParameter& given, bool& isTold,
                  Scores& scores) {
  constexpr std::string_view kEnd = ".plugin";
  const bool isPlugin = given.name.size() > kEnd.size() &&
                        given.name.compare(given.name.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
  if (isTold || !isPlugin || !loadsBySlash(node.node)) {
    return;
  }
  const bool hasSlash = given.value->text.find('/') != std::string::npos;
  scores.add(hasSlash ? kHumble : kSinceJazzy, 2, given.value->line,
             hasSlash ? "plugin names with '/'" : "plugin names with '::'");
  isTold = true;
}

}  // namespace

const char* distroName(Distro distro) {
  static constexpr const char* kNames[] = {"humble", "jazzy", "main"};
  return kNames[static_cast<std::size_t>(distro)];
}

std::optional<Distro> distroNamed(const std::string& word) {
  for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
    if (word == distroName(distro)) {
      return distro;
    }
  }
  return std::nullopt;
}

DistroGuess guessDistro(const ParameterFile& file) {
  Scores scores;
  std::array<bool, kSigns.size()> isSeen = {};
  bool isPluginTold = false;
  for (const NodeParameters& node : file.nodes()) {
    for (std::size_t i = 0; i < kSigns.size(); ++i) {
      const Sign& sign = kSigns[i];
      if (!isSeen[i] && !sign.node.empty() && sign.key.empty() && sign.node == node.node) {
        isSeen[i] = true;
        scores.add(sign.distros, 1, node.line, sign.what);
      }
    }
    for (const GivenParameter& given : node.given) {
      lookAtPlugin(node, given, isPluginTold, scores);
      for (std::size_t i = 0; i < kSigns.size(); ++i) {
        if (!isSeen[i] && !kSigns[i].key.empty() && matches(kSigns[i], node, given)) {
          isSeen[i] = true;
          scores.add(kSigns[i].distros, 1, given.value->line, kSigns[i].what);
        }
      }
    }
  }
  return scores.guess();
}

}  // namespace sim2d::nav2
