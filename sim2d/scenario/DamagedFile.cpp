#include "sim2d/scenario/DamagedFile.h"

#include <algorithm>
#include <string_view>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

namespace {

int firstErrorLine(const base::Diagnostics& diagnostics) {
  for (const base::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == base::Severity::Error && diagnostic.line > 0) {
      return diagnostic.line;
    }
  }
  return 0;
}

std::string_view firstLines(std::string_view text, int count) {
  std::size_t end = 0;
  for (int line = 0; line < count && end < text.size(); ++line) {
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return text.substr(0, end);
}

}  // namespace

ScenarioReading readBeginning(const std::string& path) {
  constexpr int kMostTries = 16;
  ScenarioReading reading = readScenario(path);
  const base::Result<std::string> text = base::readTextFile(path);
  if (reading.ok() || !text) {
    return reading;
  }
  int lines = firstErrorLine(reading.diagnostics) - 1;
  for (int attempt = 0; attempt < kMostTries && lines > 0; ++attempt) {
    base::Diagnostics ignored;  // of the part alone they would mislead
    const YamlNode root = parseYaml(firstLines(*text, lines), path, ignored);
    if (!base::hasErrors(ignored)) {
      TreeReading tree = readTree(root, path);
      reading.scenario = std::move(tree.scenario);
      reading.lines = std::move(tree.report.lines);
      reading.dialect = tree.dialect;
      return reading;
    }
    lines -= 1 << std::min(attempt / 4, 8);
  }
  return reading;
}

}  // namespace sim2d
