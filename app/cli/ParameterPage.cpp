#include "app/cli/ParameterPage.h"

#include <cmath>
#include <variant>

#include "sim2d/base/Text.h"

namespace app {

namespace {

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

}  // namespace

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

}  // namespace app
