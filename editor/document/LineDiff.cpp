#include "editor/document/LineDiff.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace editor {

namespace {

using Lines = std::vector<std::string>;
constexpr std::size_t kMaxPairs = 16'000'000;  // 4000 x 4000 differing lines.

Lines linesOf(const std::string& text) {
  Lines lines = base::split(text, '\n');
  if (!lines.empty() && lines.back().empty()) {
    lines.pop_back();  // A trailing newline does not begin another line.
  }
  return lines;
}

/// Length of the longest common subsequence of the lines from (i, j) to the ends, for all i, j.
std::vector<std::vector<int>> commonLengths(const Lines& left, const Lines& right) {
  std::vector<std::vector<int>> lengths(left.size() + 1, std::vector<int>(right.size() + 1));
  for (std::size_t i = left.size(); i-- > 0;) {
    for (std::size_t j = right.size(); j-- > 0;) {
      lengths[i][j] = left[i] == right[j] ? lengths[i + 1][j + 1] + 1
                                          : std::max(lengths[i + 1][j], lengths[i][j + 1]);
    }
  }
  return lengths;
}

/// The edit steps from one text to the other. Large texts are replaced as a whole.
std::vector<DiffLine::Kind> editSteps(const Lines& left, const Lines& right) {
  const bool isSmall = (left.size() + 1) * (right.size() + 1) <= kMaxPairs;
  const auto common = isSmall ? commonLengths(left, right) : std::vector<std::vector<int>>();
  std::vector<DiffLine::Kind> steps;
  std::size_t i = 0;
  std::size_t j = 0;
  while (isSmall && i < left.size() && j < right.size()) {
    const bool isSame = left[i] == right[j];
    const bool isGone = !isSame && common[i + 1][j] >= common[i][j + 1];
    steps.push_back(isSame   ? DiffLine::Kind::Same
                    : isGone ? DiffLine::Kind::Removed
                             : DiffLine::Kind::Added);
    i += isSame || isGone ? 1 : 0;
    j += isSame || !isGone ? 1 : 0;
  }
  steps.insert(steps.end(), left.size() - i, DiffLine::Kind::Removed);
  steps.insert(steps.end(), right.size() - j, DiffLine::Kind::Added);
  return steps;
}

}  // namespace

std::vector<DiffLine> lineDiff(const std::string& left, const std::string& right) {
  const Lines a = linesOf(left);
  const Lines b = linesOf(right);
  const auto begin = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  const auto end = std::mismatch(a.rbegin(), std::make_reverse_iterator(begin.first), b.rbegin(),
                                 std::make_reverse_iterator(begin.second));
  std::vector<DiffLine::Kind> steps(static_cast<std::size_t>(begin.first - a.begin()));
  const auto middle =
      editSteps(Lines(begin.first, end.first.base()), Lines(begin.second, end.second.base()));
  steps.insert(steps.end(), middle.begin(), middle.end());
  steps.resize(steps.size() + static_cast<std::size_t>(end.first - a.rbegin()));

  std::vector<DiffLine> lines;
  std::size_t i = 0;  // Numbers of lines already written for each text.
  std::size_t j = 0;
  for (const DiffLine::Kind kind : steps) {
    i += kind == DiffLine::Kind::Added ? 0 : 1;
    j += kind == DiffLine::Kind::Removed ? 0 : 1;
    lines.push_back({kind, kind == DiffLine::Kind::Added ? 0 : static_cast<int>(i),
                     kind == DiffLine::Kind::Removed ? 0 : static_cast<int>(j),
                     kind == DiffLine::Kind::Added ? b[j - 1] : a[i - 1]});
  }
  return lines;
}

}  // namespace editor
