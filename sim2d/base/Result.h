#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

/// Errors in the input are values: readers collect all diagnostics and return them to the caller.
namespace base {

enum class Severity { Info, Warning, Error };

struct Diagnostic {
  Severity severity = Severity::Error;
  std::string file;            // as given by the user; empty: unknown
  int line = 0;                // from 1; 0: unknown
  int column = 0;              // from 1; 0: unknown
  std::string message;         // one sentence, a hint in brackets at the end: text of `code`
  EntityId entity;             // the entity concerned, if any
  std::string_view code = {};  // an id of problems.txt; programs depend on it
  std::vector<std::pair<std::string_view, std::string>> values = {};  // values of the placeholders

  /// The value of that name; empty if there is none.
  std::string value(std::string_view name) const;

  /// "cafe.yaml:12:7: warning: unknown key 'max_vell' (did you mean 'max_vel'?)"; unknown parts are
  /// omitted.
  std::string text() const;
};
using Diagnostics = std::vector<Diagnostic>;
struct Range;

/// The value of one placeholder: a text, or a number formatted as in files.
struct ProblemValue {
  ProblemValue(std::string value) : text(std::move(value)) {}                          // NOLINT
  ProblemValue(std::string_view value) : text(value) {}                                // NOLINT
  ProblemValue(const char* value) : text(value) {}                                     // NOLINT
  ProblemValue(const std::optional<std::string>& value) : text(value.value_or("")) {}  // NOLINT
  ProblemValue(double value);                                                          // NOLINT
  template <class T, class = std::enable_if_t<std::is_integral_v<T> && (sizeof(T) > 1)>>
  ProblemValue(T value) : text(std::to_string(value)) {}  // NOLINT

  std::string text;
};
using ProblemValues = std::vector<ProblemValue>;

/// Creates a problem of the catalogue (problems.txt); `values` fill the placeholders of its text in
/// order of first appearance.
Diagnostic error(std::string_view code, ProblemValues values = {}, std::string file = {},
                 int line = 0, int column = 0);
Diagnostic warning(std::string_view code, ProblemValues values = {}, std::string file = {},
                   int line = 0, int column = 0);
Diagnostic problem(Severity severity, std::string_view code, ProblemValues values = {},
                   std::string file = {}, int line = 0, int column = 0);

/// Prefixes the message with the object concerned, "anna: …", and stores it as the value "where".
Diagnostic withContext(const std::string& where, Diagnostic problem);
/// Replaces that prefix.
Diagnostic withNewContext(const std::string& where, Diagnostic problem);
/// The problem with another value of this placeholder, also in its message.
Diagnostic withValue(std::string_view name, const std::string& value, Diagnostic problem);
/// The problem of a number outside its range.
Diagnostic outOfRange(const std::string& found, const Range& range);

const char* severityName(Severity severity);  // "info", "warning", "error"
bool hasErrors(const Diagnostics& diagnostics);
void append(Diagnostics& to, const Diagnostics& more);

/// Lets each problem pass once, and at most 1000 different ones.
class DiagnosticFilter {
 public:
  /// `key`: identifies the problem, for example its text.
  bool isNew(const std::string& key) {
    constexpr std::size_t kMost = 1000;
    return keys_.size() < kMost && keys_.insert(key).second;
  }

 private:
  std::set<std::string> keys_;
};

/// A value with optional warnings, or no value and at least one error.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value, Diagnostics warnings = {})  // NOLINT: meant to convert
      : value_(std::move(value)), diagnostics_(std::move(warnings)) {}
  Result(Diagnostics errors) : diagnostics_(std::move(errors)) {  // NOLINT
    assert(hasErrors(diagnostics_));
  }
  Result(Diagnostic error) : diagnostics_{std::move(error)} {}  // NOLINT

  explicit operator bool() const { return value_.has_value(); }
  T& operator*() & { return *value_; }
  const T& operator*() const& { return *value_; }
  T&& operator*() && { return *std::move(value_); }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  std::optional<T> value_;
  Diagnostics diagnostics_;
};

/// The value with the problems as warnings; without it if one of them is an error.
template <class T>
Result<T> resultOf(T value, Diagnostics problems) {
  return hasErrors(problems) ? Result<T>(std::move(problems))
                             : Result<T>(std::move(value), std::move(problems));
}

/// The catalogue of diagnostics, compiled in from problems.txt. Code names a problem by its id
/// (base::error("scenario.goal-twice", {goal})); the text there is shown to the user.
struct ProblemText {
  std::string_view id;    // "area.what"; programs depend on it, so it does not change
  std::string_view text;  // one sentence with placeholders: {name}, {nearest} = " (did you mean
                          // '…'?)", {name?text, shown only with a value, which replaces %}
  /// The input is replaced, left out, or replaced by a default: `--strict` makes this warning an
  /// error. In the catalogue: `(substitution)` after the id.
  bool isSubstitution = false;
};

const std::vector<ProblemText>& problemTexts();
const ProblemText* problemText(std::string_view id);  // nullptr: unknown id

/// The problems, with warnings marked as substitutions turned into errors.
Diagnostics withStrictSubstitutions(Diagnostics problems);

}  // namespace base
