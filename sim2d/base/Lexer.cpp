#include "sim2d/base/Lexer.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"

namespace base {
namespace {

using Kind = Token::Kind;

bool isOneOf(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

class Lexer {
 public:
  Lexer(std::string_view source, const LexerRules& rules) : source_(source), rules_(rules) {}

  std::vector<Token> run() {
    while (position_ < source_.size()) {
      if (std::isspace(static_cast<unsigned char>(at(position_))) != 0) {
        ++position_;
      } else {
        next();
      }
    }
    push(Kind::End, 0);
    return std::move(tokens_);
  }

 private:
  char at(std::size_t index) const { return index < source_.size() ? source_[index] : '\0'; }
  bool startsName(char c) const { return isLetter(c) || c == '_' || isOneOf(c, rules_.nameStarts); }

  void push(Kind kind, std::size_t length, double number = 0.0) {
    const std::string_view text = source_.substr(position_, length);
    tokens_.push_back({kind, std::string(text), number, static_cast<int>(position_) + 1});
    position_ += length;
  }

  void next() {
    const char c = at(position_);
    const std::string_view sign = operatorHere();
    if (isDigit(c) || (c == '.' && sign.empty())) {
      readNumber();
    } else if (c == '\'' && rules_.hasStringLiterals) {
      readText();
    } else if (startsName(c)) {
      readName();
    } else {
      push(sign.empty() ? Kind::Unreadable : Kind::Sign, std::max<std::size_t>(sign.size(), 1));
    }
  }

  std::string_view operatorHere() const {
    const auto found = std::find_if(
        rules_.signs.begin(), rules_.signs.end(),
        [this](std::string_view sign) { return source_.substr(position_, sign.size()) == sign; });
    return found == rules_.signs.end() ? std::string_view() : *found;
  }

  /// Reads all digits, points and an exponent: two points make the number invalid.
  void readNumber() {
    if (rules_.hasHexNumbers && at(position_) == '0' && isOneOf(at(position_ + 1), "xX")) {
      readHexadecimal();
      return;
    }
    const bool hasRanges = std::count(rules_.signs.begin(), rules_.signs.end(), "..") > 0;
    std::size_t end = position_;
    for (; end < source_.size(); ++end) {
      const char c = at(end);
      const bool isRange = c == '.' && at(end + 1) == '.' && hasRanges;
      const bool isExponent = end > position_ && isOneOf(c, "eE");
      const bool isItsSign = end > position_ && isOneOf(c, "+-") && isOneOf(at(end - 1), "eE");
      if (isRange || !(isDigit(c) || c == '.' || isExponent || isItsSign)) {
        break;
      }
    }
    const std::optional<double> value = parseDouble(source_.substr(position_, end - position_));
    const bool isRead = value && (rules_.allowsNameAfterNumber || !startsName(at(end)));
    push(isRead ? Kind::Number : Kind::Unreadable, end - position_, value.value_or(0.0));
  }

  void readHexadecimal() {
    std::size_t end = position_ + 2;
    double value = 0.0;
    for (; std::isxdigit(static_cast<unsigned char>(at(end))) != 0; ++end) {
      const char c = at(end);
      const int digit =
          isDigit(c) ? c - '0' : (std::tolower(static_cast<unsigned char>(c)) - 'a' + 10);
      value = 16.0 * value + digit;
    }
    push(end > position_ + 2 ? Kind::Number : Kind::Unreadable, end - position_, value);
  }

  void readText() {
    const std::size_t end = source_.find('\'', position_ + 1);
    if (end == std::string_view::npos) {
      push(Kind::Unreadable, source_.size() - position_);
      return;
    }
    push(Kind::Text, end + 1 - position_);
    std::string& text = tokens_.back().text;
    text = text.substr(1, text.size() - 2);
  }

  void readName() {
    std::size_t end = position_ + 1;
    while (isLetter(at(end)) || isDigit(at(end)) || at(end) == '_' ||
           isOneOf(at(end), rules_.nameParts)) {
      ++end;
    }
    push(Kind::Name, end - position_);
  }

  std::string_view source_;
  const LexerRules& rules_;
  std::size_t position_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view source, const LexerRules& rules) {
  return Lexer(source, rules).run();
}

}  // namespace base
