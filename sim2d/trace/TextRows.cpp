#include "sim2d/trace/TextRows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d {

namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == ',';
}

bool beginsNumber(std::string_view text, std::size_t minus) {
  const char next = minus + 1 < text.size() ? text[minus + 1] : ' ';
  return (next >= '0' && next <= '9') || next == '.';
}

}  // namespace

std::string_view TextRows::withoutComment(std::string_view line) const {
  for (std::size_t k = line.find(comment_); k != std::string_view::npos;
       k = line.find(comment_, k + 1)) {
    const bool inWord =
        comment_ == '-' && (beginsNumber(line, k) || (k > 0 && !isBlank(line[k - 1])));
    if (!inWord) {
      return line.substr(0, k);
    }
  }
  return line;
}

bool TextRows::next(std::vector<Word>& row) {
  row.clear();
  while (row.empty() && position_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    const std::string_view line = withoutComment(text_.substr(position_, end - position_));
    position_ = end + 1;
    ++line_;
    for (std::size_t k = 0; k < line.size();) {
      if (isBlank(line[k])) {
        ++k;
        continue;
      }
      const std::size_t begin = k;
      while (k < line.size() && !isBlank(line[k])) {
        ++k;
      }
      row.push_back({line.substr(begin, k - begin), line_, static_cast<int>(begin) + 1});
    }
  }
  return !row.empty();
}

void WordReader::error(const Word& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_, at.line, at.column));
}

std::optional<double> WordReader::finite(const Word& word, const char* name) {
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !std::isfinite(*value)) {
    error(word, "trace.not-finite", {name, word.text});
    return std::nullopt;
  }
  return value;
}

std::optional<long long> WordReader::whole(const Word& word, const char* name) {
  constexpr double kLargest = 2e9;
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !(std::fabs(*value) <= kLargest) || *value != std::floor(*value)) {
    error(word, "trace.not-whole", {name, word.text});
    return std::nullopt;
  }
  return static_cast<long long>(*value);
}

}  // namespace sim2d
