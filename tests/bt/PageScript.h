#pragma once

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A second implementation of scripts, made from the written description of BehaviorTree.CPP's
/// semantics alone and as plainly as can be. It shares nothing with bt/engine, so that both can be
/// compared on random trees.
namespace page {

/// The original throws here.
struct Fault {
  std::string what;
};
/// The description does not define what happens here: nothing is compared from then on.
struct Unsaid {
  std::string what;
};

struct Value {
  enum Kind { None, Number, Text } kind = None;
  double number = 0.0;
  bool whole = false;  // created by a whole number
  std::string text;

  static Value of(double number, bool whole = false) { return {Number, number, whole, {}}; }
  static Value of(std::string text) { return {Text, 0.0, false, std::move(text)}; }
};

/// The number of a text that is used as a number.
inline double numberIn(const std::string& text) {
  if (text == "true" || text == "false") {
    return text == "true" ? 1.0 : 0.0;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || std::isspace(static_cast<unsigned char>(text[0])) != 0 ||
      text[0] == '+') {
    throw Fault{"no number: " + text};
  }
  return value;
}

/// The variables that a script reads and writes.
class Variables {
 public:
  virtual ~Variables() = default;
  virtual Value read(const std::string& key) = 0;
  virtual Value assign(const std::string& key, const Value& value, bool creates) = 0;
};

struct Expression {
  std::string sign;  // "n": number, "t": text, "v": variable, "?", "=", else an operator
  Value value;
  std::vector<Expression> parts;
  std::vector<std::string> comparisons;  // between the parts of "<"
};

class ScriptParser {
 public:
  explicit ScriptParser(const std::string& source) : rest_(source) {}

  std::vector<Expression> statements() {
    std::vector<Expression> all;
    while (true) {
      while (take(";")) {
      }
      if (skipBlanks(), rest_.empty()) {
        return all;
      }
      all.push_back(assignment());
      if (skipBlanks(), !rest_.empty() && rest_[0] != ';') {
        throw Unsaid{"no semicolon"};
      }
    }
  }

 private:
  void skipBlanks() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_[0])) != 0) {
      rest_.erase(0, 1);
    }
  }
  bool take(const std::string& sign) {
    skipBlanks();
    if (rest_.compare(0, sign.size(), sign) != 0) {
      return false;
    }
    rest_.erase(0, sign.size());
    return true;
  }
  /// A sign that is not the beginning of a longer one.
  bool takeAlone(const std::string& sign, const std::string& notBefore) {
    skipBlanks();
    const bool isLonger =
        rest_.size() > sign.size() && notBefore.find(rest_[sign.size()]) != std::string::npos;
    return !isLonger && take(sign);
  }
  std::string name() {
    skipBlanks();
    std::size_t end = 0;
    while (end < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[end])) != 0 ||
                                  rest_[end] == '_' || rest_[end] == '@')) {
      ++end;
    }
    std::string found = rest_.substr(0, end);
    rest_.erase(0, end);
    return found;
  }

  Expression assignment() {
    skipBlanks();
    const std::string before = rest_;
    const bool isName =
        !rest_.empty() && (std::isalpha(static_cast<unsigned char>(rest_[0])) != 0 ||
                           rest_[0] == '_' || rest_[0] == '@');
    if (isName) {
      Expression target{"v", Value::of(name()), {}, {}};
      for (const char* sign : {":=", "+=", "-=", "*=", "/="}) {
        if (take(sign)) {
          return {sign, {}, {target, assignment()}, {}};
        }
      }
      if (takeAlone("=", "=")) {
        return {"=", {}, {target, assignment()}, {}};
      }
      rest_ = before;
    }
    return choice();
  }
  Expression choice() {
    Expression test = either();
    if (!take("?")) {
      return test;
    }
    Expression first = assignment();
    if (!take(":")) {
      throw Fault{"':' expected"};
    }
    return {"?", {}, {test, first, choice()}, {}};
  }
  /// Operands joined from left to right by signs, each with what does not follow it.
  Expression chain(Expression (ScriptParser::*operand)(),
                   const std::vector<std::pair<const char*, const char*>>& signs) {
    Expression left = (this->*operand)();
    for (bool isJoined = true; isJoined;) {
      isJoined = false;
      for (const auto& [sign, notBefore] : signs) {
        if (!isJoined && takeAlone(sign, notBefore)) {
          left = {sign, {}, {left, (this->*operand)()}, {}};
          isJoined = true;
        }
      }
    }
    return left;
  }
  Expression either() { return chain(&ScriptParser::both, {{"||", ""}}); }
  Expression both() { return chain(&ScriptParser::comparison, {{"&&", ""}}); }
  Expression comparison() {
    Expression all{"<", {}, {bits()}, {}};
    while (true) {
      std::string found;
      for (const char* sign : {"==", "!=", "<=", ">=", "<", ">"}) {
        if (take(sign)) {
          found = sign;
          break;
        }
      }
      if (found.empty()) {
        return all.comparisons.empty() ? all.parts[0] : all;
      }
      all.comparisons.push_back(found);
      all.parts.push_back(bits());
    }
  }
  Expression bits() { return chain(&ScriptParser::bitAnd, {{"|", "|"}, {"^", ""}}); }
  Expression bitAnd() { return chain(&ScriptParser::sum, {{"&", "&"}}); }
  Expression sum() { return chain(&ScriptParser::product, {{"..", ""}, {"+", "="}, {"-", "="}}); }
  Expression product() { return chain(&ScriptParser::unary, {{"*", "="}, {"/", "="}}); }
  Expression unary() {
    for (const char* sign : {"-", "~"}) {
      if (take(sign)) {
        return {std::string("u") + sign, {}, {unary()}, {}};
      }
    }
    if (takeAlone("!", "=")) {
      return {"u!", {}, {unary()}, {}};
    }
    return primary();
  }
  Expression primary() {
    if (take("(")) {
      Expression inner = assignment();
      if (!take(")")) {
        throw Fault{"')' expected"};
      }
      return inner;
    }
    skipBlanks();
    if (rest_.empty()) {
      throw Fault{"value expected"};
    }
    if (rest_[0] == '\'') {
      const std::size_t end = rest_.find('\'', 1);
      const Value text = Value::of(rest_.substr(1, end - 1));
      rest_.erase(0, end + 1);
      return {"t", text, {}, {}};
    }
    if (std::isdigit(static_cast<unsigned char>(rest_[0])) != 0) {
      return number();
    }
    const std::string key = name();
    if (key == "true" || key == "false") {
      return {"n", Value::of(key == "true" ? 1.0 : 0.0, true), {}, {}};
    }
    if (key.empty()) {
      throw Fault{"value expected"};
    }
    return {"v", Value::of(key), {}, {}};
  }
  Expression number() {
    std::size_t end = 0;
    while (end < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[end])) != 0 ||
                                  (rest_[end] == '.' && rest_.compare(end, 2, "..") != 0) ||
                                  (rest_[end] == '-' && end > 0 && rest_[end - 1] == 'e'))) {
      ++end;
    }
    const std::string text = rest_.substr(0, end);
    rest_.erase(0, end);
    const bool isHex = text.compare(0, 2, "0x") == 0;
    const bool isWhole = isHex || text.find_first_of(".e") == std::string::npos;
    return {"n", Value::of(std::strtod(text.c_str(), nullptr), isWhole), {}, {}};
  }

  std::string rest_;
};

class ScriptMachine {
 public:
  explicit ScriptMachine(Variables& variables) : variables_(variables) {}

  Value run(const std::string& source) {
    auto known = parsed().find(source);
    if (known == parsed().end()) {
      known = parsed().emplace(source, ScriptParser(source).statements()).first;
    }
    Value last;
    for (const Expression& statement : known->second) {
      last = evaluate(statement);
    }
    return last;
  }
  bool truth(const std::string& source) {
    const Value value = run(source);
    if (value.kind != Value::Number || (value.number != 0.0 && value.number != 1.0)) {
      throw Unsaid{"a condition that is neither 0 nor 1"};
    }
    return value.number == 1.0;
  }

 private:
  static std::map<std::string, std::vector<Expression>>& parsed() {
    static std::map<std::string, std::vector<Expression>> all;
    return all;
  }
  Value evaluate(const Expression& part) {
    if (part.sign == "n" || part.sign == "t") {
      return part.value;
    }
    if (part.sign == "v") {
      return variables_.read(part.value.text);
    }
    if (part.sign == "?") {
      const Value test = evaluate(part.parts[0]);
      if (test.kind != Value::Number) {
        throw Unsaid{"text before '?'"};
      }
      return evaluate(part.parts[test.number != 0.0 ? 1 : 2]);
    }
    if (part.sign == "<") {
      return compareAll(part);
    }
    if (part.sign.back() == '=' || part.sign == "=") {
      return assign(part);
    }
    if (part.sign[0] == 'u') {
      return unary(part.sign[1], evaluate(part.parts[0]));
    }
    const Value left = evaluate(part.parts[0]);
    return combine(part.sign, left, evaluate(part.parts[1]));
  }
  Value assign(const Expression& part) {
    const std::string& key = part.parts[0].value.text;
    Value value = evaluate(part.parts[1]);
    if (part.sign != ":=" && part.sign != "=") {
      value = combine(part.sign.substr(0, 1), variables_.read(key), value);
    }
    return variables_.assign(key, value, part.sign == ":=");
  }
  static Value unary(char sign, const Value& value) {
    if (value.kind != Value::Number) {
      throw Fault{"a sign before text"};
    }
    if (sign == '-') {
      return Value::of(-value.number);
    }
    return sign == '!' ? Value::of(value.number == 0.0 ? 1.0 : 0.0)
                       : Value::of(static_cast<double>(~static_cast<long long>(value.number)));
  }
  Value compareAll(const Expression& part) {
    Value left = evaluate(part.parts[0]);
    for (std::size_t k = 0; k < part.comparisons.size(); ++k) {
      const Value right = evaluate(part.parts[k + 1]);
      if (!holds(part.comparisons[k], left, right)) {
        return Value::of(0.0);
      }
      left = right;
    }
    return Value::of(1.0);
  }
  template <class T>
  static bool ordered(const std::string& sign, const T& a, const T& b) {
    return sign == "<" ? a < b : sign == ">" ? a > b : sign == "<=" ? a <= b : a >= b;
  }
  static bool holds(const std::string& sign, const Value& left, const Value& right) {
    const bool isEquality = sign == "==" || sign == "!=";
    if (left.kind == Value::Text && right.kind == Value::Text) {
      return isEquality ? (left.text == right.text) == (sign == "==")
                        : ordered(sign, left.text, right.text);
    }
    const double a = left.kind == Value::Text ? numberIn(left.text) : left.number;
    const double b = right.kind == Value::Text ? numberIn(right.text) : right.number;
    constexpr double kTolerance = 1.2e-7;
    return isEquality ? (std::fabs(a - b) <= kTolerance) == (sign == "==") : ordered(sign, a, b);
  }
  static Value combine(const std::string& sign, const Value& left, const Value& right) {
    const bool areTexts = left.kind == Value::Text && right.kind == Value::Text;
    if (areTexts && (sign == "+" || sign == "..")) {
      return Value::of(left.text + right.text);
    }
    if (sign == "..") {
      throw Unsaid{"how a number is written as text"};
    }
    if (left.kind != Value::Number || right.kind != Value::Number) {
      throw Fault{"text in arithmetic"};
    }
    const double a = left.number;
    const double b = right.number;
    if (sign == "&&" || sign == "||") {
      if ((a != 0.0 && a != 1.0) || (b != 0.0 && b != 1.0)) {
        throw Unsaid{"'&&' of something that is neither 0 nor 1"};
      }
      return Value::of((sign == "&&" ? a * b : a + b) > 0.0 ? 1.0 : 0.0);
    }
    if (sign == "&" || sign == "|" || sign == "^") {
      if (a != std::floor(a) || b != std::floor(b)) {
        throw Fault{"bits of a real"};
      }
      const auto x = static_cast<long long>(a);
      const auto y = static_cast<long long>(b);
      return Value::of(static_cast<double>(sign == "&"   ? (x & y)
                                           : sign == "|" ? (x | y)
                                                         : (x ^ y)));
    }
    return Value::of(sign == "+" ? a + b : sign == "-" ? a - b : sign == "*" ? a * b : a / b);
  }

  Variables& variables_;
};

}  // namespace page
