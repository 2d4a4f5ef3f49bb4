#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

/// Description of a settable value: a key of a file, or a parameter of a planner, pedestrian model,
/// metric or tree node. Readers, checks, `--set`, forms, lists and documentation are generated from
/// it.
namespace base {

/// Allowed numbers. Both ends are included; with `excludesLow`, `low` is excluded.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool excludesLow = false;

  bool contains(double value) const {
    return (excludesLow ? value > low : value >= low) && value <= high;
  }
};
constexpr Range kAnyNumber{};
constexpr Range kNotNegative{0.0};
constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};

enum class ParameterType { Boolean, Integer, Number, Text, Choice, Numbers, Integers };

/// A value of one of these types; monostate: not given. A choice is stored as its text.
using ParameterValue = std::variant<std::monostate, bool, long long, double, std::string,
                                    std::vector<double>, std::vector<int>>;

/// How a form shows a number; its limits are in `ParameterSpec::range`.
struct FormHints {
  std::string label;       // "Top speed"; empty: generated from the key
  int decimals = 2;        // shown after the point
  double step = 0.1;       // of the spin box
  double sliderMax = 0.0;  // > 0: shows a slider from range.low to this value
};

struct ParameterSpec {
  std::string key;  // in files and paths: "max_vel"
  ParameterType type = ParameterType::Number;
  std::string unit;                  // "m", "m/s", "rad" …; empty = none
  Range range;                       // of a number, an integer, or each item of a list
  ParameterValue fallback;           // default; monostate: none
  std::vector<std::string> choices;  // texts of a choice, index = enumerator
  std::string help;                  // one sentence for the user
  std::string source;                // paper and equation, or origin of the value; may be empty
  FormHints form;
};

}  // namespace base
