#include "app/run/FileKind.h"

#include "bt/tree/TreeUse.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace app {

FileKind fileKindOf(const std::string& text) {
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first != std::string::npos && text[first] == '<') {
    const base::Result<bt::TreeFile> tree = bt::readTreeText(text);
    const bool isNavigator = tree && bt::treeUse(*tree) == bt::TreeUse::Navigator;
    return isNavigator ? FileKind::NavigatorTree : FileKind::Tree;
  }
  if (base::hasKeyLine(text, "hunav_loader")) {
    return FileKind::Scenario;
  }
  if (sim2d::nav2::looksLikeNav2(text)) {
    return FileKind::Nav2;
  }
  if (base::hasKeyLine(text, "hunavsim_experiment")) {
    return FileKind::Experiment;
  }
  const bool isAgents = base::hasKeyLine(text, "ros__parameters");
  return !isAgents && base::hasKeyLine(text, "image") ? FileKind::Map : FileKind::Scenario;
}

}  // namespace app
