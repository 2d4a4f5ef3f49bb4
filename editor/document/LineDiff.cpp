#include "editor/document/LineDiff.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace editor {

namespace {

using Lines = std::vector<std::string>;
constexpr std::size_t kMostPairs = 16'000'000;  // 4000 x 4000 lines that differ

Lines linesOf(const std::string& text) {
  Lines lines = base::split(text, '\n');
  if (!lines.empty() && lines.back().empty()) {
    lines.pop_back();  // a newline at the end begins no line
  }
  return lines;
}

/// Length of the longest common subsequence of the lines from (i, j) on, for all i, j.
class CommonLengths {
 public:
  CommonLengths(const Lines& left, const Lines& right)
      : columns_(right.size() + 1), lengths_((left.size() + 1) * columns_, 0) {
    for (std::size_t i = left.size(); i-- > 0;) {
      for (std::size_t j = right.size(); j-- > 0;) {
        lengths_[i * columns_ + j] =
            left[i] == right[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
      }
    }
  }
  int at(std::size_t i, std::size_t j) const { return lengths_[i * columns_ + j]; }

 private:
  std::size_t columns_;
  std::vector<int> lengths_;
};

/// Walks along both texts.
struct Walk {
  const Lines& left;
  const Lines& right;
  std::size_t i = 0, j = 0;
  std::vector<DiffLine> lines = {};

  void same() {
    lines.push_back(
        {DiffLine::Kind::Same, static_cast<int>(i) + 1, static_cast<int>(j) + 1, left[i]});
    ++i;
    ++j;
  }
  void removed() {
    lines.push_back({DiffLine::Kind::Removed, static_cast<int>(i) + 1, 0, left[i]});
    ++i;
  }
  void added() {
    lines.push_back({DiffLine::Kind::Added, 0, static_cast<int>(j) + 1, right[j]});
    ++j;
  }
};

}  // namespace

std::vector<DiffLine> lineDiff(const std::string& left, const std::string& right) {
  const Lines a = linesOf(left);
  const Lines b = linesOf(right);
  std::size_t begin = 0;
  while (begin < a.size() && begin < b.size() && a[begin] == b[begin]) {
    ++begin;
  }
  std::size_t end = 0;
  while (end < a.size() - begin && end < b.size() - begin &&
         a[a.size() - 1 - end] == b[b.size() - 1 - end]) {
    ++end;
  }
  const auto middleOf = [&](const Lines& lines) {
    return Lines(lines.begin() + static_cast<std::ptrdiff_t>(begin),
                 lines.end() - static_cast<std::ptrdiff_t>(end));
  };
  const Lines middleA = middleOf(a);
  const Lines middleB = middleOf(b);
  Walk walk{a, b};
  while (walk.i < begin) {
    walk.same();
  }
  if ((middleA.size() + 1) * (middleB.size() + 1) <= kMostPairs) {
    const CommonLengths common(middleA, middleB);
    while (walk.i < begin + middleA.size() && walk.j < begin + middleB.size()) {
      const std::size_t i = walk.i - begin;
      const std::size_t j = walk.j - begin;
      if (middleA[i] == middleB[j]) {
        walk.same();
      } else if (common.at(i + 1, j) >= common.at(i, j + 1)) {
        walk.removed();
      } else {
        walk.added();
      }
    }
  }
  while (walk.i < begin + middleA.size()) {
    walk.removed();
  }
  while (walk.j < begin + middleB.size()) {
    walk.added();
  }
  while (walk.i < a.size()) {
    walk.same();
  }
  return std::move(walk.lines);
}

}  // namespace editor
