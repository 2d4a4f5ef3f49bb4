#include "sim2d/nav/nav2/params/DistroGuess.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"

namespace sim2d::nav2 {
namespace {

/// A ROS node that only some branches have.
struct NodeEvidence {
  std::string_view node;
  unsigned distros;
};
constexpr std::array<NodeEvidence, 4> kNodeEvidence = {
    {{"recoveries_server", kHumble},
     {"docking_server", kSinceJazzy},
     {"loopback_simulator", kSinceJazzy},
     {"following_server", kJazzy | kSinceLyrical}}};

class DistroScores {
 public:
  void add(unsigned distros, int weight, int line, std::string_view what) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      points_[i] += includesDistro(distros, static_cast<Distro>(i)) ? weight : -weight;
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
      if (includesDistro(reason.distros,
                         best.distro)) {  // the other reasons are evidence against it
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
  std::array<int, std::size(kDistros)> points_ = {};
  std::vector<Reason> reasons_;
};

/// Humble's servers load plugins by names with '/', later branches with '::'. Costmap layers and
/// controllers always use '::'.
bool usesSlashPluginNames(const std::string& node) {
  return node == "planner_server" || node == "behavior_server";
}

void scorePluginSpelling(const NodeParameters& node, const GivenParameter& given, bool& isScored,
                         DistroScores& scores) {
  constexpr std::string_view kEnd = ".plugin";
  const bool isPlugin = given.name.size() > kEnd.size() && base::endsWith(given.name, kEnd);
  if (isScored || !isPlugin || !usesSlashPluginNames(node.node)) {
    return;
  }
  const bool hasSlash = given.value->text.find('/') != std::string::npos;
  scores.add(hasSlash ? kHumble : kSinceJazzy, 2, given.value->line,
             hasSlash ? "plugin names with '/'" : "plugin names with '::'");
  isScored = true;
}

/// Names of the parameters in the file, without their nodes.
std::set<std::string> namesIn(const ParameterFile& file) {
  std::set<std::string> names;
  for (const NodeParameters& node : file.nodes()) {
    for (const GivenParameter& given : node.given) {
      names.insert(given.name);
    }
  }
  return names;
}

/// The branches that read each key of the file, by line and path of the key. Keys that all or no
/// branches read are no evidence, nor are those that the replacement of a plugin supplies.
std::map<std::pair<int, std::string>, unsigned> distrosPerKey(const ParameterFile& file) {
  const std::set<std::string> written = namesIn(file);
  std::map<std::pair<int, std::string>, unsigned> readers;
  for (const Distro distro : kDistros) {
    Nav2ReadOptions options;
    options.distro = distro;
    options.onlyKeys = true;
    for (const KeyUsage& key : readNav2Parameters(file, options).parameters.notes.keys) {
      if (written.count(key.path.substr(key.path.find('.') + 1)) == 0) {
        continue;
      }
      const bool isRead = key.use == KeyUse::Used || key.use == KeyUse::Ignored;
      readers[{key.line, key.path}] |= isRead ? 1U << static_cast<unsigned>(distro) : 0U;
    }
  }
  return readers;
}

void scoreKeys(const ParameterFile& file, DistroScores& scores) {
  std::set<std::pair<std::string, unsigned>> seen;  // a key of several plugins counts once
  for (const auto& [place, distros] : distrosPerKey(file)) {
    const auto& [line, path] = place;
    const std::string key = path.substr(path.rfind('.') + 1);
    if (distros != 0 && distros != kAllDistros && seen.emplace(key, distros).second) {
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
  for (const Distro distro : kDistros) {
    if (includesDistro(distros, distro)) {
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

std::optional<Distro> distroFromName(const std::string& word) {
  for (const Distro distro : kDistros) {
    if (word == distroName(distro)) {
      return distro;
    }
  }
  return std::nullopt;
}

namespace {

DistroGuess scoredGuess(const ParameterFile& file) {
  DistroScores scores;
  bool isPluginScored = false;
  std::set<std::string> seen;  // a node in two namespaces counts once
  for (const NodeParameters& node : file.nodes()) {
    const bool isNew = seen.insert(node.node).second;
    for (const NodeEvidence& evidence : kNodeEvidence) {
      if (isNew && evidence.node == node.node) {
        scores.add(evidence.distros, 1, node.line, "node " + node.node);
      }
    }
    for (const GivenParameter& given : node.given) {
      scorePluginSpelling(node, given, isPluginScored, scores);
    }
  }
  scoreKeys(file, scores);
  return scores.guess();
}

}  // namespace

DistroGuess guessDistro(const ParameterFile& file) {
  // Five readings of the file, which a batch repeats in each run.
  constexpr std::size_t kKept = 16;
  thread_local std::map<std::vector<std::shared_ptr<const base::YamlNode>>, DistroGuess> guesses;
  if (const auto found = guesses.find(file.trees()); found != guesses.end()) {
    return found->second;
  }
  if (guesses.size() >= kKept) {
    guesses.clear();
  }
  return guesses.emplace(file.trees(), scoredGuess(file)).first->second;
}

}  // namespace sim2d::nav2
