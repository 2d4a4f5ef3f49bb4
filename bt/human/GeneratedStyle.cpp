#include "bt/human/GeneratedStyle.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "bt/tree/TreeXml.h"

namespace bt {

namespace {

/// The words of all comments, without the whitespace around and between them.
std::vector<std::string> commentsIn(std::string_view xml) {
  constexpr std::string_view kBegin = "<!--";
  constexpr std::string_view kEnd = "-->";
  std::vector<std::string> comments;
  for (std::size_t at = xml.find(kBegin); at != std::string_view::npos; at = xml.find(kBegin, at)) {
    const std::size_t begin = at + kBegin.size();
    const std::size_t end = std::min(xml.find(kEnd, begin), xml.size());
    std::string& words = comments.emplace_back();
    for (const char c : xml.substr(begin, end - begin)) {
      if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
        words += c;
      }
    }
    at = end;
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

}  // namespace

bool hasExtraComments(const std::string& xml, const std::string& made) {
  const std::vector<std::string> known = commentsIn(made);
  const std::vector<std::string> found = commentsIn(xml);
  return !std::includes(known.begin(), known.end(), found.begin(), found.end());
}

std::optional<TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                        const sim2d::Human& human, const NodeCatalogue& catalogue) {
  const base::Result<TreeFile> found = readTreeText(xml);
  if (!found) {
    return std::nullopt;
  }
  for (const TreeStyle style : {TreeStyle::Corrected, TreeStyle::Hunav2}) {
    const std::string text = makeTreeText(scenario, human, style, catalogue);
    const base::Result<TreeFile> made = readTreeText(text);
    if (made && *made == *found && !hasExtraComments(xml, text)) {
      return style;
    }
  }
  return std::nullopt;
}

}  // namespace bt
