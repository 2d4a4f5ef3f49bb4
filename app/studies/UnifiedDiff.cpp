#include "app/studies/UnifiedDiff.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace app {

namespace {

constexpr std::size_t kContext = 3;  // lines around a change

/// A line of the difference: ' ', '-' or '+'.
struct DiffLine {
  char sign = ' ';
  std::string text;
};

/// Lines with their ends, except for the last one, which may have none.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size() - 1);
    lines.push_back(text.substr(from, end - from + 1));
    from = end + 1;
  }
  return lines;
}

using Lines = std::vector<std::string>;

/// Lengths of the longest common subsequences of the ends of two lists.
std::vector<std::vector<std::size_t>> commonLengths(const Lines& a, const Lines& b) {
  std::vector<std::vector<std::size_t>> lengths(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      lengths[i][j] =
          a[i] == b[j] ? lengths[i + 1][j + 1] + 1 : std::max(lengths[i + 1][j], lengths[i][j + 1]);
    }
  }
  return lengths;
}

/// The shortest list of changes; removed lines before added ones.
std::vector<DiffLine> compared(const Lines& a, const Lines& b) {
  std::size_t same = 0;
  while (same < std::min(a.size(), b.size()) && a[same] == b[same]) {
    ++same;
  }
  std::size_t end = 0;
  while (end < std::min(a.size(), b.size()) - same &&
         a[a.size() - 1 - end] == b[b.size() - 1 - end]) {
    ++end;
  }
  const auto middle = [&](const Lines& of) {
    return Lines(of.begin() + static_cast<std::ptrdiff_t>(same),
                 of.end() - static_cast<std::ptrdiff_t>(end));
  };
  const Lines first = middle(a), second = middle(b);
  const auto lengths = commonLengths(first, second);
  std::vector<DiffLine> lines;
  for (std::size_t k = 0; k < same; ++k) {
    lines.push_back({' ', a[k]});
  }
  std::size_t i = 0, j = 0;
  while (i < first.size() || j < second.size()) {
    if (i < first.size() && j < second.size() && first[i] == second[j]) {
      lines.push_back({' ', first[i++]});
      ++j;
    } else if (j == second.size() || (i < first.size() && lengths[i + 1][j] >= lengths[i][j + 1])) {
      lines.push_back({'-', first[i++]});
    } else {
      lines.push_back({'+', second[j++]});
    }
  }
  for (std::size_t k = a.size() - end; k < a.size(); ++k) {
    lines.push_back({' ', a[k]});
  }
  return lines;
}

/// "-3,7": first line and count of one side; the count 1 is omitted.
std::string rangeText(std::size_t first, std::size_t count) {
  const std::string begin = std::to_string(count == 0 ? first - 1 : first);
  return count == 1 ? begin : begin + "," + std::to_string(count);
}

/// One block of changes [from, to) with its context. `a`, `b`: numbers of its first lines.
std::string hunk(const std::vector<DiffLine>& lines, std::size_t from, std::size_t to,
                 std::size_t a, std::size_t b) {
  std::size_t before = 0, after = 0;
  std::string body;
  for (std::size_t k = from; k < to; ++k) {
    const DiffLine& line = lines[k];
    before += line.sign != '+' ? 1 : 0;
    after += line.sign != '-' ? 1 : 0;
    body += line.sign + line.text;
    if (line.text.back() != '\n') {
      body += "\n\\ No newline at end of file\n";
    }
  }
  return "@@ -" + rangeText(a, before) + " +" + rangeText(b, after) + " @@\n" + body;
}

}  // namespace

std::string unifiedDiff(const std::string& textBefore, const std::string& textAfter,
                        const std::string& before, const std::string& after) {
  if (textBefore == textAfter) {
    return {};
  }
  const std::vector<DiffLine> lines = compared(linesOf(textBefore), linesOf(textAfter));
  std::string text = "--- " + before + "\n+++ " + after + "\n";
  std::size_t a = 1, b = 1, next = 0;  // line numbers of lines[next]
  const auto skipTo = [&](std::size_t place) {
    for (; next < place; ++next) {
      a += lines[next].sign != '+' ? 1 : 0;
      b += lines[next].sign != '-' ? 1 : 0;
    }
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].sign == ' ') {
      continue;
    }
    std::size_t last = k;  // of the block: changes with at most twice the context in between
    for (std::size_t each = k; each < lines.size() && each <= last + 2 * kContext + 1; ++each) {
      last = lines[each].sign != ' ' ? each : last;
    }
    const std::size_t from = std::max(next, k - std::min(k, kContext));
    const std::size_t to = std::min(lines.size(), last + 1 + kContext);
    skipTo(from);
    text += hunk(lines, from, to, a, b);
    skipTo(to);
    k = to - 1;
  }
  return text;
}

}  // namespace app
