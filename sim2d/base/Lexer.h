#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Splits a line of a small language into words: scripts of behaviour trees, formulas of metrics.
namespace base {

struct Token {
  enum class Kind : unsigned char { Number, Text, Name, Sign, Unreadable, End };
  Kind kind = Kind::End;
  std::string text;     // sign, name, number as written, or what is between the quotes
  double number = 0.0;  // of Kind::Number
  int column = 1;       // of the first character
};

/// What a language has. A name begins with a letter, '_' or one of `nameStarts` and goes on with
/// letters, digits, '_' and `nameParts`.
struct LexerRules {
  std::vector<std::string_view> signs;  // longer ones before their beginnings
  std::string_view nameStarts, nameParts;
  bool hasTexts = false;         // 'like this'
  bool hasHexadecimals = false;  // 0x1f
  bool mayNameTouchNumber = false;
};

/// Always ends with a token End. What is none of the language's words becomes Unreadable.
std::vector<Token> tokensOf(std::string_view source, const LexerRules& rules);

}  // namespace base
