#include "bt/engine/ScriptLexer.h"

#include <array>
#include <cctype>
#include <utility>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

constexpr std::array<std::string_view, 27> kSigns = {
    // longer ones first
    ":=", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "..", "=", "<",
    ">",  "+",  "-",  "*",  "/",  "|",  "&",  "^",  "~",  "!",  "?",  ":",  ";"};

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isNameStart(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '@';
}

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  base::Result<std::vector<ScriptToken>> run();

 private:
  char at(std::size_t index) const { return index < source_.size() ? source_[index] : '\0'; }
  bool next();  // false = cannot be read
  bool readNumber();
  bool readHex();
  bool readText();
  void readName();
  bool readSign();
  void push(ScriptToken::Kind kind, std::string text, double number, std::size_t length) {
    tokens_.push_back({kind, std::move(text), number, static_cast<int>(position_) + 1});
    position_ += length;
  }

  std::string_view source_;
  std::size_t position_ = 0;
  std::vector<ScriptToken> tokens_;
};

bool Lexer::readHex() {
  std::size_t end = position_ + 2;
  double value = 0.0;
  for (; std::isxdigit(static_cast<unsigned char>(at(end))) != 0; ++end) {
    const char c = at(end);
    const int digit =
        isDigit(c) ? c - '0' : (std::tolower(static_cast<unsigned char>(c)) - 'a' + 10);
    value = 16.0 * value + digit;
  }
  if (end == position_ + 2) {
    return false;
  }
  push(ScriptToken::Kind::Number, {}, value, end - position_);
  return true;
}

bool Lexer::readNumber() {
  if (at(position_) == '0' && (at(position_ + 1) == 'x' || at(position_ + 1) == 'X')) {
    return readHex();
  }
  std::size_t end = position_;
  while (isDigit(at(end))) {
    ++end;
  }
  if (at(end) == '.' && at(end + 1) != '.') {  // not the sign ".."
    ++end;
    while (isDigit(at(end))) {
      ++end;
    }
  }
  if (at(end) == 'e' || at(end) == 'E') {
    const std::size_t first = end + (at(end + 1) == '+' || at(end + 1) == '-' ? 2 : 1);
    std::size_t last = first;
    while (isDigit(at(last))) {
      ++last;
    }
    end = last > first ? last : end;
  }
  const std::string_view token = source_.substr(position_, end - position_);
  const std::optional<double> value = base::parseDouble(token);
  if (!value || isNameStart(at(end))) {
    return false;
  }
  push(ScriptToken::Kind::Number, std::string(token), *value, token.size());
  return true;
}

bool Lexer::readText() {
  const std::size_t end = source_.find('\'', position_ + 1);
  if (end == std::string_view::npos) {
    return false;
  }
  push(ScriptToken::Kind::Text, std::string(source_.substr(position_ + 1, end - position_ - 1)),
       0.0, end + 1 - position_);
  return true;
}

void Lexer::readName() {
  std::size_t end = position_ + 1;
  while (std::isalnum(static_cast<unsigned char>(at(end))) != 0 || at(end) == '_') {
    ++end;
  }
  const std::string name(source_.substr(position_, end - position_));
  if (name == "true" || name == "false") {
    push(ScriptToken::Kind::Number, {}, name == "true" ? 1.0 : 0.0, name.size());
  } else {
    push(ScriptToken::Kind::Name, name, 0.0, name.size());
  }
}

bool Lexer::readSign() {
  if (at(position_) == '(' || at(position_) == ')') {
    push(ScriptToken::Kind::Sign, std::string(1, at(position_)), 0.0, 1);
    return true;
  }
  for (const std::string_view sign : kSigns) {
    if (source_.substr(position_, sign.size()) == sign) {
      push(ScriptToken::Kind::Sign, std::string(sign), 0.0, sign.size());
      return true;
    }
  }
  return false;
}

bool Lexer::next() {
  const char c = at(position_);
  if (isDigit(c) || (c == '.' && isDigit(at(position_ + 1)))) {
    return readNumber();
  }
  if (c == '\'') {
    return readText();
  }
  if (isNameStart(c)) {
    readName();
    return true;
  }
  return readSign();
}

base::Result<std::vector<ScriptToken>> Lexer::run() {
  while (position_ < source_.size()) {
    if (std::isspace(static_cast<unsigned char>(at(position_))) != 0) {
      ++position_;
    } else if (!next()) {
      return base::makeError("cannot be read from column " + std::to_string(position_ + 1) + " on");
    }
  }
  push(ScriptToken::Kind::End, {}, 0.0, 0);
  return std::move(tokens_);
}

}  // namespace

base::Result<std::vector<ScriptToken>> tokensOf(std::string_view source) {
  return Lexer(source).run();
}

}  // namespace bt
