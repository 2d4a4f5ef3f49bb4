#include <algorithm>
#include <string_view>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

using base::YamlNode;

namespace {

/// From 1; behind the dashes of list entries.
int columnOfKey(const std::string& line) {
  const std::size_t found = line.find_first_not_of(" -");
  return found == std::string::npos ? 1 : static_cast<int>(found) + 1;
}

const YamlNode* findKey(const YamlNode& root, const std::string& dotted) {
  const YamlNode* node = &root;
  for (const std::string& key : base::split(dotted, '.')) {
    node = node->isMap() ? node->find(key) : nullptr;
    if (node == nullptr) {
      return nullptr;
    }
  }
  return node;
}

}  // namespace

void addLines(base::Diagnostics& diagnostics, const std::map<EntityId, int>& lines) {
  for (base::Diagnostic& diagnostic : diagnostics) {
    const auto found = lines.find(diagnostic.entity);
    if (diagnostic.line == 0 && diagnostic.entity && found != lines.end()) {
      diagnostic.line = found->second;
    }
  }
}

void addColumns(base::Diagnostics& diagnostics, const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return;  // who reads the file says why
  }
  const std::vector<std::string> lines = base::split(*text, '\n');
  for (base::Diagnostic& said : diagnostics) {
    const auto line = static_cast<std::size_t>(said.line);
    if (said.file == path && said.column == 0 && said.line > 0 && line <= lines.size()) {
      said.column = columnOfKey(lines[line - 1]);
    }
  }
}

void addPlaceOfKey(base::Diagnostics& diagnostics, const std::string& path,
                   const std::vector<std::string>& keys) {
  const bool hasNone = std::none_of(
      diagnostics.begin(), diagnostics.end(),
      [&path](const base::Diagnostic& said) { return said.file == path && said.line == 0; });
  if (hasNone) {
    return;  // to read a large file takes its time
  }
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return;
  }
  base::Diagnostics ignored;  // told by the reader of the scenario
  const YamlNode root = parseYaml(*text, path, ignored);
  const YamlNode* found = nullptr;
  for (const std::string& key : keys) {
    found = found == nullptr && !base::hasErrors(ignored) ? findKey(root, key) : found;
  }
  for (base::Diagnostic& said : diagnostics) {
    if (found != nullptr && said.file == path && said.line == 0) {
      said.line = found->keyLine;
      said.column = found->keyColumn;
    }
  }
}

void addPlaceOfMap(base::Diagnostics& diagnostics, const std::string& path) {
  addPlaceOfKey(diagnostics, path,
                {"hunavsim_desktop.ros__parameters.map_file", "hunav_loader.ros__parameters.map",
                 "hunav_loader.ros__parameters"});
}

}  // namespace sim2d
