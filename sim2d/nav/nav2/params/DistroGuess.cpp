#include "sim2d/nav/nav2/params/DistroGuess.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"

namespace sim2d::nav2 {
namespace {

/// Nodes that not all branches have.
struct NodeSign {
  std::string_view node;
  unsigned distros;
};
constexpr std::array<NodeSign, 4> kNodeSigns = {{{"recoveries_server", kHumble},
                                                 {"docking_server", kSinceJazzy},
                                                 {"loopback_simulator", kSinceJazzy},
                                                 {"following_server", kSinceLyrical}}};

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
    for (const Distro distro : {Distro::Humble, Distro::Kilted, Distro::Lyrical}) {
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
  std::array<int, std::size(kEachDistro)> points_ = {};
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

/// Branches that read each key of the file, by its place; keys that all or none of them read are
/// no evidence.
std::map<std::pair<int, std::string>, unsigned> readersOf(const ParameterFile& file) {
  std::map<std::pair<int, std::string>, unsigned> readers;
  for (const Distro distro : kEachDistro) {
    Nav2ReadOptions options;
    options.distro = distro;
    options.onlyKeys = true;
    for (const KeyNote& key : readNav2Parameters(file, options).parameters.notes.keys) {
      const bool isRead = key.use == KeyUse::Used || key.use == KeyUse::Idle;
      readers[{key.line, key.path}] |= isRead ? 1U << static_cast<unsigned>(distro) : 0U;
    }
  }
  return readers;
}

void addKeys(const ParameterFile& file, Scores& scores) {
  std::set<std::pair<std::string, unsigned>> seen;  // a key of several plugins counts only once
  for (const auto& [place, distros] : readersOf(file)) {
    const auto& [line, path] = place;
    const std::string key = path.substr(path.rfind('.') + 1);
    if (distros != 0 && distros != kEveryDistro && seen.emplace(key, distros).second) {
      scores.add(distros, 1, line, "key " + key);
    }
  }
}

}  // namespace

const char* distroName(Distro distro) {
  static constexpr const char* kNames[] = {"humble", "jazzy", "kilted", "lyrical", "main"};
  return kNames[static_cast<std::size_t>(distro)];
}

const char* distroTitle(Distro distro) {
  static constexpr const char* kTitles[] = {"Humble", "Jazzy", "Kilted", "Lyrical", "main"};
  return kTitles[static_cast<std::size_t>(distro)];
}

std::string distroTitles(unsigned distros) {
  std::vector<std::string> titles;
  for (const Distro distro : kEachDistro) {
    if (isIn(distros, distro)) {
      titles.emplace_back(distroTitle(distro));
    }
  }
  if (titles.size() < 2) {
    return base::join(titles, "");
  }
  const std::string last = titles.back();
  titles.pop_back();
  return base::join(titles, ", ") + " and " + last;
}

std::optional<Distro> distroNamed(const std::string& word) {
  for (const Distro distro : kEachDistro) {
    if (word == distroName(distro)) {
      return distro;
    }
  }
  return std::nullopt;
}

DistroGuess guessDistro(const ParameterFile& file) {
  Scores scores;
  bool isPluginTold = false;
  std::set<std::string> seen;  // a node of two namespaces counts once
  for (const NodeParameters& node : file.nodes()) {
    const bool isNew = seen.insert(node.node).second;
    for (const NodeSign& sign : kNodeSigns) {
      if (isNew && sign.node == node.node) {
        scores.add(sign.distros, 1, node.line, "node " + node.node);
      }
    }
    for (const GivenParameter& given : node.given) {
      lookAtPlugin(node, given, isPluginTold, scores);
    }
  }
  addKeys(file, scores);
  return scores.guess();
}

}  // namespace sim2d::nav2
