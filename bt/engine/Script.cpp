#include "bt/engine/Script.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "sim2d/base/Lexer.h"

namespace bt {
namespace {

using base::Token;
using Kind = ScriptExpression::Kind;
using Sign = ScriptOperator;
using Signs = std::map<std::string_view, Sign>;

const Signs& assignmentOperators() {
  static const Signs kTable = {{":=", Sign::Create},   {"=", Sign::Assign},
                               {"+=", Sign::Add},      {"-=", Sign::Subtract},
                               {"*=", Sign::Multiply}, {"/=", Sign::Divide}};
  return kTable;
}

const Signs& unaryOperators() {
  static const Signs kTable = {{"-", Sign::Negate}, {"~", Sign::BitNot}, {"!", Sign::Not}};
  return kTable;
}

/// Binary operators, lowest precedence first.
const std::vector<Signs>& binaryLevels() {
  static const std::vector<Signs> kTable = {
      {{"||", Sign::Or}},
      {{"&&", Sign::And}},
      {{"==", Sign::Equal},
       {"!=", Sign::NotEqual},
       {"<", Sign::Less},
       {">", Sign::Greater},
       {"<=", Sign::LessEqual},
       {">=", Sign::GreaterEqual}},
      {{"|", Sign::BitOr}, {"^", Sign::BitXor}},
      {{"&", Sign::BitAnd}},
      {{"+", Sign::Add}, {"-", Sign::Subtract}, {"..", Sign::Concat}},
      {{"*", Sign::Multiply}, {"/", Sign::Divide}}};
  return kTable;
}
constexpr std::size_t kComparisonLevel = 2;

constexpr int kMaxScriptNesting = 100;

const base::LexerRules& scriptLexerRules() {
  static const base::LexerRules kRules = {
      {":=", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "..", "=", "<", ">",
       "+",  "-",  "*",  "/",  "|",  "&",  "^",  "~",  "!",  "?",  ":",  ";",  "(", ")"},
      "@",
      "",
      true,
      true,
      false};
  return kRules;
}

/// A number without a point or exponent is an integer.
Value numberOf(const Token& token) {
  const bool isHexadecimal = token.text.rfind("0x", 0) == 0 || token.text.rfind("0X", 0) == 0;
  const bool isWord = token.text == "true" || token.text == "false";
  const bool isWhole =
      isHexadecimal || isWord || token.text.find_first_of(".eE") == std::string::npos;
  constexpr double kLargest = 9.2e18;  // 64-bit limit
  return isWhole && token.number < kLargest ? Value::of(static_cast<std::int64_t>(token.number))
                                            : Value::of(token.number);
}

/// Recursive descent parser with one function per grammar level.
class ScriptCompiler {
 public:
  ScriptCompiler(std::string_view source, std::vector<Token> tokens,
                 const std::function<int(const std::string&)>& slotOf)
      : tokens_(std::move(tokens)), slotOf_(slotOf) {
    script_.source = source;
  }

  base::Result<Script> run();

 private:
  const Token& token() const { return tokens_[position_]; }
  bool isSign(std::string_view sign) const {
    return token().kind == Token::Kind::Sign && token().text == sign;
  }
  bool take(std::string_view sign);
  std::optional<Sign> take(const Signs& operators);
  void fail(const std::string& message);

  void statements();
  ScriptExpression assignment();
  ScriptExpression conditional();
  ScriptExpression binary(std::size_t level);
  ScriptExpression unary();
  ScriptExpression primary();
  ScriptExpression nested(ScriptExpression (ScriptCompiler::*part)());

  std::vector<Token> tokens_;
  const std::function<int(const std::string&)>& slotOf_;
  Script script_;
  std::size_t position_ = 0;
  int nesting_ = 0;
  std::optional<std::string> error_;
};

bool ScriptCompiler::take(std::string_view sign) {
  const bool found = isSign(sign);
  position_ += found ? 1 : 0;
  return found;
}

std::optional<Sign> ScriptCompiler::take(const Signs& operators) {
  const auto found =
      token().kind == Token::Kind::Sign ? operators.find(token().text) : operators.end();
  if (found == operators.end()) {
    return std::nullopt;
  }
  ++position_;
  return found->second;
}

/// Keeps the first error and skips the remaining tokens so that all levels return.
void ScriptCompiler::fail(const std::string& message) {
  if (!error_) {
    error_ = message + " at column " + std::to_string(token().column);
  }
  position_ = tokens_.size() - 1;
}

void ScriptCompiler::statements() {
  while (take(";")) {
  }
  while (token().kind != Token::Kind::End) {
    script_.statements.push_back(assignment());
    const bool isAssigned = assignmentOperators().count(token().text) > 0;
    if (token().kind == Token::Kind::Sign && isAssigned) {
      fail("name of an entry expected before '" + token().text + "'");
    }
    if (token().kind != Token::Kind::End && !isSign(";")) {
      script_.unparsedColumn = token().column;
      return;
    }
    while (take(";")) {
    }
  }
}

ScriptExpression ScriptCompiler::nested(ScriptExpression (ScriptCompiler::*part)()) {
  if (++nesting_ > kMaxScriptNesting) {
    fail("too deeply nested");
  }
  ScriptExpression expression = (this->*part)();
  --nesting_;
  return expression;
}

ScriptExpression ScriptCompiler::assignment() {
  const Token& next = tokens_[std::min(position_ + 1, tokens_.size() - 1)];
  const bool isNamed = token().kind == Token::Kind::Name && next.kind == Token::Kind::Sign;
  const auto sign = assignmentOperators().find(next.text);
  if (!isNamed || sign == assignmentOperators().end()) {
    return conditional();
  }
  const std::string key = token().text;
  position_ += 2;
  ScriptExpression expression;
  expression.kind = Kind::Assign;
  expression.operators = {sign->second};
  expression.operands.push_back(nested(&ScriptCompiler::assignment));
  expression.slot = slotOf_(key);
  script_.written.push_back(expression.slot);
  return expression;
}

ScriptExpression ScriptCompiler::conditional() {
  ScriptExpression test = binary(0);
  if (!take("?")) {
    return test;
  }
  ScriptExpression choice;
  choice.kind = Kind::Choose;
  choice.operands.push_back(std::move(test));
  choice.operands.push_back(nested(&ScriptCompiler::assignment));
  if (!take(":")) {
    fail("':' expected");
  }
  choice.operands.push_back(nested(&ScriptCompiler::conditional));
  return choice;
}

ScriptExpression ScriptCompiler::binary(std::size_t level) {
  if (level == binaryLevels().size()) {
    return unary();
  }
  ScriptExpression all;
  all.kind = level == kComparisonLevel ? Kind::Compare : Kind::Combine;
  all.operands.push_back(binary(level + 1));
  while (const std::optional<Sign> sign = take(binaryLevels()[level])) {
    all.operators.push_back(*sign);
    all.operands.push_back(binary(level + 1));
  }
  return all.operators.empty() ? std::move(all.operands.front()) : std::move(all);
}

ScriptExpression ScriptCompiler::unary() {
  const std::optional<Sign> sign = take(unaryOperators());
  if (!sign) {
    return primary();
  }
  ScriptExpression expression;
  expression.kind = Kind::Unary;
  expression.operators = {*sign};
  expression.operands.push_back(nested(&ScriptCompiler::unary));
  return expression;
}

ScriptExpression ScriptCompiler::primary() {
  ScriptExpression expression;
  if (token().kind == Token::Kind::Number) {
    expression.constant = numberOf(token());
  } else if (token().kind == Token::Kind::Text) {
    expression.constant = Value::of(std::string_view(token().text));
  } else if (token().kind == Token::Kind::Name) {
    expression.kind = Kind::Load;
    expression.slot = slotOf_(token().text);
  } else if (take("(")) {
    expression = nested(&ScriptCompiler::assignment);
    if (!isSign(")")) {
      fail("')' expected");
    }
  } else {
    fail("value expected");
  }
  position_ = std::min(position_ + 1, tokens_.size() - 1);
  return expression;
}

base::Result<Script> ScriptCompiler::run() {
  statements();
  if (!error_ && script_.statements.empty()) {
    error_ = "the script is empty";
  }
  if (error_) {
    return base::error("tree.bad-script", {script_.source, *error_});
  }
  return std::move(script_);
}

}  // namespace

base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf) {
  std::vector<Token> tokens = base::tokenize(source, scriptLexerRules());
  for (Token& token : tokens) {
    if (token.kind == Token::Kind::Unreadable) {
      return base::error("tree.script-not-read", {source, token.column});
    }
    if (token.kind == Token::Kind::Name && (token.text == "true" || token.text == "false")) {
      token.number = token.text == "true" ? 1.0 : 0.0;
      token.kind = Token::Kind::Number;
    }
  }
  return ScriptCompiler(source, std::move(tokens), slotOf).run();
}

}  // namespace bt
