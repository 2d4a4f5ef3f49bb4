#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

const std::vector<std::string>& kindWords() {
  static const std::vector<std::string> kWords = {"adult", "child", "elderly", "wheelchair",
                                                  "luggage"};
  return kWords;
}

const std::vector<std::string>& routeWords() {
  static const std::vector<std::string> kWords = {"planned", "direct"};
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

}  // namespace sim2d
