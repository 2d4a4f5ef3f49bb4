#pragma once

#include <string>
#include <vector>

namespace editor {

/// One line of a side-by-side comparison of two texts.
struct DiffLine {
  enum class Kind { Same, Removed, Added };
  Kind kind = Kind::Same;
  int left = 0, right = 0;  // Line numbers from 1; 0 = not present.
  std::string text;
};

/// The minimal set of removed and added lines that turns `left` into `right`. For texts too large
/// for that, everything between their common prefix and suffix counts as changed.
std::vector<DiffLine> lineDiff(const std::string& left, const std::string& right);

}  // namespace editor
