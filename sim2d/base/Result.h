#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

/// Bad input is a value: readers gather every problem and hand it to whoever shows it.
namespace base {

enum class Severity { Info, Warning, Error };

struct Diagnostic {
  Severity severity = Severity::Error;
  std::string file;            // as the user named it; empty = unknown
  int line = 0;                // from 1; 0 = unknown
  int column = 0;              // from 1; 0 = unknown
  std::string message;         // one sentence, hint in brackets at the end: the text of `code`
  EntityId entity;             // what it is about, if anything
  std::string_view code = {};  // which problem: an id of Problems.cpp; programs go by this
  std::vector<std::pair<std::string_view, std::string>> values = {};  // what fills the text's holes

  /// The value of that name; empty when there is none.
  std::string value(std::string_view name) const;

  /// "cafe.yaml:12:7: warning: unknown key 'max_vell' (did you mean 'max_vel'?)"; what is unknown
  /// is left out.
  std::string text() const;
};
using Diagnostics = std::vector<Diagnostic>;
struct Range;

/// Fills one hole of a problem's text: words, or a number as files write it.
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

/// A problem of the catalogue (Problems.cpp): `values` fill the holes of its text in the order in
/// which they first stand there.
Diagnostic error(std::string_view code, ProblemValues values = {}, std::string file = {},
                 int line = 0, int column = 0);
Diagnostic warning(std::string_view code, ProblemValues values = {}, std::string file = {},
                   int line = 0, int column = 0);
Diagnostic problem(Severity severity, std::string_view code, ProblemValues values = {},
                   std::string file = {}, int line = 0, int column = 0);

/// The problem with the thing that has it in front: "anna: …", as its value "where".
Diagnostic within(const std::string& where, Diagnostic problem);
/// The same problem of another thing.
Diagnostic elsewhere(const std::string& where, Diagnostic problem);
/// The problem of a number that its range does not contain.
Diagnostic outOfRange(const std::string& found, const Range& range);

const char* severityName(Severity severity);  // "info", "warning", "error"
bool hasErrors(const Diagnostics& diagnostics);
void append(Diagnostics& to, const Diagnostics& more);

/// A value with warnings, or no value with at least one error.
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

}  // namespace base
