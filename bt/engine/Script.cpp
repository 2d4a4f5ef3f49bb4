#include "bt/engine/Script.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "sim2d/base/Lexer.h"

namespace bt {
namespace {

using base::Token;
using Code = ScriptInstruction::Code;
using Operators = std::map<std::string_view, Code>;

const Operators& assignments() {
  static const Operators kTable = {{":=", Code::Create},     {"=", Code::Assign},
                                   {"+=", Code::AddTo},      {"-=", Code::SubtractFrom},
                                   {"*=", Code::MultiplyBy}, {"/=", Code::DivideBy}};
  return kTable;
}

/// The operators that take two values, loosest level first.
const std::vector<Operators>& binaryLevels() {
  static const std::vector<Operators> kTable = {
      {{"||", Code::Or}},
      {{"&&", Code::And}},
      {{"==", Code::Compare}},  // all comparisons, see comparison()
      {{"|", Code::BitOr}, {"^", Code::BitXor}},
      {{"&", Code::BitAnd}},
      {{"+", Code::Add}, {"-", Code::Subtract}, {"..", Code::Concat}},
      {{"*", Code::Multiply}, {"/", Code::Divide}}};
  return kTable;
}
constexpr std::size_t kComparisonLevel = 2;

constexpr int kMaxScriptNesting = 100;

const base::LexerRules& scriptWords() {
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

/// Recursive descent; one function per level of the grammar.
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
  void fail(const std::string& message);
  void emit(Code code, int index = 0, double number = 0.0) {
    script_.code.push_back({code, index, number});
  }
  int here() const { return static_cast<int>(script_.code.size()); }
  void push();
  void pop(int count = 1) { depth_ -= count; }
  int slot(const std::string& key, std::vector<int>& list);

  void statements();
  void assignment();
  void conditional();
  void binary(std::size_t level);
  void comparison();
  std::optional<Script::Comparison> takeComparison();
  void unary();
  void primary();

  std::vector<Token> tokens_;
  const std::function<int(const std::string&)>& slotOf_;
  Script script_;
  std::size_t position_ = 0;
  int depth_ = 0;
  int nesting_ = 0;
  std::optional<std::string> error_;
};

bool ScriptCompiler::take(std::string_view sign) {
  const bool found = isSign(sign);
  position_ += found ? 1 : 0;
  return found;
}

/// Only the first error counts. The rest of the tokens is given up, so every level returns soon.
void ScriptCompiler::fail(const std::string& message) {
  if (!error_) {
    error_ = message + " at column " + std::to_string(token().column);
  }
  position_ = tokens_.size() - 1;
}

void ScriptCompiler::push() {
  ++depth_;
  script_.depth = std::max(script_.depth, depth_);
}

int ScriptCompiler::slot(const std::string& key, std::vector<int>& list) {
  const int index = slotOf_(key);
  list.push_back(index);
  return index;
}

void ScriptCompiler::statements() {
  while (take(";")) {
  }
  while (token().kind != Token::Kind::End) {
    assignment();
    if (token().kind != Token::Kind::End && !isSign(";")) {
      fail("operator or ';' expected");
    }
    while (take(";")) {
    }
    if (token().kind != Token::Kind::End) {
      emit(Code::Drop);
      pop();
    }
  }
}

void ScriptCompiler::assignment() {
  const bool named = token().kind == Token::Kind::Name;
  const Token& next = tokens_[std::min(position_ + 1, tokens_.size() - 1)];
  const auto found =
      next.kind == Token::Kind::Sign ? assignments().find(next.text) : assignments().end();
  if (!named || found == assignments().end()) {
    conditional();
    return;
  }
  const std::string key = token().text;
  position_ += 2;
  if (++nesting_ > kMaxScriptNesting) {
    fail("too deeply nested");
  }
  assignment();
  --nesting_;
  emit(found->second, slot(key, script_.written));
}

void ScriptCompiler::conditional() {
  binary(0);
  if (!take("?")) {
    return;
  }
  const int test = here();
  emit(Code::JumpIfFalse);
  pop();
  if (++nesting_ > kMaxScriptNesting) {
    fail("too deeply nested");
  }
  conditional();
  if (!take(":")) {
    fail("':' expected");
  }
  const int leave = here();
  emit(Code::Jump);
  pop();
  script_.code[static_cast<std::size_t>(test)].index = here();
  conditional();
  --nesting_;
  script_.code[static_cast<std::size_t>(leave)].index = here();
}

void ScriptCompiler::binary(std::size_t level) {
  if (level == binaryLevels().size()) {
    unary();
    return;
  }
  if (level == kComparisonLevel) {
    comparison();
    return;
  }
  binary(level + 1);
  const Operators& operators = binaryLevels()[level];
  while (token().kind == Token::Kind::Sign) {
    const auto found = operators.find(token().text);
    if (found == operators.end()) {
      return;
    }
    ++position_;
    binary(level + 1);
    emit(found->second);
    pop();
  }
}

std::optional<Script::Comparison> ScriptCompiler::takeComparison() {
  using Comparison = Script::Comparison;
  static const std::map<std::string_view, Comparison> kTable = {
      {"==", Comparison::Equal},  {"!=", Comparison::NotEqual},  {"<", Comparison::Less},
      {">", Comparison::Greater}, {"<=", Comparison::LessEqual}, {">=", Comparison::GreaterEqual}};
  if (token().kind != Token::Kind::Sign) {
    return std::nullopt;
  }
  const auto found = kTable.find(token().text);
  if (found == kTable.end()) {
    return std::nullopt;
  }
  ++position_;
  return found->second;
}

void ScriptCompiler::comparison() {
  binary(kComparisonLevel + 1);
  std::vector<Script::Comparison> chain;
  while (const std::optional<Script::Comparison> comparison = takeComparison()) {
    chain.push_back(*comparison);
    binary(kComparisonLevel + 1);
  }
  if (!chain.empty()) {
    pop(static_cast<int>(chain.size()));
    emit(Code::Compare, static_cast<int>(script_.chains.size()));
    script_.chains.push_back(std::move(chain));
  }
}

void ScriptCompiler::unary() {
  static const std::map<std::string_view, Code> kTable = {
      {"-", Code::Negate}, {"~", Code::BitNot}, {"!", Code::Not}};
  const auto found = token().kind == Token::Kind::Sign ? kTable.find(token().text) : kTable.end();
  if (found == kTable.end()) {
    primary();
    return;
  }
  ++position_;
  if (++nesting_ > kMaxScriptNesting) {
    fail("too deeply nested");
  }
  unary();
  --nesting_;
  emit(found->second);
}

void ScriptCompiler::primary() {
  switch (token().kind) {
    case Token::Kind::Number:
      emit(Code::Number, 0, token().number);
      push();
      ++position_;
      return;
    case Token::Kind::Text:
      emit(Code::Text, static_cast<int>(script_.texts.size()));
      script_.texts.push_back(token().text);
      push();
      ++position_;
      return;
    case Token::Kind::Name:
      emit(Code::Load, slot(token().text, script_.read));
      push();
      ++position_;
      return;
    case Token::Kind::Sign:
    case Token::Kind::Unreadable:
    case Token::Kind::End:
      break;
  }
  if (!take("(")) {
    fail("value expected");
    return;
  }
  if (++nesting_ > kMaxScriptNesting) {
    fail("too deeply nested");
    return;
  }
  assignment();
  --nesting_;
  if (!take(")")) {
    fail("')' expected");
  }
}

base::Result<Script> ScriptCompiler::run() {
  statements();
  if (!error_ && script_.code.empty()) {
    error_ = "it is empty";
  }
  if (error_) {
    return base::error("tree.bad-script", {script_.source, *error_});
  }
  return std::move(script_);
}

}  // namespace

base::Result<Script> compileScript(std::string_view source,
                                   const std::function<int(const std::string& key)>& slotOf) {
  std::vector<Token> tokens = base::tokensOf(source, scriptWords());
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
