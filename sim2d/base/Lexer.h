#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Tokenizer for one-line languages: scripts of behaviour trees, formulas of metrics.
namespace base {

struct Token {
  enum class Kind : unsigned char { Number, Text, Name, Sign, Unreadable, End };
  Kind kind = Kind::End;
  std::string text;     // operator, name or number as written; a text without quotes
  double number = 0.0;  // value of Kind::Number
  int column = 1;       // of the first character, from 1
};

/// The lexical rules of a language. A name begins with a letter, '_' or one of `nameStarts`,
/// followed by letters, digits, '_' and `nameParts`.
struct LexerRules {
  std::vector<std::string_view> signs;  // a longer sign precedes its prefixes
  std::string_view nameStarts, nameParts;
  bool hasStringLiterals = false;  // 'text'
  bool hasHexNumbers = false;      // 0x1f
  bool allowsNameAfterNumber = false;
};

/// The tokens of a source, ended by a token End. Characters that match no rule become Unreadable.
std::vector<Token> tokenize(std::string_view source, const LexerRules& rules);

}  // namespace base
