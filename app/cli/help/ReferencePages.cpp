#include "app/cli/help/ReferencePages.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "app/run/Nav2Robots.h"
#include "bt/human/TreeLoader.h"
#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/RobotTypes.h"

namespace app {

std::string markdownCell(const std::string& text) {
  std::string shown;
  for (const char byte : text) {
    shown += byte == '|' ? "\\|" : byte == '<' ? "&lt;" : std::string(1, byte);
  }
  return shown;
}

namespace {

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

/// Text of a port as it stands in the example of a node.
std::string exampleText(const bt::PortSpec& port) {
  const std::string* const fallback = port.fallbackText();
  return !port.suggested.empty() ? port.suggested
         : fallback != nullptr   ? *fallback
                                 : "{" + port.key + "}";
}

/// The required ports, or the first one, with children that succeed at once.
std::string nodeExample(const bt::NodeManifest& node) {
  std::string text = "<" + node.id;
  for (const bt::PortSpec& port : node.ports) {
    if (port.required) {
      text += " " + port.key + "=\"" + exampleText(port) + "\"";
    }
  }
  if (node.minChildren == 0 && node.maxChildren == 0) {
    return text + "/>\n";
  }
  const int children = node.maxChildren == 1 ? 1 : std::max(2, node.minChildren);
  text += ">\n";
  for (int i = 0; i < children; ++i) {
    text += "  <AlwaysSuccess/>\n";
  }
  return text + "</" + node.id + ">\n";
}

std::string portRow(const bt::PortSpec& port) {
  const std::string* const fallback = port.fallbackText();
  const std::string direction = port.direction == bt::PortDirection::Input    ? "input"
                                : port.direction == bt::PortDirection::Output ? "output"
                                                                              : "in and out";
  const std::string type = bt::portTypeName(port.portType);
  return "| `" + port.key + "` | " + direction + " | " + (type.empty() ? "any" : type) + " | " +
         port.unit + " | " +
         (port.required         ? "required"
          : fallback != nullptr ? markdownCell(*fallback)
                                : "") +
         " | " + markdownCell(port.help) + " |\n";
}

std::string nodeSection(const bt::NodeManifest& node, const std::string& whose) {
  const std::string trees = whose == "both" ? "trees of people and robots" : "trees of " + whose;
  std::string text = "\n### " + node.id + "\n\n" + markdownCell(node.description) + "\n\n" +
                     bt::nodeKindName(node.kind) + ", " + bt::nodeOriginName(node.origin) +
                     ", for " + trees + ".\n\n```xml\n" + nodeExample(node) + "```\n";
  if (node.ports.empty()) {
    return text;
  }
  text += "\n| port | direction | type | unit | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const bt::PortSpec& port : node.ports) {
    text += portRow(port);
  }
  return text;
}

std::string limitsText(const sim2d::DriveLimits& limits) {
  return base::formatDouble(limits.maxVel) + " | " + base::formatDouble(limits.maxAcc) + " | " +
         base::formatDouble(limits.maxOmega);
}

}  // namespace

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

std::string plannersMarkdown() {
  return parameterPage("Planners", "planner_parameters",
                       pageSections(builtinRegistries().planners));
}

std::string modelsMarkdown() {
  return parameterPage("Models", "model_parameters", pageSections(builtinRegistries().models));
}

std::string robotsMarkdown() {
  std::string text =
      "# Robots\n\nWritten by `hunavsim list robots --format markdown`; do not edit by hand. A "
      "scenario sets the type in the key `type` of a robot.\n\n| type | name | drive | size | mass "
      "[kg] | top speed [m/s] | acceleration [m/s²] | turn rate [rad/s] | lidar |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  std::string sources = "\n## Sources\n\n";
  for (const sim2d::RobotType& type : sim2d::robotTypes()) {
    const std::string lidar = type.lidar ? std::to_string(type.lidar->beams) + " beams, " +
                                               base::formatDouble(type.lidar->range) + " m"
                                         : "–";
    text += "| `" + type.name + "` | " + type.title + " | " +
            sim2d::kinematicsName(type.body.kinematics) + " | " +
            robotSizeText(type.body.footprint) + " | " + base::formatDouble(type.body.mass) +
            " | " + limitsText(type.body.limits) + " | " + lidar + " |\n";
    sources += "- `" + type.name + "`: " + markdownCell(type.source) + "\n";
  }
  return text + sources;
}

std::string nodesMarkdown() {
  std::string text =
      "# Nodes\n\nWritten by `hunavsim list nodes --format markdown`; do not edit by hand.\n";
  std::vector<std::string> categories;
  const auto nodes = allNodes();
  for (const auto& [node, whose] : nodes) {
    if (std::find(categories.begin(), categories.end(), node.category) == categories.end()) {
      categories.push_back(node.category);
    }
  }
  for (const std::string& category : categories) {
    text += "\n## " + (category.empty() ? std::string("Other") : category) + "\n";
    for (const auto& [node, whose] : nodes) {
      text += node.category == category ? nodeSection(node, whose) : std::string();
    }
  }
  return text;
}

std::string problemsMarkdown() {
  std::string text =
      "# Problems\n\nWritten by `hunavsim list problems --format markdown`; do not edit by hand.\n";
  std::string area;
  for (const base::ProblemText& problem : base::problemTexts()) {
    const std::string id(problem.id);
    const std::string begin = id.substr(0, id.find('.'));
    if (begin != area) {
      area = begin;
      text += "\n## " + area + "\n\n| id | message |\n|---|---|\n";
    }
    text += "| `" + id + "` | " + markdownCell(std::string(problem.text)) +
            (problem.isSubstitution ? " (an error with `--strict`)" : "") + " |\n";
  }
  return text;
}

}  // namespace app
