#include "app/run/FileKind.h"

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

namespace app {

FileKind fileKindOf(const std::string& text) {
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first != std::string::npos && text[first] == '<') {
    return bt::looksLikeNavigatorTree(text) ? FileKind::NavigatorTree : FileKind::Tree;
  }
  if (sim2d::nav2::looksLikeNav2(text)) {
    return FileKind::Nav2;
  }
  if (text.find("hunavsim_experiment") != std::string::npos) {
    return FileKind::Experiment;
  }
  const bool isAgents = text.find("ros__parameters") != std::string::npos;
  return !isAgents && text.find("image:") != std::string::npos ? FileKind::Map : FileKind::Scenario;
}

}  // namespace app
