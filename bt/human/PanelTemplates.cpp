#include "bt/human/PanelTemplates.h"

#include <utility>
#include <vector>

#include "bt/human/TemplateNodes.h"

namespace bt {

using sim2d::BehaviorType;

namespace {

struct Template {
  const char* tree;
  const char* fallback;
  std::string reaction;  // elements of the reaction; empty = regular navigation
};

constexpr const char* kSurprised =
    R"(            <Sequence name="SurNav">
                <IsRobotVisible agent_id="{id}" distance="{dist}" />
                <Inverter>
                    <TimeExpiredCondition seconds="{duration}" ts="{dt}" only_once="{once}" />
                </Inverter>
                <SurprisedNav agent_id="{id}" time_step="{dt}" />
            </Sequence>
)";
constexpr const char* kRegular =
    R"(            <Sequence name="RegularNavigation">
                <Inverter>
                    <IsGoalReached agent_id="{id}" />
                </Inverter>
                <RegularNav agent_id="{id}" time_step="{dt}" />
            </Sequence>
            <UpdateGoal agent_id="{id}" />
)";
constexpr const char* kRegularCall =
    R"(            <Sequence name="RegNav">
                <SetBlackboard output_key="agentid" value="{id}" />
                <SetBlackboard output_key="timestep" value="{dt}" />
                <SubTree ID="RegularNavTree" id="{agentid}" dt="{timestep}" />
            </Sequence>
)";

/// Both run once, whether the robot was seen or not: so the panel has it.
std::string onceSeen(const std::string& name, const std::string& node) {
  const auto once = [](const std::string& inside) {
    return "                <RunOnce>\n                    <" + inside +
           " />\n                </RunOnce>\n";
  };
  return "            <Sequence name=\"" + name + "\">\n" +
         once(R"(IsRobotVisible agent_id="{id}" distance="{dist}")") + once(node) +
         "            </Sequence>\n";
}

Template templateOf(const sim2d::Human& human) {
  switch (human.behavior.type.value_or(BehaviorType::Regular)) {
    case BehaviorType::Surprised:
      return {"SurprisedNavTree", "SurprisedFallback", kSurprised};
    case BehaviorType::Scared:
      return {"ScaredNavTree", "ScaredFallback",
              onceSeen("ScaNav", R"(AvoidRobot agent_id="{id}" time_step="{dt}" )"
                                 R"(runaway_vel="{maxvel}" safe_distance="{safe_distance}" )"
                                 R"(duration="{duration}")")};
    case BehaviorType::Curious:
      return {"CuriousNavTree", "CuriousFallback",
              onceSeen("CurNav", R"(ApproachRobot agent_id="{id}" time_step="{dt}" )"
                                 R"(closest_dist="{stopdist}" max_vel="{maxvel}" )"
                                 R"(duration="{duration}")")};
    case BehaviorType::Threatening:
      return {"ThreateningNavTree", "ThreateningFallback",
              onceSeen("ThreadNav", R"(BlockRobot agent_id="{id}" time_step="{dt}" )"
                                    R"(front_dist="{frontdist}" duration="{duration}")")};
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
  }
  return {"RegularNavTree", "RegularNavFallback", ""};
}

/// Without goals the panel asks for goal 1 and forgets the inverter.
std::string goalSequence(const std::vector<int>& goals) {
  const std::string indent(12, ' ');
  const std::string inner(16, ' ');
  std::string text = "<Sequence name=\"SetGoals\">\n";
  const auto add = [&text](const std::string& margin, int goal) {
    text += margin + "<RunOnce>\n" + margin + "    <SetGoal agent_id=\"{id}\" goal_id=\"" +
            std::to_string(goal) + "\"/>\n" + margin + "</RunOnce>\n";
  };
  for (std::size_t i = 0; i + 1 < goals.size(); ++i) {
    add(inner, goals[i]);
  }
  if (goals.empty()) {
    add(inner, 1);
  } else {
    text += inner + "<Inverter>\n";
    add(inner + "    ", goals.back());
    text += inner + "</Inverter>\n";
  }
  return text + indent + "</Sequence>";
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

}  // namespace

std::string fillPlaceholders(std::string text, const sim2d::Human& human) {
  const sim2d::Behavior& behavior = human.behavior;
  const auto number = [](const std::optional<double>& value, double otherwise) {
    return shortNumber(value.value_or(otherwise));
  };
  replaceAll(text, "{GOAL_SEQUENCE}", goalSequence(human.goals));
  replaceAll(text, "{dist}", number(behavior.dist, 5.0));
  replaceAll(text, "{duration}", number(behavior.duration, 40.0));
  replaceAll(text, "{once}", behavior.once.value_or(false) ? "true" : "false");
  replaceAll(text, "{maxvel}", number(human.maxVel, 2.0));
  replaceAll(text, "{forcefactor}", number(behavior.otherForceFactor, 20.0));
  replaceAll(text, "{stopdist}", number(behavior.stopDist, 1.5));
  replaceAll(text, "{frontdist}", number(behavior.frontDist, 1.5));
  replaceAll(text, "{safe_distance}", number(behavior.safeDistance, 5.0));
  return text;
}

std::string modelElement(const std::string& file) {
  constexpr const char* kEnd = "</TreeNodesModel>";
  const std::size_t begin = file.find("<TreeNodesModel");
  const std::size_t end = file.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos) {
    return "<TreeNodesModel/>";
  }
  return file.substr(begin, end + std::string(kEnd).size() - begin);
}

std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const Template parts = templateOf(human);
  const bool isRegular = parts.reaction.empty();
  std::string body =
      std::string("    <BehaviorTree ID=\"") + parts.tree + "\">\n        <Fallback name=\"" +
      parts.fallback + "\">\n            {GOAL_SEQUENCE}\n" + parts.reaction +
      (isRegular ? kRegular : kRegularCall) + "        </Fallback>\n    </BehaviorTree>\n</root>\n";
  return std::string("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root main_tree_to_execute=\"") +
         parts.tree + "\" BTCPP_format=\"4\">\n\n  " + modelElement(modelFile) +
         "\n  <include path=\"BTRegularNav.xml\" />\n\n" + fillPlaceholders(std::move(body), human);
}

}  // namespace bt
