#include <algorithm>

#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

const std::vector<std::string>& kindWords() {
  static const std::vector<std::string> kWords = {"adult", "child", "elderly", "wheelchair",
                                                  "luggage"};
  return kWords;
}

const std::vector<std::string>& atEndWords() {
  static const std::vector<std::string> kWords = {"stop", "leave", "restart"};
  return kWords;
}

const std::vector<std::string>& obstacleKindWords() {
  static const std::vector<std::string> kWords = {"box", "circle", "polygon", "wall"};
  return kWords;
}

const std::vector<std::string>& areaKindWords() {
  static const std::vector<std::string> kWords = {"source", "sink", "wait", "exit"};
  return kWords;
}

const std::vector<std::string>& obstaclePointWords() {
  static const std::vector<std::string> kWords = {"boundary", "rays"};
  return kWords;
}

const std::vector<std::string>& mapRuleWords() {
  static const std::vector<std::string> kWords = {"humble", "main"};
  return kWords;
}

const std::set<std::string>& loaderKeys() {
  static const std::set<std::string> kKeys = {"yaml_base_name", "simulator",    "map",
                                              "publish_people", "global_goals", "agents"};
  return kKeys;
}

const std::set<std::string>& blockKeys() {
  // "map": a menu of HuNavSim searches the whole text for that key
  static const std::set<std::string> kKeys = {
      "format", "map",    "map_file",   "map_rule", "seed",   "duration",        "dt",
      "model",  "route",  "loop_trees", "wrap_x",   "areas",  "obstacle_points", "record_every",
      "groups", "robots", "obstacles",  "doors",    "metrics"};
  return kKeys;
}

bool isEntityName(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace sim2d
