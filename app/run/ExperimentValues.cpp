#include "app/run/ExperimentValues.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

#include "app/run/Design.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

using base::YamlNode;
using Kind = ExperimentValue::Kind;

constexpr double kMaxRangeSteps = 1e6;  // of a range

/// FNV-1a: platform-independent.
std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char each : text) {
    hash = (hash ^ static_cast<unsigned char>(each)) * 1099511628211ULL;
  }
  return hash;
}

/// The draws of one value for one scenario and seed, by their number.
class Draws {
 public:
  Draws(const std::string& path, const std::string& scenario, long long seed)
      : seed_(static_cast<std::uint64_t>(seed)),
        scenario_(fnv1a(std::filesystem::path(scenario).stem().string())),
        path_(static_cast<std::uint32_t>(fnv1a(path))) {}

  double uniform(double from, double to, int number = 0) const {
    return rng(number).uniform(from, to, base::DrawPurpose::Value, path_);
  }
  double normal(double mean, double deviation, int number) const {
    return rng(number).normal(mean, deviation, base::DrawPurpose::Value, path_);
  }

 private:
  base::AgentRng rng(int number) const { return {seed_, number, scenario_}; }

  std::uint64_t seed_, scenario_;
  std::uint32_t path_;
};

/// Truncated normal distribution by rejection: of normal draws if most of them fit, otherwise of
/// uniform ones over the part with significant density.
double truncatedNormal(const std::array<double, 4>& numbers, const Draws& draws) {
  constexpr int kMaxDraws = 100000;             // never reached in practice
  constexpr double kNegligibleExponent = 40.0;  // exp(-40) of the maximum density
  const double mean = numbers[0], deviation = numbers[1], least = numbers[2], most = numbers[3];
  const double near = std::clamp(mean, least, most);
  const double reach =
      deviation * kNegligibleExponent / std::max(1.0, std::abs(near - mean) / deviation);
  const double from = std::max(least, near - reach), to = std::min(most, near + reach);
  const bool isWide = near == mean && most - least >= 2.0 * deviation;
  const auto exponent = [&](double x) {
    return 0.5 * ((x - mean) / deviation) * ((x - mean) / deviation);
  };
  for (int number = 0; number < kMaxDraws; number += 2) {
    if (isWide) {
      const double x = draws.normal(mean, deviation, number);
      if (x >= least && x <= most) {
        return x;
      }
    } else {
      const double x = draws.uniform(from, to, number);
      if (draws.uniform(0.0, 1.0, number + 1) < base::exp(exponent(near) - exponent(x))) {
        return x;
      }
    }
  }
  return near;
}

/// Reads exactly `count` finite numbers.
bool readNumbers(const YamlNode& list, std::size_t count, ExperimentValue& value) {
  if (!list.isList() || list.items.size() != count) {
    return false;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<double> number = base::parseDouble(list.items[k].text);
    if (!number || !std::isfinite(*number)) {
      return false;
    }
    value.numbers[k] = *number;
  }
  return true;
}

void readTexts(const YamlNode& list, ExperimentValue& value) {
  value.texts.reserve(list.items.size());
  for (const YamlNode& item : list.items) {
    value.texts.push_back(valueText(item));
  }
}

/// Rounds to nine digits after the first one of the step: 0.1 + 2 * 0.1 is 0.3.
double withoutRoundingError(double value, double step) {
  double scale = 1e9;
  for (double unit = 1.0; unit > step && scale < 1e22; unit /= 10.0) {
    scale *= 10.0;
  }
  const double whole = std::round(value * scale);
  return std::abs(whole) < 0x1p53 ? whole / scale : value;
}

/// from, from + step, … up to `to`.
bool readRange(const YamlNode& list, ExperimentValue& value) {
  if (!readNumbers(list, 3, value)) {
    return false;
  }
  const double from = value.numbers[0], to = value.numbers[1], step = value.numbers[2];
  const double steps = step > 0.0 && from <= to ? std::floor((to - from) / step + 1e-9) : -1.0;
  if (!(steps >= 0.0 && steps < kMaxRangeSteps)) {
    return false;
  }
  value.isRange = true;
  value.texts.reserve(static_cast<std::size_t>(steps) + 1);
  for (int k = 0; k <= static_cast<int>(steps); ++k) {
    value.texts.push_back(base::formatDouble(withoutRoundingError(from + k * step, step)));
  }
  return true;
}

bool readNormal(const YamlNode& list, ExperimentValue& value) {
  value.kind = Kind::Normal;
  return readNumbers(list, 4, value) && value.numbers[1] > 0.0 &&
         value.numbers[2] < value.numbers[3];
}

bool readUniform(const YamlNode& list, ExperimentValue& value) {
  value.kind = Kind::Uniform;
  return readNumbers(list, 2, value) && value.numbers[0] < value.numbers[1];
}

bool readBetween(const YamlNode& list, ExperimentValue& value) {
  value.kind = Kind::Between;
  value.isRange = true;
  return readNumbers(list, 2, value) && value.numbers[0] < value.numbers[1];
}

bool readChoice(const YamlNode& list, ExperimentValue& value) {
  value.kind = Kind::Choice;
  if (list.isList()) {
    readTexts(list, value);
  }
  return !value.texts.empty();
}

/// The forms of values other than a list.
struct ValueForm {
  const char* name;
  bool (*read)(const YamlNode& list, ExperimentValue& value);
  const char* problem;
};
constexpr ValueForm kValueForms[] = {{"range", readRange, "experiment.bad-range"},
                                     {"between", readBetween, "experiment.bad-between"},
                                     {"normal", readNormal, "experiment.bad-normal"},
                                     {"uniform", readUniform, "experiment.bad-uniform"},
                                     {"choice", readChoice, "experiment.bad-choice"}};

/// A list or map in flow style.
std::string flowStyleText(const YamlNode& node) {
  if (node.isNull()) {
    return "~";
  }
  if (node.isScalar()) {
    return base::emitYaml(node);
  }
  std::vector<std::string> parts;
  parts.reserve(node.items.size());
  for (const YamlNode& item : node.items) {
    const std::string key = node.isMap() ? base::emitYaml(base::stringNode(item.key)) + ": " : "";
    parts.push_back(key + flowStyleText(item));
  }
  const std::string inside = base::join(parts, ", ");
  return node.isMap() ? "{" + inside + "}" : "[" + inside + "]";
}

}  // namespace

std::vector<std::size_t> ExperimentValue::representativeTexts() const {
  std::vector<std::size_t> telling;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (!isRange || k < 2 || k + 1 == texts.size()) {
      telling.push_back(k);
    }
  }
  return telling;
}

void takeDesignPoints(const Design& design, std::vector<ExperimentValue>& values) {
  std::vector<ExperimentValue*> coordinates;
  for (ExperimentValue& value : values) {
    if (value.kind == Kind::Between) {
      coordinates.push_back(&value);
      value.texts.clear();
    }
  }
  for (const std::vector<double>& point : designPoints(design, coordinates.size())) {
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      const double from = coordinates[k]->numbers[0], to = coordinates[k]->numbers[1];
      coordinates[k]->texts.push_back(base::formatDouble(from + point[k] * (to - from)));
    }
  }
}

std::string drawnText(const ExperimentValue& value, const std::string& scenario, long long seed) {
  const Draws draws(value.path, scenario, seed);
  if (value.kind == Kind::Choice) {
    const auto count = static_cast<double>(value.texts.size());
    return value.texts[static_cast<std::size_t>(draws.uniform(0.0, count))];
  }
  return base::formatDouble(value.kind == Kind::Normal
                                ? truncatedNormal(value.numbers, draws)
                                : draws.uniform(value.numbers[0], value.numbers[1]));
}

base::Result<ExperimentValue> readExperimentValue(const YamlNode& node) {
  ExperimentValue value;
  value.path = node.key;
  if (node.isList()) {
    readTexts(node, value);
  }
  if (!value.texts.empty()) {
    return value;
  }
  if (!node.isMap() || node.items.size() != 1) {
    return located(node, base::error("experiment.values-no-list", {node.key}));
  }
  const YamlNode& list = node.items.front();
  std::vector<std::string> known;
  for (const ValueForm& way : kValueForms) {
    known.emplace_back(way.name);
    if (list.key == way.name) {
      return way.read(list, value) ? base::Result<ExperimentValue>(value)
                                   : located(list, base::error(way.problem));
    }
  }
  return located(base::keyNode(list),
                 base::error("experiment.unknown-draw", {list.key, base::join(known, ", "),
                                                         base::nearestName(list.key, known)}));
}

namespace {

/// A word of a list from valueText(), quoted for YAML if necessary.
std::string flowStyleWord(const std::string& text) {
  const bool isPlain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return base::isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '.' || c == '-' || c == '+' || c == '/';
  });
  const bool isList = !text.empty() && (text.front() == '[' || text.front() == '{');
  return isPlain || isList ? text : base::quotedText(text);
}

}  // namespace

std::string experimentValueText(const ExperimentValue& value) {
  std::vector<std::string> words;
  if (value.kind == Kind::Normal || value.kind == Kind::Uniform || value.kind == Kind::Between) {
    const std::size_t count = value.kind == Kind::Normal ? 4 : 2;
    for (std::size_t k = 0; k < count; ++k) {
      words.push_back(base::formatDouble(value.numbers[k]));
    }
  } else {
    std::transform(value.texts.begin(), value.texts.end(), std::back_inserter(words),
                   flowStyleWord);
  }
  std::string list = "[" + base::join(words, ", ") + "]";
  switch (value.kind) {
    case Kind::Grid:
      return list;
    case Kind::Between:
      return "{between: " + list + "}";
    case Kind::Normal:
      return "{normal: " + list + "}";
    case Kind::Uniform:
      return "{uniform: " + list + "}";
    case Kind::Choice:
      return "{choice: " + list + "}";
  }
  return list;
}

namespace {

/// The name of a file without folder and extension; other texts as they are.
std::string shortWord(const std::string& text) {
  const bool isOther = base::parseDouble(text) ||                         // 0.8
                       text.find_first_of(" \t") != std::string::npos ||  // a command
                       text.find(":=") != std::string::npos;              // a value of Nav2
  const std::filesystem::path path(text);
  if (isOther || !path.has_filename()) {
    return text;
  }
  const std::string extension = path.extension().string();
  const bool isVersion = extension.size() < 2 || base::isDigit(extension[1]);  // "v1.2"
  return (isVersion ? path.filename() : path.stem()).string();
}

/// The items of a list joined by plus signs, the values of a map by commas.
std::string wordInLabel(const YamlNode& node) {
  if (node.isScalar()) {
    return shortWord(node.text);
  }
  std::vector<std::string> words;
  std::transform(node.items.begin(), node.items.end(), std::back_inserter(words), wordInLabel);
  return words.empty() ? valueText(node) : base::join(words, node.isMap() ? ", " : " + ");
}

std::string optionLabel(const std::string& text) {
  if (text.empty() || text.front() != '{') {
    return text;
  }
  base::Diagnostics problems;
  const YamlNode map = base::parseYaml(text, {}, problems);
  if (!problems.empty() || !map.isMap() || map.items.empty()) {
    return text;
  }
  std::vector<std::string> words;
  std::transform(map.items.begin(), map.items.end(), std::back_inserter(words), wordInLabel);
  if (std::find(words.begin(), words.end(), "") != words.end()) {
    return text;
  }
  const std::string first = words.front();
  words.erase(words.begin());
  return words.empty() ? first : first + " (" + base::join(words, ", ") + ")";
}

}  // namespace

std::vector<std::string> optionLabels(const std::vector<std::string>& texts) {
  std::vector<std::string> labels;
  labels.reserve(texts.size());
  std::transform(texts.begin(), texts.end(), std::back_inserter(labels), optionLabel);
  const std::set<std::string> different(labels.begin(), labels.end());
  return different.size() == labels.size() ? labels : texts;
}

bool isInMap(const std::vector<std::string>& texts, const char* key) {
  return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
    base::Diagnostics ignored;
    const YamlNode node =
        base::startsWith(text, "{") ? base::parseYaml(text, {}, ignored) : YamlNode();
    return node.isMap() && node.find(key) != nullptr;
  });
}

bool arePlanners(const std::string& path, const std::vector<std::string>& texts) {
  constexpr const char* kPlannerKey = "planner";
  const std::string last = path.substr(path.rfind('.') + 1);  // the whole path if it has no dot
  return last == kPlannerKey || isInMap(texts, kPlannerKey);
}

base::Diagnostic located(const YamlNode& node, base::Diagnostic problem) {
  problem.line = node.line;
  problem.column = node.column;
  return problem;
}

const YamlNode& nodeOfText(const ExperimentValue& value, std::size_t text, const YamlNode& node) {
  const YamlNode& list = node.isMap() ? node.items.front() : node;
  const bool isLast = text + 1 == value.texts.size();
  const bool isWritten = !value.isRange || text == 0 || isLast;
  const std::size_t item = value.isRange && text != 0 ? 1 : text;  // [FROM, TO, STEP]
  return isWritten ? list.items[item] : list;
}

std::string valueText(const YamlNode& node) {
  return node.isScalar() ? node.text : flowStyleText(node);
}

}  // namespace app
