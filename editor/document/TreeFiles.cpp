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

std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human) {
  return bt::makeTreeText(scenario, human, bt::TreeStyle::Corrected, treeCatalogue());
}

bool isGeneratedTree(const std::string& xml, const sim2d::Scenario& scenario,
                     const sim2d::Human& human) {
  const base::Result<bt::TreeFile> found = bt::readTreeText(xml);
  if (!found) {
    return false;  // broken: kept as it is, and told by whoever runs it
  }
  for (const bt::TreeStyle style : {bt::TreeStyle::Corrected, bt::TreeStyle::Hunav2}) {
    const base::Result<bt::TreeFile> made =
        bt::readTreeText(bt::makeTreeText(scenario, human, style, treeCatalogue()));
    if (made && *made == *found) {
      return true;
    }
  }
  return false;
}

base::Diagnostics writeIncludedTrees(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / bt::kRegularNavFile).string();
  if (std::filesystem::exists(path)) {
    return {};
  }
  return base::writeFileAtomically(path, bt::regularNavText(treeCatalogue()));
}

}  // namespace editor
