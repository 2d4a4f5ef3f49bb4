#include "bt/human/HumanNodes.h"

namespace bt {

void addAllHumanNodes(NodeLibrary& to);  // written by CMake from the files in nodes/

NodeLibrary humanNodes() {
  NodeLibrary library;
  addAllHumanNodes(library);
  return library;
}

}  // namespace bt
