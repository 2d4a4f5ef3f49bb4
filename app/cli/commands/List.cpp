#include <algorithm>
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
#include "app/cli/ScenarioList.h"
#include "app/cli/help/CommandPages.h"
#include "app/cli/help/ReferencePages.h"
#include "app/run/Nav2Robots.h"
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

std::vector<Entry> problemEntries() {
  std::vector<Entry> entries;
  for (const base::ProblemText& problem : base::problemTexts()) {
    const std::string text(problem.text);
    entries.push_back({std::string(problem.id),
                       {text},
                       {{"text", text}, {"substitution", problem.isSubstitution}}});
  }
  return entries;
}

std::vector<Entry> commandEntries(const CommandTable& table) {
  std::vector<Entry> entries;
  for (const CommandInfo& command : table) {
    Json options = Json::array();
    for (const OptionInfo& option : command.options) {
      options.push_back({{"names", option.names},
                         {"value", option.value},
                         {"choices", option.choices},
                         {"group", option.group},
                         {"required", option.isRequired},
                         {"description", option.help}});
    }
    Json examples = Json::array();
    for (const CommandExample& example : command.examples) {
      examples.push_back(
          {{"line", example.line}, {"purpose", example.purpose}, {"needs", example.needs}});
    }
    entries.push_back({command.name.empty() ? "hunavsim" : command.name,
                       {command.help},
                       {{"description", command.help},
                        {"group", command.group},
                        {"usage", command.usage()},
                        {"options", options},
                        {"examples", examples}}});
  }
  return entries;
}

std::vector<Entry> scenarioEntries() {
  std::vector<Entry> entries;
  for (ListedScenario& scenario : listedScenarios()) {
    entries.push_back(
        {std::move(scenario.name), std::move(scenario.columns), std::move(scenario.details)});
  }
  return entries;
}

/// The lists by their names on the command line.
std::map<std::string, std::function<std::vector<Entry>()>> lists(const CommandRegistry& commands) {
  return {{"commands", [&commands] { return commandEntries(commands.table()); }},
          {"problems", problemEntries},
          {"nodes", nodeEntries},
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

/// The lists that have a Markdown page, by their names on the command line.
std::map<std::string, std::function<std::string()>> pages() {
  return {{"metrics", [] { return metrics::metricsMarkdown(); }},
          {"keys", [] { return sim2d::keysMarkdown(); }},
          {"planners", plannersMarkdown},
          {"models", modelsMarkdown},
          {"robots", robotsMarkdown},
          {"nodes", nodesMarkdown},
          {"problems", problemsMarkdown},
          {"scenarios", scenariosPage}};
}

/// The command line in the formats that `list commands` writes besides text and JSON.
std::map<std::string, std::string (*)(const CommandTable&)> commandPages() {
  return {{"markdown", commandsMarkdown},
          {"man", manPage},
          {"bash", bashCompletion},
          {"zsh", zshCompletion},
          {"fish", fishCompletion}};
}

/// The page of a list in a format that is neither text nor JSON. Error: it has none.
base::Result<std::string> pageOf(const ListOptions& options, const CommandRegistry& commands) {
  if (options.format == "xml" && options.what == "nodes") {
    bt::NodeCatalogue all;
    for (const auto& each : allNodes()) {
      all.add(each.first);
    }
    return bt::writeModel(all);
  }
  const auto ofCommands = commandPages();
  const auto commandPage = ofCommands.find(options.format);
  if (options.what == "commands" && commandPage != ofCommands.end()) {
    return commandPage->second(commands.table());
  }
  const auto all = pages();
  const auto page = all.find(options.what);
  if (options.format == "markdown" && page != all.end()) {
    return page->second();
  }
  const std::string known = options.format == "xml"        ? "nodes"
                            : options.format == "markdown" ? base::join(namesOf(all), ", ")
                                                           : "commands";
  return base::error("list.format", {options.format, known});
}

int listCommand(const ListOptions& options, const Invocation& given,
                const CommandRegistry& commands) {
  const bool isPlain = options.format == "text" || options.format == "json";
  if (given.json && !isPlain) {
    requireFine({base::error("list.json-or-format", {options.format})}, ExitWrongCommandLine);
  }
  if (!isPlain) {
    const base::Result<std::string> page = pageOf(options, commands);
    requireFine(page.diagnostics(), ExitWrongCommandLine);
    print(*page);
    return ExitFine;
  }
  const std::vector<Entry> entries = lists(commands).at(options.what)();
  given.json || options.format == "json" ? printJson(entries) : printText(entries);
  return ExitFine;
}

}  // namespace

void addList(CommandRegistry& commands) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App& command = commands.add("list", "List available scenarios, metrics, nodes, …",
                                   [options, &commands](const Invocation& given) {
                                     options->format =
                                         options->format == "md" ? "markdown" : options->format;
                                     return listCommand(*options, given, commands);
                                   });
  const std::vector<std::string> names = namesOf(lists(commands));
  command.add_option("what", options->what, base::join(names, ", "))
      ->required()
      ->check(oneOf(names));
  command
      .add_option("--format", options->format,
                  "Output format: text or json; xml for nodes; markdown (md) for " +
                      base::join(namesOf(pages()), ", ") +
                      "; markdown, man, bash, zsh or fish for commands (default: text)")
      ->check(oneOf({"text", "json", "xml", "markdown", "md", "man", "bash", "zsh", "fish"}));
  commands.addExamples(command, {{"hunavsim list scenarios", "Show the shipped scenarios"},
                                 {"hunavsim list planners", "Show the planners of robots"},
                                 {"hunavsim list metrics --json", "Describe all metrics as JSON"}});
}

}  // namespace app
