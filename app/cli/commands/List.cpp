#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/DataPaths.h"
#include "app/run/Nav2Robots.h"
#include "bt/human/TreeLoader.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeXml.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/world/Registries.h"

namespace app {

namespace {

struct ListOptions {
  std::string what;             // nodes, metrics, models, robots, planners, keys, scenarios
  std::string format = "text";  // text, json; xml for nodes, markdown for some
};

using Json = nlohmann::ordered_json;

/// One row of a list: name, columns and JSON details.
struct Entry {
  std::string name;
  std::vector<std::string> columns;
  Json details = Json::object();
};

/// Infinite limits become null.
Json parameterJson(const base::ParameterSpec& spec) {
  const double* const fallback = std::get_if<double>(&spec.fallback);
  const std::string* const text = std::get_if<std::string>(&spec.fallback);
  return {{"name", spec.key},
          {"type", spec.type == base::ParameterType::Text ? "text" : "number"},
          {"default", fallback != nullptr ? Json(*fallback)
                      : text != nullptr   ? Json(*text)
                                          : Json()},
          {"unit", spec.unit},
          {"minimum", spec.range.low},
          {"maximum", spec.range.high},
          {"description", spec.help},
          {"source", spec.source}};
}

Json parametersJson(const std::vector<base::ParameterSpec>& specs) {
  Json json = Json::array();
  std::transform(specs.begin(), specs.end(), std::back_inserter(json), parameterJson);
  return json;
}

template <class Maker>
std::vector<Entry> registeredEntries(const base::Registry<Maker>& registry) {
  std::vector<Entry> entries;
  for (const auto& each : registry.entries()) {
    entries.push_back(
        {each.name,
         {},
         {{"description", each.help}, {"parameters", parametersJson(each.parameters)}}});
    if (!each.help.empty()) {
      entries.back().columns = {each.help};
    }
  }
  return entries;
}

/// "r 0.35 m" for a disc, otherwise "0.51 x 0.43 m".
std::string robotSizeText(const sim2d::Footprint& footprint) {
  if (footprint.isDisc()) {
    return "r " + base::formatDouble(footprint.radius) + " m";
  }
  base::Vec2 low = footprint.corners.front();
  base::Vec2 high = low;
  for (const base::Vec2& corner : footprint.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const auto centimetres = [](double length) { return std::round(100.0 * length) / 100.0; };
  return base::formatDouble(centimetres(high.x() - low.x())) + " x " +
         base::formatDouble(centimetres(high.y() - low.y())) + " m";
}

Json cornersJson(const sim2d::Footprint& footprint) {
  Json corners = Json::array();
  for (const base::Vec2& corner : footprint.corners) {
    corners.push_back({corner.x(), corner.y()});
  }
  return corners;
}

/// By the keys of a scenario; null without a lidar.
Json lidarJson(const sim2d::RobotType& type) {
  if (!type.lidar) {
    return {};
  }
  const sim2d::LidarParameters lidar = sim2d::robotOfType(type.name).lidar;
  return {{"beams", lidar.beams},
          {"range", lidar.range},
          {"rate", lidar.rate},
          {"angle_min", lidar.angleMin},
          {"angle_max", lidar.angleMax},
          {"x", lidar.mount.position.x()},
          {"y", lidar.mount.position.y()},
          {"noise", lidar.noise}};
}

std::vector<Entry> robotEntries() {
  std::vector<Entry> entries;
  for (const sim2d::RobotType& type : sim2d::robotTypes()) {
    const sim2d::DriveLimits& limits = type.body.limits;
    const char* const kinematics = sim2d::kinematicsName(type.body.kinematics);
    entries.push_back({type.name,
                       {kinematics, robotSizeText(type.body.footprint),
                        base::formatDouble(limits.maxVel) + " m/s", type.title},
                       {{"title", type.title},
                        {"kinematics", kinematics},
                        {"radius", sim2d::circumscribedRadius(type.body.footprint)},
                        {"footprint", cornersJson(type.body.footprint)},
                        {"height", type.height},
                        {"mass", type.body.mass},
                        {"max_vel", limits.maxVel},
                        {"max_reverse", limits.maxReverse},
                        {"max_acc", limits.maxAcc},
                        {"max_omega", limits.maxOmega},
                        {"max_alpha", limits.maxAlpha},
                        {"turning_radius", limits.turningRadius},
                        {"lidar", lidarJson(type)},
                        {"source", type.source}}});
  }
  return entries;
}

Json portJson(const bt::PortSpec& port) {
  return {{"name", port.key},
          {"direction", bt::portDirectionTag(port.direction)},
          {"type", bt::portTypeName(port.portType)},
          {"required", port.required},
          {"default", port.fallbackText() ? Json(*port.fallbackText()) : Json()},
          {"unit", port.unit},
          {"minimum", port.range.low},
          {"maximum", port.range.high},
          {"description", port.help}};
}

/// Nodes of agents' trees, then those that only navigator trees of robots may use.
std::vector<std::pair<bt::NodeManifest, const char*>> allNodes() {
  const bt::NodeLibrary people = bt::humanNodes();
  const bt::NodeLibrary robots = bt::robotNodes();
  std::vector<std::pair<bt::NodeManifest, const char*>> all;
  for (const bt::NodeManifest& node : people.catalogue().all()) {
    all.emplace_back(node, robots.catalogue().find(node.id) == nullptr ? "people" : "both");
  }
  for (const bt::NodeManifest& node : robots.catalogue().all()) {
    if (people.catalogue().find(node.id) == nullptr) {
      all.emplace_back(node, "robots");
    }
  }
  return all;
}

std::vector<Entry> nodeEntries() {
  std::vector<Entry> entries;
  for (const auto& [node, whose] : allNodes()) {
    std::vector<std::string> names;
    Json ports = Json::array();
    for (const bt::PortSpec& port : node.ports) {
      names.push_back(port.key);
      ports.push_back(portJson(port));
    }
    entries.push_back({node.id,
                       {whose, bt::nodeKindName(node.kind), base::join(names, ", ")},
                       {{"kind", bt::nodeKindName(node.kind)},
                        {"for", whose},
                        {"category", node.category},
                        {"origin", bt::nodeOriginName(node.origin)},
                        {"description", node.description},
                        {"ports", ports}}});
  }
  return entries;
}

std::vector<Entry> metricEntries() {
  std::vector<Entry> entries;
  const metrics::MetricRegistry& registry = metrics::standardRegistry();
  for (const metrics::MetricEntry& metric : registry.entries()) {
    const metrics::MetricInfo& info = metric.info;
    const char* const better = metrics::betterName(info.better);
    entries.push_back({info.key,
                       {info.unit.empty() ? "-" : info.unit, info.range, better, info.source},
                       {{"unit", info.unit},
                        {"category", metrics::categoryName(info.category)},
                        {"range", info.range},
                        {"better", better},
                        {"formula", info.formula},
                        {"source", info.source},
                        {"hunav_number", info.hunav},
                        {"parameters", parametersJson(registry.parametersOf(info))}}});
  }
  return entries;
}

std::vector<Entry> keyEntries() {
  std::vector<Entry> entries;
  for (const sim2d::KeyTable& table : sim2d::keyTables()) {
    for (const sim2d::KeyRow& row : table.rows) {
      const auto shown = [](const std::string& text) { return text.empty() ? "-" : text; };
      entries.push_back({table.path + row.key,
                         {row.values, shown(row.unit), shown(row.fallback)},
                         {{"of", table.title},
                          {"values", row.values},
                          {"unit", row.unit},
                          {"default", row.fallback},
                          {"description", row.help}}});
    }
  }
  return entries;
}

std::vector<Entry> scenarioEntries() {
  std::vector<Entry> entries;
  for (const ShippedScenario& scenario : shippedScenarios()) {
    entries.push_back({scenario.name, {scenario.path}, {{"path", scenario.path}}});
  }
  return entries;
}

/// The lists by their names on the command line.
std::map<std::string, std::function<std::vector<Entry>()>> lists() {
  return {{"nodes", nodeEntries},
          {"metrics", metricEntries},
          {"keys", keyEntries},
          {"models", [] { return registeredEntries(builtinRegistries().models); }},
          {"robots", robotEntries},
          {"planners", [] { return registeredEntries(builtinRegistries().planners); }},
          {"scenarios", scenarioEntries}};
}

template <class Value>
std::vector<std::string> namesOf(const std::map<std::string, Value>& things) {
  std::vector<std::string> names;
  names.reserve(things.size());
  for (const auto& [name, thing] : things) {
    names.push_back(name);
  }
  return names;
}

void printText(const std::vector<Entry>& entries) {
  std::vector<std::vector<std::string>> rows;
  for (const Entry& entry : entries) {
    rows.push_back({entry.name});
    rows.back().insert(rows.back().end(), entry.columns.begin(), entry.columns.end());
  }
  printTable(rows);
}

void printJson(const std::vector<Entry>& entries) {
  Json all = Json::array();
  for (const Entry& entry : entries) {
    Json json = {{"name", entry.name}};
    json.update(entry.details);
    all.push_back(std::move(json));
  }
  print(base::jsonText(all) + "\n");
}

/// A section of a Markdown page: a planner or model with its table of parameters.
struct PageSection {
  std::string name;
  std::string help;  // a sentence or two
  std::vector<base::ParameterSpec> parameters;
};

std::string rangeText(const base::Range& range) {
  const bool hasLow = std::isfinite(range.low);
  const bool hasHigh = std::isfinite(range.high);
  if (hasLow && hasHigh) {
    return (range.excludesLow ? "above " : "") + base::formatDouble(range.low) + " to " +
           base::formatDouble(range.high);
  }
  const std::string low = (range.excludesLow ? "> " : "≥ ") + base::formatDouble(range.low);
  return hasLow ? low : hasHigh ? "≤ " + base::formatDouble(range.high) : "";
}

std::string defaultText(const base::ParameterSpec& spec) {
  const double* const number = std::get_if<double>(&spec.fallback);
  const std::string* const word = std::get_if<std::string>(&spec.fallback);
  return number != nullptr ? base::formatDouble(*number) : word != nullptr ? *word : "";
}

std::string rowText(const base::ParameterSpec& spec) {
  const std::string range =
      spec.choices.empty() ? rangeText(spec.range) : base::join(spec.choices, ", ");
  return "| `" + spec.key + "` | " + spec.unit + " | " + defaultText(spec) + " | " + range + " | " +
         spec.help + " | " + spec.source + " |\n";
}

std::string sectionText(const PageSection& section) {
  std::string text = "\n## " + section.name + "\n\n" + section.help + "\n";
  if (section.parameters.empty()) {
    return text;
  }
  text +=
      "\n| parameter | unit | default | values | meaning | source |\n|---|---|---|---|---|---|\n";
  for (const base::ParameterSpec& spec : section.parameters) {
    text += rowText(spec);
  }
  return text;
}

/// `key`: the map of a scenario that contains the parameters.
std::string parameterPage(const std::string& title, const std::string& key,
                          const std::vector<PageSection>& sections) {
  std::string text = "# " + title + "\n\nWritten by `hunavsim list " + base::toLower(title) +
                     " --format markdown`; do not edit by hand. A scenario sets the parameters in "
                     "the map `" +
                     key + "`.\n";
  for (const PageSection& section : sections) {
    text += sectionText(section);
  }
  return text;
}

template <class Maker>
std::vector<PageSection> pageSections(const base::Registry<Maker>& registry) {
  std::vector<PageSection> sections;
  sections.reserve(registry.entries().size());
  for (const auto& entry : registry.entries()) {
    sections.push_back({entry.name, entry.help, entry.parameters});
  }
  return sections;
}

std::string plannersPage() {
  return parameterPage("Planners", "planner_parameters",
                       pageSections(builtinRegistries().planners));
}

std::string modelsPage() {
  return parameterPage("Models", "model_parameters", pageSections(builtinRegistries().models));
}

/// The lists that have a Markdown page, by their names on the command line.
std::map<std::string, std::function<std::string()>> pages() {
  return {{"metrics", [] { return metrics::metricsMarkdown(); }},
          {"keys", [] { return sim2d::keysMarkdown(); }},
          {"planners", plannersPage},
          {"models", modelsPage}};
}

int listCommand(const ListOptions& options, const Invocation& given) {
  if (given.json && (options.format == "xml" || options.format == "markdown")) {
    requireFine({base::error("list.json-or-format", {options.format})}, ExitWrongCommandLine);
  }
  if (options.format == "xml") {
    if (options.what != "nodes") {
      requireFine({base::error("list.format", {options.format, "nodes"})}, ExitWrongCommandLine);
    }
    bt::NodeCatalogue all;
    for (const auto& each : allNodes()) {
      all.add(each.first);
    }
    print(bt::writeModel(all));
    return ExitFine;
  }
  if (options.format == "markdown") {
    const auto all = pages();
    const auto page = all.find(options.what);
    if (page == all.end()) {
      requireFine({base::error("list.format", {options.format, base::join(namesOf(all), ", ")})},
                  ExitWrongCommandLine);
    }
    print(page->second());
    return ExitFine;
  }
  const std::vector<Entry> entries = lists().at(options.what)();
  given.json || options.format == "json" ? printJson(entries) : printText(entries);
  return ExitFine;
}

}  // namespace

void addList(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("list", "List available scenarios, metrics, nodes, …", listCommand);
  const std::vector<std::string> names = namesOf(lists());
  command.add_option("what", options.what, base::join(names, ", "))
      ->required()
      ->check(oneOf(names));
  command
      .add_option("--format", options.format,
                  "Output format: text or json; xml for nodes, markdown for " +
                      base::join(namesOf(pages()), ", "))
      ->check(oneOf({"text", "json", "xml", "markdown"}));
}

}  // namespace app
