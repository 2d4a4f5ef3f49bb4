#include "metrics/Expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "sim2d/base/Find.h"
#include "sim2d/base/Lexer.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

constexpr int kDeepest = 100;           // nested brackets
constexpr std::size_t kLongest = 4000;  // [characters]

using base::Token;
using EvaluationPoint = Expression::EvaluationPoint;
using Value = Expression::Value;

/// A part of the formula and how often its value changes.
struct Part {
  Value value;
  Scope scope = Scope::Run;
  bool isKnownAtEnd = false;  // known only at the end of the run
};

double truth(bool holds) {
  return holds ? 1.0 : 0.0;
}

/// Comparisons and logic give 1 or 0; undefined operands give undefined.
template <class Holds>
double test(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? a + b : truth(Holds{}(a, b));
}

/// A binary operator.
struct Operator {
  const char* sign;
  double (*apply)(double, double);
};

/// Lowest precedence first; longer operators first: "<=" before "<".
const std::vector<std::vector<Operator>>& operatorLevels() {
  static const std::vector<std::vector<Operator>> kLevels = {
      {{"or", test<std::logical_or<>>}},
      {{"and", test<std::logical_and<>>}},
      {{"<=", test<std::less_equal<>>},
       {">=", test<std::greater_equal<>>},
       {"==", test<std::equal_to<>>},
       {"!=", test<std::not_equal_to<>>},
       {"<", test<std::less<>>},
       {">", test<std::greater<>>}},
      {{"+", [](double a, double b) { return a + b; }},
       {"-", [](double a, double b) { return a - b; }}},
      {{"*", [](double a, double b) { return a * b; }},
       {"/", [](double a, double b) { return b == 0.0 ? std::nan("") : a / b; }}}};
  return kLevels;
}

const base::LexerRules& formulaLexerRules() {
  static const base::LexerRules kRules = {
      {"<=", ">=", "==", "!=", "<", ">", "+", "-", "*", "/", "^", "(", ")", ","},
      "",
      ".",
      false,
      false,
      true};
  return kRules;
}

template <class... Lists>
std::vector<std::string> namesOf(const Lists&... lists) {
  std::vector<std::string> names;
  const auto add = [&names](const auto& list) {
    for (const auto& entry : list) {
      names.push_back(entry.name);
    }
  };
  (add(lists), ...);
  return names;
}

}  // namespace

/// Recursive descent parser; stops at the first problem.
class ExpressionParser {
 public:
  explicit ExpressionParser(const std::string& text)
      : text_(text), tokens_(base::tokenize(text, formulaLexerRules())) {}

  base::Result<Expression> parse() {
    expression_.needs_ = {false};
    if (text_.size() > kLongest) {
      fail(0, "formula.too-long");
    }
    const Part part = parseAny(0);
    if (!hasFailed() && token().kind != Token::Kind::End) {
      fail(at(), "formula.left-over", {text_.substr(at())});
    }
    if (!hasFailed() && part.scope != Scope::Run) {
      fail(0, "formula.of-samples");
    }
    if (hasFailed()) {
      return problem_;
    }
    expression_.result_ = part.value;
    return std::move(expression_);
  }

 private:
  bool hasFailed() const { return !problem_.empty(); }
  Part fail(std::size_t at, const char* code, base::ProblemValues values = {}) {
    if (!hasFailed()) {
      problem_.push_back(base::error(code, std::move(values), "", 1, static_cast<int>(at) + 1));
    }
    return {[](const EvaluationPoint&) { return 0.0; }, Scope::Run};
  }

  const Token& token() const { return tokens_[next_]; }
  std::size_t at() const { return static_cast<std::size_t>(token().column) - 1; }

  /// Consumes the operator or word if it is the next token.
  bool take(std::string_view word) {
    const bool stands = (token().kind == Token::Kind::Sign || token().kind == Token::Kind::Name) &&
                        token().text == word;
    next_ += stands ? 1 : 0;
    return stands;
  }

  static Part joined(const Part& a, const Part& b, double (*apply)(double, double)) {
    return {[x = a.value, y = b.value, apply](const EvaluationPoint& place) {
              return apply(x(place), y(place));
            },
            std::max(a.scope, b.scope), a.isKnownAtEnd || b.isKnownAtEnd};
  }

  Part parseAny(int depth) {
    return depth > kDeepest ? fail(at(), "formula.too-many-brackets") : parseLevel(0, depth);
  }

  Part parseLevel(std::size_t level, int depth) {
    if (level == operatorLevels().size()) {
      return parseSigned(depth);
    }
    const std::vector<Operator>& operators = operatorLevels()[level];
    Part part = parseLevel(level + 1, depth);
    while (!hasFailed()) {
      const auto found = std::find_if(operators.begin(), operators.end(),
                                      [this](const Operator& one) { return take(one.sign); });
      if (found == operators.end()) {
        break;
      }
      part = joined(part, parseLevel(level + 1, depth), found->apply);
    }
    return part;
  }

  Part parseSigned(int depth) {
    if (depth > kDeepest) {
      return fail(at(), "formula.too-many-signs");
    }
    if (take("not")) {
      const Part part = parseSigned(depth + 1);
      return {[x = part.value](const EvaluationPoint& place) {
                const double value = x(place);
                return std::isnan(value) ? value : truth(value == 0.0);
              },
              part.scope, part.isKnownAtEnd};
    }
    if (take("-")) {
      const Part part = parseSigned(depth + 1);
      return {[x = part.value](const EvaluationPoint& place) { return -x(place); }, part.scope,
              part.isKnownAtEnd};
    }
    return parsePower(depth);
  }

  Part parsePower(int depth) {
    Part base = parsePrimary(depth);
    if (!hasFailed() && take("^")) {
      return joined(base, parseSigned(depth + 1),
                    [](double a, double b) { return std::pow(a, b); });
    }
    return base;
  }

  Part parsePrimary(int depth) {
    if (take("(")) {
      const Part inner = parseAny(depth + 1);
      return take(")") || hasFailed() ? inner : fail(at(), "formula.no-bracket");
    }
    if (token().kind == Token::Kind::Number) {
      return {[value = tokens_[next_++].number](const EvaluationPoint&) { return value; },
              Scope::Run};
    }
    if (token().kind == Token::Kind::Name) {
      return parseName(depth);
    }
    if (token().kind == Token::Kind::End) {
      return fail(at(), "formula.ends-early");
    }
    const char first = token().text.front();
    const bool isNumber = first == '.' || (first >= '0' && first <= '9');
    return isNumber ? fail(at(), "formula.no-number", {token().text})
                    : fail(at(), "formula.no-value");
  }

  Part parseName(int depth) {
    const std::size_t begin = at();
    const std::string name = tokens_[next_++].text;
    if (take("(")) {
      return parseCall(name, begin, depth + 1);
    }
    if (const VariableName* variable = base::findBy(variableNames(), &VariableName::name, name)) {
      expression_.needs_.robot |= variable->needsRobot;
      expression_.needs_.people |= variable->needsPeople;
      return {variable->value, variable->scope, variable->isKnownAtEnd};
    }
    return fail(begin, "formula.unknown-name",
                {name, base::nearestName(name, namesOf(variableNames()))});
  }

  std::vector<Part> parseArguments(int depth) {
    std::vector<Part> arguments;
    do {
      arguments.push_back(parseAny(depth));
    } while (!hasFailed() && take(","));
    if (!hasFailed() && !take(")")) {
      fail(at(), "formula.no-bracket");
    }
    return arguments;
  }

  Part parseCall(const std::string& name, std::size_t begin, int depth) {
    const std::vector<Part> arguments = parseArguments(depth);
    if (hasFailed()) {
      return arguments.front();
    }
    if (const FunctionName* function = base::findBy(functionNames(), &FunctionName::name, name)) {
      return callOf(*function, arguments, begin);
    }
    if (const AggregateName* total = base::findBy(aggregateNames(), &AggregateName::name, name)) {
      return totalOf(*total, arguments, begin);
    }
    if (const AggregateName* total =
            base::findBy(peopleAggregateNames(), &AggregateName::name, name)) {
      return peopleTotalOf(*total, arguments, begin);
    }
    const auto known = namesOf(functionNames(), aggregateNames(), peopleAggregateNames());
    return fail(begin, "formula.unknown-function", {name, base::nearestName(name, known)});
  }

  Part callOf(const FunctionName& function, const std::vector<Part>& arguments, std::size_t begin) {
    if (arguments.size() != function.arguments) {
      return fail(begin, "formula.value-count",
                  {function.name, function.arguments, arguments.size()});
    }
    Part part;
    for (const Part& argument : arguments) {
      part.scope = std::max(part.scope, argument.scope);
      part.isKnownAtEnd = part.isKnownAtEnd || argument.isKnownAtEnd;
    }
    part.value = [arguments, apply = function.apply](const EvaluationPoint& place) {
      std::array<double, 3> values{};
      for (std::size_t k = 0; k < arguments.size(); ++k) {
        values[k] = arguments[k].value(place);
      }
      return apply(values.data());
    };
    return part;
  }

  Part totalOf(const AggregateName& total, const std::vector<Part>& arguments, std::size_t begin) {
    if (arguments.size() != 1) {
      return fail(begin, "formula.one-value", {total.name});
    }
    if (arguments.front().scope == Scope::Pedestrian) {
      return fail(begin, "formula.of-people");
    }
    expression_.needsRecord_ = expression_.needsRecord_ || arguments.front().isKnownAtEnd;
    expression_.totals_.push_back({total.result, arguments.front().value});
    return {[index = expression_.totals_.size() - 1](const EvaluationPoint& place) {
              return place.totals[index];
            },
            Scope::Run, true};
  }

  Part peopleTotalOf(const AggregateName& total, const std::vector<Part>& arguments,
                     std::size_t begin) {
    if (arguments.size() != 1) {
      return fail(begin, "formula.one-value", {total.name});
    }
    expression_.needs_.people = true;
    return {[result = total.result, term = arguments.front().value](const EvaluationPoint& place) {
              return aggregateOverPeople(place, term, result);
            },
            Scope::Sample, arguments.front().isKnownAtEnd};
  }

  const std::string& text_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  base::Diagnostics problem_;
  Expression expression_;
};

base::Result<Expression> Expression::parse(const std::string& text) {
  return ExpressionParser(text).parse();
}

}  // namespace metrics
