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

TreeReading readTree(const YamlNode& root, const std::string& fileName,
                     const FieldTables& tables = fieldTables());
/// The map below ros__parameters.
YamlNode loaderTree(const Scenario& scenario, const FieldTables& tables = fieldTables());
/// Null when the block would hold nothing but its format.
YamlNode blockTree(const Scenario& scenario, const FieldTables& tables = fieldTables());
YamlNode fileTree(const Scenario& scenario, const FieldTables& tables = fieldTables());
Scenario withoutDefaults(Scenario scenario, const FieldTables& tables);
base::Diagnostics setValue(Scenario& scenario, const std::string& path, const std::string& value,
                           const FieldTables& tables);

/// Reads the parameters of our block into `reading.scenario`.
void readBlock(const YamlNode& parameters, LoaderReading& reading);

const std::vector<std::string>& routeWords();

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

/// The keys of one thing, those that we do not know last; null when there are none.
template <class T>
YamlNode fieldTree(const T& of, const FieldTables& tables) {
  YamlNode tree;
  writeFields(tree, of, tables);
  setUnknown(tree, of.unknown);
  return tree;
}

}  // namespace sim2d
