#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/trace/Recording.h"

namespace bt {

/// What a person does and why, as text: "approaches the robot" because "the robot is visible".
struct ActiveBranch {
  std::string doing;    // of the acting leaf; empty: none
  std::string because;  // conditions that held on its path; empty: none

  std::string words() const { return because.empty() ? doing : doing + ", because " + because; }
};

/// Derives the active branch from the last statuses and the recorded names of a tree's nodes: the
/// last running leaf, otherwise the last action completed within the step (such as walking), and
/// the conditions that succeeded before it among its ancestors and their preceding siblings. Nodes
/// of HuNavSim and of this program have descriptions; others are shown by name.
ActiveBranch activeBranchOf(const sim2d::TreeStatuses& tree);

/// "ApproachRobot" -> "approaches the robot"; "MyOwnNode" -> "my own node". A name that contains
/// spaces and has no description is returned unchanged.
std::string nodeDescription(const std::string& name);

}  // namespace bt
