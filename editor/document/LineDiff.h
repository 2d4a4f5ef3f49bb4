#pragma once

#include <string>
#include <vector>

namespace editor {

/// A line of two texts laid side by side.
struct DiffLine {
  enum class Kind { Same, Removed, Added };
  Kind kind = Kind::Same;
  int left = 0, right = 0;  // line numbers from 1; 0 = not there
  std::string text;
};

/// The fewest lines to take out of `left` and put in to get `right`; texts too large for that:
/// everything between their common beginning and end counts as changed.
std::vector<DiffLine> lineDiff(const std::string& left, const std::string& right);

}  // namespace editor
