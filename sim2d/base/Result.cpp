#include "sim2d/base/Result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Text.h"

namespace base {
namespace {

constexpr ProblemText kTexts[] = {
#include "sim2d/base/problems.inc"  // written by CMake from problems.txt
};

constexpr bool areSortedAndUnique() {
  for (std::size_t i = 1; i < std::size(kTexts); ++i) {
    if (!(kTexts[i - 1].id < kTexts[i].id)) {
      return false;
    }
  }
  return true;
}
static_assert(areSortedAndUnique(), "problems.txt must be sorted by id, without duplicates");

constexpr std::string_view kContext = "where";  // the name of the value of withContext()

/// A placeholder in a text: {name}, or {name?text shown only with a value, which replaces %}.
struct Placeholder {
  std::size_t begin = std::string_view::npos, end = 0;
  std::string_view name;
  std::string_view pattern = "%";
};

std::optional<Placeholder> nextPlaceholder(std::string_view text, std::size_t from) {
  const auto isLower = [](char c) { return c >= 'a' && c <= 'z'; };
  for (from = text.find('{', from); from != text.npos; from = text.find('{', from + 1)) {
    std::size_t at = from + 1;
    while (at < text.size() && isLower(text[at])) {
      ++at;
    }
    const std::size_t end = text.find('}', at);
    if (at > from + 1 && end != text.npos && (end == at || text[at] == '?')) {
      Placeholder placeholder{from, end + 1, text.substr(from + 1, at - from - 1)};
      if (end > at) {
        placeholder.pattern = text.substr(at + 1, end - at - 1);
      }
      return placeholder;
    }
  }
  return std::nullopt;
}

std::string substituted(const Placeholder& placeholder, const std::string& value) {
  const bool isHint = placeholder.name == "nearest" && placeholder.pattern == "%";
  std::string text(isHint ? " (did you mean '%'?)" : placeholder.pattern);
  const std::size_t place = text.find('%');
  return value.empty() || place == text.npos ? std::string() : text.replace(place, 1, value);
}

/// The catalogue's text with these values, after the contexts among them.
std::string messageOf(const Diagnostic& problem, std::string_view text) {
  std::string message;
  for (const auto& [name, value] : problem.values) {
    message += name == kContext ? value + ": " : std::string();
  }
  std::size_t at = 0;
  while (const std::optional<Placeholder> placeholder = nextPlaceholder(text, at)) {
    message += text.substr(at, placeholder->begin - at);
    message += substituted(*placeholder, problem.value(placeholder->name));
    at = placeholder->end;
  }
  message += text.substr(at);
  return message;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string place = file;
  for (const int number : {line, line > 0 ? column : 0}) {
    if (number > 0) {
      place += (place.empty() ? "" : ":") + std::to_string(number);
    }
  }
  return place + (place.empty() ? "" : ": ") + severityName(severity) + ": " + message;
}

const char* severityName(Severity severity) {
  static constexpr std::array<const char*, 3> kNames = {"info", "warning", "error"};
  return kNames.at(static_cast<std::size_t>(severity));
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

void append(Diagnostics& to, const Diagnostics& more) {
  const std::size_t count = more.size();  // also correct if both are the same list
  to.reserve(to.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    to.push_back(more[i]);
  }
}

ProblemValue::ProblemValue(double value) : text(formatDouble(value)) {}

std::string Diagnostic::value(std::string_view name) const {
  for (const auto& [key, text] : values) {
    if (key == name) {
      return text;
    }
  }
  return {};
}

Diagnostic problem(Severity severity, std::string_view code, ProblemValues values, std::string file,
                   int line, int column) {
  const ProblemText* known = problemText(code);
  assert(known != nullptr && "no such problem in the catalogue");
  Diagnostic made{severity, std::move(file), line, column, {}, {}};
  if (known == nullptr) {
    return made;
  }
  made.code = known->id;
  const std::string_view text = known->text;
  auto next = values.begin();
  std::size_t at = 0;
  while (const std::optional<Placeholder> placeholder = nextPlaceholder(text, at)) {
    at = placeholder->end;
    const bool again = std::any_of(made.values.begin(), made.values.end(), [&](const auto& value) {
      return value.first == placeholder->name;
    });
    if (!again) {
      assert(next != values.end() && "a placeholder without a value");
      made.values.emplace_back(placeholder->name,
                               next == values.end() ? std::string() : std::move((next++)->text));
    }
  }
  assert(next == values.end() && "a value without a placeholder");
  made.message = messageOf(made, text);
  return made;
}

Diagnostic error(std::string_view code, ProblemValues values, std::string file, int line,
                 int column) {
  return problem(Severity::Error, code, std::move(values), std::move(file), line, column);
}

Diagnostic warning(std::string_view code, ProblemValues values, std::string file, int line,
                   int column) {
  return problem(Severity::Warning, code, std::move(values), std::move(file), line, column);
}

Diagnostic outOfRange(const std::string& found, const Range& range) {
  const bool isBounded = !std::isinf(range.high);
  if (isBounded && range.excludesLow) {
    return error("yaml.out-of-half-open-range", {found, range.low, range.high});
  }
  if (isBounded) {
    return std::isinf(range.low) ? error("yaml.too-high", {found, range.high})
                                 : error("yaml.out-of-range", {found, range.low, range.high});
  }
  return error(range.excludesLow ? "yaml.not-above" : "yaml.too-low", {found, range.low});
}

Diagnostic withContext(const std::string& where, Diagnostic problem) {
  problem.message.insert(0, where + ": ");
  problem.values.emplace(problem.values.begin(), kContext, where);
  return problem;
}

Diagnostic withNewContext(const std::string& where, Diagnostic problem) {
  assert(!problem.values.empty() && problem.values.front().first == kContext);
  problem.message.replace(0, problem.values.front().second.size(), where);
  problem.values.front().second = where;
  return problem;
}

Diagnostic withValue(std::string_view name, const std::string& value, Diagnostic problem) {
  const ProblemText* const known = problemText(problem.code);
  for (auto& [key, text] : problem.values) {
    text = known != nullptr && key == name ? value : text;
  }
  if (known != nullptr) {
    problem.message = messageOf(problem, known->text);
  }
  return problem;
}

const std::vector<ProblemText>& problemTexts() {
  static const std::vector<ProblemText> kAll(std::begin(kTexts), std::end(kTexts));
  return kAll;
}

const ProblemText* problemText(std::string_view id) {
  const auto* found =
      std::lower_bound(std::begin(kTexts), std::end(kTexts), id,
                       [](const ProblemText& each, std::string_view key) { return each.id < key; });
  return found == std::end(kTexts) || found->id != id ? nullptr : found;
}

Diagnostics withStrictSubstitutions(Diagnostics problems) {
  for (Diagnostic& each : problems) {
    const ProblemText* const text = problemText(each.code);
    const bool isWarning = each.severity == Severity::Warning;  // infos keep their severity
    each.severity =
        isWarning && text != nullptr && text->isSubstitution ? Severity::Error : each.severity;
  }
  return problems;
}

}  // namespace base
