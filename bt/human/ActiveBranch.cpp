#include "bt/human/ActiveBranch.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <string_view>

namespace bt {

namespace {

using base::NodeStatus;

/// Descriptions of nodes: what a running action does, what a condition states.
const std::map<std::string, std::string, std::less<>>& nodeDescriptions() {
  static const std::map<std::string, std::string, std::less<>> kWords = {
      {"RegularNav", "walks to the goal"},
      {"UpdateGoal", "turns to the next goal"},
      {"GoTo", "walks to a place"},
      {"UseObject", "uses an object"},
      {"WanderInArea", "wanders in an area"},
      {"GoToNearestExit", "walks to the exit"},
      {"WaitInQueue", "waits in a queue"},
      {"SetGroupWalk", "walks with the group"},
      {"ConversationFormation", "talks with other people"},
      {"SurprisedNav", "stops and looks at the robot"},
      {"CuriousNav", "approaches the robot"},
      {"ScaredNav", "flees from the robot"},
      {"ThreateningNav", "blocks the robot"},
      {"ApproachRobot", "approaches the robot"},
      {"AvoidRobot", "flees from the robot"},
      {"BlockRobot", "blocks the robot"},
      {"YieldToRobot", "lets the robot pass"},
      {"PassOnSide", "passes the robot"},
      {"ApproachAgent", "approaches a person"},
      {"FollowAgent", "follows a person"},
      {"BlockAgent", "blocks a person"},
      {"FleeFrom", "flees from a person"},
      {"WaitForAgent", "waits for a person"},
      {"LookAtRobot", "looks at the robot"},
      {"LookAtAgent", "looks at a person"},
      {"LookAtPoint", "looks at a place"},
      {"SaySomething", "speaks"},
      {"StopMovement", "stops"},
      {"StopAndWaitTimerAction", "stands and waits"},
      {"TimeDelay", "waits"},
      {"IsRobotVisible", "the robot is in sight"},
      {"IsRobotClose", "the robot is close"},
      {"IsRobotFacingAgent", "the robot faces the person"},
      {"IsAgentVisible", "a person is in sight"},
      {"IsAgentClose", "a person is close"},
      {"IsAgentGroupFormed", "the group is together"},
      {"IsCrowded", "it is crowded"},
      {"IsGoalReached", "the goal is reached"},
      {"IsAtPosition", "the person is at the place"},
      {"IsSpeaking", "a person speaks"},
      {"IsAnyoneSpeaking", "a person speaks"},
      {"IsLookingAtMe", "a person looks at this person"},
      {"IsAnyoneLookingAtMe", "a person looks at this person"},
      {"IsTimeBetween", "the time is within its limits"},
      {"TimeExpiredCondition", "the timer has expired"},
      {"RandomChanceCondition", "a random draw succeeded"}};
  return kWords;
}

/// "MainFallback/SetGoals/RunOnce[2]" -> "RunOnce".
std::string_view ownName(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t bracket = name.rfind('[');
  return bracket != std::string_view::npos && name.back() == ']' ? name.substr(0, bracket) : name;
}

std::string_view branchAbove(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

bool isBelowBranch(std::string_view path, std::string_view ancestor) {
  return path.size() > ancestor.size() && path[ancestor.size()] == '/' &&
         path.substr(0, ancestor.size()) == ancestor;
}

bool isConditionName(std::string_view name) {
  const auto found = nodeDescriptions().find(name);
  const bool isKnown = found != nodeDescriptions().end();
  return name.substr(0, 2) == "Is" || (isKnown && name.find("Condition") != std::string_view::npos);
}

}  // namespace

std::string nodeDescription(const std::string& name) {
  const auto found = nodeDescriptions().find(name);
  if (found != nodeDescriptions().end()) {
    return found->second;
  }
  if (name.find(' ') != std::string::npos) {
    return name;
  }
  std::string words;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if (std::isupper(code) != 0 && !words.empty() && words.back() != ' ') {
      words += ' ';
    }
    words += letter == '_' ? ' ' : static_cast<char>(std::tolower(code));
  }
  return words;
}

namespace {

/// The last running leaf, otherwise the last completed action with a description, such as walking.
/// `count`: none.
std::size_t actingLeaf(const sim2d::TreeStatuses& tree, std::size_t count) {
  const std::vector<std::string>& paths = *tree.paths;
  std::size_t running = count, done = count;
  for (std::size_t node = 0; node < count; ++node) {
    if (node + 1 < count && isBelowBranch(paths[node + 1], paths[node])) {
      continue;
    }
    const std::string_view name = ownName(paths[node]);
    if (tree.statuses[node] == NodeStatus::Running) {
      running = node;
    } else if (tree.statuses[node] == NodeStatus::Success && !isConditionName(name) &&
               nodeDescriptions().find(name) != nodeDescriptions().end()) {
      done = node;
    }
  }
  return running != count ? running : done;
}

}  // namespace

ActiveBranch activeBranchOf(const sim2d::TreeStatuses& tree) {
  ActiveBranch branch;
  if (tree.paths == nullptr) {
    return branch;
  }
  const std::vector<std::string>& paths = *tree.paths;
  const std::size_t count = std::min(paths.size(), tree.statuses.size());
  const auto hasStatus = [&tree](std::size_t node, NodeStatus status) {
    return tree.statuses[node] == status;
  };
  const std::size_t leaf = actingLeaf(tree, count);
  if (leaf == count) {
    return branch;
  }
  branch.doing = nodeDescription(std::string(ownName(paths[leaf])));
  for (std::size_t node = 0; node < leaf; ++node) {
    const std::string_view name = ownName(paths[node]);
    const bool isOnTheWay = isBelowBranch(paths[leaf], paths[node]) ||
                            isBelowBranch(paths[leaf], branchAbove(paths[node]));
    if (isOnTheWay && isConditionName(name) && hasStatus(node, NodeStatus::Success)) {
      branch.because +=
          (branch.because.empty() ? "" : " and ") + nodeDescription(std::string(name));
    }
  }
  return branch;
}

}  // namespace bt
