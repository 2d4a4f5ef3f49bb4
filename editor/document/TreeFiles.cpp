#include "editor/document/TreeFiles.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "bt/human/HumanNodes.h"
#include "bt/tree/TreeXml.h"

namespace editor {

namespace {

/// The words of all comments, without the blanks around and between them.
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

bool hasCommentsBeyond(std::string_view xml, std::string_view made) {
  const std::vector<std::string> known = commentsIn(made);
  const std::vector<std::string> found = commentsIn(xml);
  return !std::includes(known.begin(), known.end(), found.begin(), found.end());
}

}  // namespace

const bt::NodeCatalogue& treeCatalogue() {
  static const bt::NodeLibrary library = bt::humanNodes();
  return library.catalogue();
}

std::string treeFolderOf(const std::string& scenarioPath) {
  const std::filesystem::path folder = std::filesystem::path(scenarioPath).parent_path();
  return folder.filename() == "scenarios" ? (folder.parent_path() / "behavior_trees").string()
                                          : folder.string();
}

std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          bt::TreeStyle style) {
  return bt::makeTreeText(scenario, human, style, treeCatalogue());
}

bool hasOwnComments(const std::string& xml, const sim2d::Scenario& scenario,
                    const sim2d::Human& human) {
  return hasCommentsBeyond(xml, generatedTree(scenario, human));
}

std::optional<bt::TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                            const sim2d::Human& human) {
  const base::Result<bt::TreeFile> found = bt::readTreeText(xml);
  if (!found) {
    return std::nullopt;  // broken: kept as it is, and told by whoever runs it
  }
  for (const bt::TreeStyle style : {bt::TreeStyle::Corrected, bt::TreeStyle::Hunav2}) {
    const std::string text = generatedTree(scenario, human, style);
    const base::Result<bt::TreeFile> made = bt::readTreeText(text);
    if (made && *made == *found && !hasCommentsBeyond(xml, text)) {
      return style;
    }
  }
  return std::nullopt;
}

std::optional<base::FileContent> missingIncludedTree(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / bt::kRegularNavFile).string();
  if (std::filesystem::exists(path)) {
    return std::nullopt;
  }
  return base::FileContent{path, bt::regularNavText(treeCatalogue())};
}

base::Diagnostics writeIncludedTrees(const std::string& folder) {
  const std::optional<base::FileContent> file = missingIncludedTree(folder);
  return file ? base::writeFilesTogether({*file}) : base::Diagnostics();
}

}  // namespace editor
