#pragma once

#include <set>
#include <string>

#include "sim2d/base/yaml/YamlMap.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/AgentReader.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioFile.h"

/// A scenario to and from the tree of its file. Private to this folder.
namespace sim2d {

using base::scalarNode;
using base::stringNode;

constexpr const char* kLoaderNode = "hunav_loader";
constexpr const char* kBlockNode = "hunavsim_desktop";
constexpr const char* kParameters = "ros__parameters";
constexpr int kBlockFormat = 1;

struct TreeReading {
  Scenario scenario;
  ReadReport report;
  Dialect dialect = Dialect::C;
  std::set<std::string> loaderPaths, blockPaths;  // keys that exist, below ros__parameters
};

TreeReading readTree(const YamlNode& root, const std::string& fileName);
YamlNode loaderTree(const Scenario& scenario);  // the map below ros__parameters
/// Null when the block would hold nothing but its format.
YamlNode blockTree(const Scenario& scenario);
YamlNode fileTree(const Scenario& scenario);

/// Reads the parameters of our block into `reading.scenario`.
void readBlock(const YamlNode& parameters, LoaderReading& reading);

/// Value of a known key out of a list of words: index = enumerator.
const std::vector<std::string>& kindWords();
const std::vector<std::string>& routeWords();
const std::vector<std::string>& atEndWords();
const std::vector<std::string>& obstacleKindWords();
const std::vector<std::string>& areaKindWords();
const std::vector<std::string>& obstaclePointWords();
const std::vector<std::string>& mapRuleWords();

/// Keys of each node: names that are taken.
const std::set<std::string>& loaderKeys();
const std::set<std::string>& blockKeys();
/// A name that robots, obstacles, doors and areas may have.
bool isEntityName(const std::string& name);

// Nodes for the writer.
YamlNode decimals(double value, int digits = 1);
YamlNode number(long long value);
YamlNode flag(bool value);
YamlNode decimalList(const std::vector<double>& values);
void setChild(YamlNode& map, const std::string& key, YamlNode value);
YamlNode integerList(const std::vector<int>& values);
void setPoint(YamlNode& map, const Vec2& point);  // x, y
void setUnknown(YamlNode& map, const UnknownKeys& unknown);

Vec2 readPoint(YamlMap& view);  // x, y
/// Maps inside an entity that have no place for keys of others.
void refuseUnknown(YamlMap& view);

}  // namespace sim2d
