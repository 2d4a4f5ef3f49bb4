#include <map>
#include <utility>
#include <vector>

#include "bt/human/TreeGenerator.h"

namespace bt {

using sim2d::BehaviorType;

namespace {

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

/// Both nodes run once, whether or not the robot is visible, as in HuNavSim's panel.
std::string runOnceReaction(const std::string& name, const std::string& node) {
  const auto once = [](const std::string& inside) {
    return "                <RunOnce>\n                    <" + inside +
           " />\n                </RunOnce>\n";
  };
  return "            <Sequence name=\"" + name + "\">\n" +
         once(R"(IsRobotVisible agent_id="{id}" distance="{dist}")") + once(node) +
         "            </Sequence>\n";
}

/// XML by behaviour; other behaviours walk regularly.
using Reactions = std::map<BehaviorType, std::string>;

const Reactions kPanelReactions = {
    {BehaviorType::Surprised, kSurprised},
    {BehaviorType::Scared,
     runOnceReaction("ScaNav",
                     R"(AvoidRobot agent_id="{id}" time_step="{dt}" runaway_vel="{maxvel}" )"
                     R"(safe_distance="{safe_distance}" duration="{duration}")")},
    {BehaviorType::Curious,
     runOnceReaction("CurNav",
                     R"(ApproachRobot agent_id="{id}" time_step="{dt}" )"
                     R"(closest_dist="{stopdist}" max_vel="{maxvel}" duration="{duration}")")},
    {BehaviorType::Threatening,
     runOnceReaction("ThreadNav", R"(BlockRobot agent_id="{id}" time_step="{dt}" )"
                                  R"(front_dist="{frontdist}" duration="{duration}")")}};

/// RunOnce{SetGoal} for each goal. The last one is inverted, so that the fallback continues in the
/// first tick. Without goals HuNavSim sets goal 1 and omits the inverter.
std::string goalNodes(const std::vector<int>& goals, const std::string& margin,
                      const std::string& step) {
  const auto once = [&step](const std::string& before, int goal) {
    return before + "<RunOnce>\n" + before + step + "<SetGoal agent_id=\"{id}\" goal_id=\"" +
           std::to_string(goal) + "\"/>\n" + before + "</RunOnce>\n";
  };
  if (goals.empty()) {
    return once(margin, 1);
  }
  std::string text;
  for (std::size_t i = 0; i + 1 < goals.size(); ++i) {
    text += once(margin, goals[i]);
  }
  return text + margin + "<Inverter>\n" + once(margin + step, goals.back()) + margin +
         "</Inverter>\n";
}

void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

/// Replaces {dist}, {duration} … and "{GOAL_SEQUENCE}" with the panel's values for this person.
std::string fillPlaceholders(std::string text, const sim2d::Human& human) {
  const sim2d::Behavior& behavior = human.behavior;
  const auto number = [](const std::optional<double>& value, double otherwise) {
    return shortNumber(value.value_or(otherwise));
  };
  replaceAll(text, "{GOAL_SEQUENCE}",
             "<Sequence name=\"SetGoals\">\n" +
                 goalNodes(human.goals, std::string(16, ' '), "    ") + std::string(12, ' ') +
                 "</Sequence>");
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

/// The element "<TreeNodesModel>…</TreeNodesModel>" of a file.
std::string modelElement(const std::string& file) {
  constexpr const char* kClosing = "</TreeNodesModel>";
  const std::size_t begin = file.find("<TreeNodesModel");
  const std::size_t end = file.find(kClosing);
  if (begin == std::string::npos || end == std::string::npos) {
    return "<TreeNodesModel/>";
  }
  return file.substr(begin, end + std::string(kClosing).size() - begin);
}

constexpr const char* kWrapperRegular = R"(    <!-- Navigation loop -->
    <Sequence name="RegularNavigation">
      <Inverter>
        <IsGoalReached agent_id="{id}"/>
      </Inverter>
      <RegularNav agent_id="{id}" time_step="{dt}"/>
    </Sequence>
    <!-- Update Goal -->
    <UpdateGoal agent_id="{id}"/>
)";
constexpr const char* kWrapperRegularCall = R"(    <Sequence name="RegNav">
      <SetBlackboard output_key="agentid" value="{id}"/>
      <SetBlackboard output_key="timestep" value="{dt}"/>
      <SubTree ID="RegularNavTree" id="{agentid}" dt="{timestep}"/>
    </Sequence>
)";
constexpr const char* kWrapperThreatening = R"(    <Sequence name="ThreatNav">
      <IsRobotVisible agent_id="{id}" distance="{dist}"/>
      <Sequence name="ThreatTimerNav">
        <Inverter>
          <TimeExpiredCondition seconds="{duration}" ts="{dt}" only_once="{once}"/>
        </Inverter>
        <ThreateningNav agent_id="{id}" time_step="{dt}" goal_dist="{frontdist}"/>
      </Sequence>
    </Sequence>
)";

/// Reacts while the robot is visible and the time has not elapsed.
std::string timedReaction(const std::string& name, const std::string& node) {
  return "    <Sequence name=\"" + name +
         "\">\n"
         "      <IsRobotVisible agent_id=\"{id}\" distance=\"{dist}\"/>\n"
         "      <Inverter>\n"
         "        <TimeExpiredCondition seconds=\"{duration}\" ts=\"{dt}\" only_once=\"{once}\"/>\n"
         "      </Inverter>\n"
         "      <" +
         node + "/>\n    </Sequence>\n";
}

const Reactions kWrapperReactions = {
    {BehaviorType::Surprised,
     timedReaction("SurNav", R"(SurprisedNav agent_id="{id}" time_step="{dt}")")},
    {BehaviorType::Scared,
     timedReaction("ScaNav", R"(ScaredNav agent_id="{id}" time_step="{dt}" )"
                             R"(runaway_vel="{maxvel}" scary_force_factor="{forcefactor}")")},
    {BehaviorType::Curious,
     timedReaction("CurNav", R"(CuriousNav agent_id="{id}" time_step="{dt}" )"
                             R"(stop_distance="{stopdist}" agent_vel="{maxvel}")")},
    {BehaviorType::Threatening, kWrapperThreatening}};

std::string panelTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const auto reaction = kPanelReactions.find(type);
  const bool isRegular = reaction == kPanelReactions.end();
  const std::string name = isRegular ? "Regular" : sim2d::behaviorName(type);
  std::string body = "    <BehaviorTree ID=\"" + name + "NavTree\">\n        <Fallback name=\"" +
                     name + (isRegular ? "Nav" : "") +
                     "Fallback\">\n            {GOAL_SEQUENCE}\n" +
                     (isRegular ? kRegular : reaction->second + kRegularCall) +
                     "        </Fallback>\n    </BehaviorTree>\n</root>\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<root main_tree_to_execute=\"" + name +
         "NavTree\" BTCPP_format=\"4\">\n\n  " + modelElement(modelFile) +
         "\n  <include path=\"BTRegularNav.xml\" />\n\n" + fillPlaceholders(std::move(body), human);
}

std::string wrapperTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const std::string name = sim2d::behaviorName(type);
  const auto reaction = kWrapperReactions.find(type);
  const bool reacts = reaction != kWrapperReactions.end();
  std::string body = "\n<include path=\"BTRegularNav.xml\" />\n\n\n";
  if (reacts) {
    body += "<!--<BehaviorTree ID=\"" + name + "NavTree\">-->\n";
  }
  body += "<BehaviorTree ID=\"DefaultTree\">\n  <Fallback name=\"" +
          (reacts ? name + "Fallback" : "MainFallback") + "\">\n" +
          "    <!-- Goal setting Sequence -->\n    <Sequence name=\"SetGoals\">\n" +
          goalNodes(human.goals, std::string(8, ' '), "  ") + "\n    </Sequence>\n" +
          (reacts ? reaction->second + kWrapperRegularCall : kWrapperRegular) +
          "  </Fallback>\n</BehaviorTree>\n\n\n\n</root>\n\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<root main_tree_to_execute=\"DefaultTree\" BTCPP_format=\"4\">\n  " +
         modelElement(modelFile) + "\n" + fillPlaceholders(std::move(body), human);
}

}  // namespace

std::string hunavTreeText(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          const std::string& modelFile) {
  const std::string simulator = scenario.simulator.value_or("");
  const bool isOfWrapper =
      simulator == "Gazebo Classic" || simulator == "Gazebo Fortress" || simulator == "Isaac Sim";
  return isOfWrapper ? wrapperTreeText(human, modelFile) : panelTreeText(human, modelFile);
}

}  // namespace bt
