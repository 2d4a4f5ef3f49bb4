#pragma once

#include <map>
#include <string>

#include "sim2d/base/Types.h"

namespace editor {

/// Saving would put another tree in the place of one that somebody wrote.
struct TreeQuestion {
  enum class Why {
    ChangedOnDisk,     // the file that would be replaced is nobody's that we know
    BehaviourChanged,  // behaviour or goals are others than when the tree was written
  };
  base::EntityId human;
  std::string name;         // of the person
  std::string path;         // of the tree's file
  std::string mine;         // the tree that was written by hand
  std::string replacement;  // what the document says: the generated tree, or one edited here
  Why why = Why::ChangedOnDisk;
};

enum class TreeAnswer { KeepMine, TakeReplacement };
using TreeAnswers = std::map<base::EntityId, TreeAnswer>;

}  // namespace editor
