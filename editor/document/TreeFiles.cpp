#include "editor/document/TreeFiles.h"

#include <filesystem>

#include "bt/human/HumanNodes.h"
#include "bt/human/Templates.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace editor {

const bt::NodeCatalogue& treeCatalogue() {
  static const bt::NodeLibrary library = bt::humanNodes();
  return library.catalogue();
}

std::string treeFolderOf(const std::string& scenarioPath) {
  const std::filesystem::path folder = std::filesystem::path(scenarioPath).parent_path();
  return folder.filename() == "scenarios" ? (folder.parent_path() / "behavior_trees").string()
                                          : folder.string();
}

std::string treeFileName(const std::string& base, int humanId) {
  return bt::treeFileName(base, humanId);
}

std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          bt::TreeStyle style) {
  return bt::makeTreeText(scenario, human, style, treeCatalogue());
}

std::optional<bt::TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                            const sim2d::Human& human) {
  const base::Result<bt::TreeFile> found = bt::readTreeText(xml);
  if (!found) {
    return std::nullopt;  // broken: kept as it is, and told by whoever runs it
  }
  for (const bt::TreeStyle style : {bt::TreeStyle::Corrected, bt::TreeStyle::Hunav2}) {
    const base::Result<bt::TreeFile> made =
        bt::readTreeText(bt::makeTreeText(scenario, human, style, treeCatalogue()));
    if (made && *made == *found) {
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
