#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Splits the text of a script into words.
namespace bt {

struct ScriptToken {
  enum class Kind : unsigned char { Number, Text, Name, Sign, End };
  Kind kind = Kind::End;
  std::string text;  // sign, name, or what is between the quotes
  double number = 0.0;
  int column = 1;
};

/// Always ends with a token End.
base::Result<std::vector<ScriptToken>> tokensOf(std::string_view source);

}  // namespace bt
