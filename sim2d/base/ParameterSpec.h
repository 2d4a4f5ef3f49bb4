#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

/// One description of a value that people may set: a key of a file, a parameter of a planner, a
/// model, a metric or a tree node. Readers, checks, `--set`, forms, lists and documents are made
/// from it, so that a value is described in one place.
namespace base {

/// Allowed numbers, ends included unless `above`: then `low` itself is refused.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above = false;

  bool contains(double value) const {
    return (above ? value > low : value >= low) && value <= high;
  }
};
constexpr Range kAnyNumber{};
constexpr Range kNotNegative{0.0};
constexpr Range kPositive{0.0, std::numeric_limits<double>::infinity(), true};

enum class ParameterType { Boolean, Integer, Number, Text, Choice, Numbers, Integers };

/// A value of any of these types; monostate = none is given. A choice is its word.
using ParameterValue = std::variant<std::monostate, bool, long long, double, std::string,
                                    std::vector<double>, std::vector<int>>;

/// How a form offers a number; the range it may have is `ParameterSpec::range`.
struct FormHints {
  std::string label;      // "Top speed"; empty = made from the key
  int decimals = 2;       // after the point
  double step = 0.1;      // of the arrows
  double sliderTo = 0.0;  // > 0: a slider from the low end of the range to here
};

struct ParameterSpec {
  std::string key;  // in files and paths: "max_vel"
  ParameterType type = ParameterType::Number;
  std::string unit;                  // "m", "m/s", "rad" …; empty = none
  Range range;                       // of a number, an integer, or each item of a list
  ParameterValue fallback;           // what counts when nothing is given; monostate = nothing does
  std::vector<std::string> choices;  // words of a choice, index = enumerator
  std::string help;                  // one sentence for people
  std::string source;  // paper and equation, or where the figure is from; may be empty
  FormHints form;
};

}  // namespace base
