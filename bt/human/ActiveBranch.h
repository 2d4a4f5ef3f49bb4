#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/trace/Recording.h"

namespace bt {

/// Why somebody acts, in words: "approaches the robot" because "the robot is visible".
struct ActiveBranch {
  std::string doing;    // of the leaf that acts; empty: none does
  std::string because;  // the conditions that held on the way to it; empty: there was none

  std::string words() const { return because.empty() ? doing : doing + ", because " + because; }
};

/// From what the nodes of a tree returned last and their names as records have them: the last leaf
/// that runs, else the last action that was done within the step, as walking is, and the conditions
/// that succeeded before it among its own ancestors and their elder siblings. Nodes of ours and
/// HuNavSim's have words of their own; others are called by their names.
ActiveBranch activeBranchOf(const sim2d::TreeStatuses& tree);

/// "ApproachRobot" -> "approaches the robot"; "MyOwnNode" -> "my own node". Without words of its
/// own a name with spaces stays as it is.
std::string wordsOfNode(const std::string& name);

}  // namespace bt
