#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

namespace sim2d {

/// A word of a text file with its place, both from 1.
struct Word {
  std::string_view text;
  int line = 1, column = 1;
};

/// Lines of words between blanks, tabs and commas. Empty lines are passed over. The text must
/// outlive the reader.
class TextRows {
 public:
  /// What follows the mark is a comment. A '-' is one only where no number begins with it.
  explicit TextRows(std::string_view text, char comment = '#') : text_(text), comment_(comment) {}
  bool next(std::vector<Word>& row);

 private:
  std::string_view withoutComment(std::string_view line) const;

  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  int line_ = 0;
};

/// Numbers of a foreign file; every problem is noted with file, line and column.
class WordReader {
 public:
  WordReader(std::string file, base::Diagnostics& problems)
      : file_(std::move(file)), problems_(problems) {}

  void error(const Word& at, std::string_view code, base::ProblemValues values = {});
  std::optional<double> finite(const Word& word, const char* name);
  /// Also written with a point or an exponent: "12.0", "7.8e+02".
  std::optional<long long> whole(const Word& word, const char* name);
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  base::Diagnostics& problems_;
};

}  // namespace sim2d
