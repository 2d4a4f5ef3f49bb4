#include "bt/human/WrapperTemplates.h"

#include "bt/human/PanelTemplates.h"

namespace bt {

using sim2d::BehaviorType;

namespace {

constexpr const char* kRegular = R"(    <!-- Navigation loop -->
    <Sequence name="RegularNavigation">
      <Inverter>
        <IsGoalReached agent_id="{id}"/>
      </Inverter>
      <RegularNav agent_id="{id}" time_step="{dt}"/>
    </Sequence>
    <!-- Update Goal -->
    <UpdateGoal agent_id="{id}"/>
)";
constexpr const char* kRegularCall = R"(    <Sequence name="RegNav">
      <SetBlackboard output_key="agentid" value="{id}"/>
      <SetBlackboard output_key="timestep" value="{dt}"/>
      <SubTree ID="RegularNavTree" id="{agentid}" dt="{timestep}"/>
    </Sequence>
)";
constexpr const char* kThreatening = R"(    <Sequence name="ThreatNav">
      <IsRobotVisible agent_id="{id}" distance="{dist}"/>
      <Sequence name="ThreatTimerNav">
        <Inverter>
          <TimeExpiredCondition seconds="{duration}" ts="{dt}" only_once="{once}"/>
        </Inverter>
        <ThreateningNav agent_id="{id}" time_step="{dt}" goal_dist="{frontdist}"/>
      </Sequence>
    </Sequence>
)";

/// While the robot is visible and the time is not up.
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

std::string reactionOf(BehaviorType type) {
  switch (type) {
    case BehaviorType::Surprised:
      return timedReaction("SurNav", R"(SurprisedNav agent_id="{id}" time_step="{dt}")");
    case BehaviorType::Scared:
      return timedReaction("ScaNav",
                           R"(ScaredNav agent_id="{id}" time_step="{dt}" )"
                           R"(runaway_vel="{maxvel}" scary_force_factor="{forcefactor}")");
    case BehaviorType::Curious:
      return timedReaction("CurNav", R"(CuriousNav agent_id="{id}" time_step="{dt}" )"
                                     R"(stop_distance="{stopdist}" agent_vel="{maxvel}")");
    case BehaviorType::Threatening:
      return kThreatening;
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
  }
  return {};
}

std::string setGoal(int goal, const std::string& margin) {
  return margin + "<RunOnce>\n" + margin + "  <SetGoal agent_id=\"{id}\" goal_id=\"" +
         std::to_string(goal) + "\"/>\n" + margin + "</RunOnce>\n";
}

/// The last goal fails once, so that the fallback goes on in the first tick.
std::string goalSequence(const std::vector<int>& goals) {
  const std::string margin(8, ' ');
  std::string text = "    <!-- Goal setting Sequence -->\n    <Sequence name=\"SetGoals\">\n";
  for (std::size_t i = 0; i + 1 < goals.size(); ++i) {
    text += setGoal(goals[i], margin);
  }
  text += goals.empty() ? setGoal(1, margin)
                        : margin + "<Inverter>\n" + setGoal(goals.back(), margin + "  ") + margin +
                              "</Inverter>\n";
  return text + "\n    </Sequence>\n";
}

}  // namespace

bool hasWrapperTrees(const sim2d::Scenario& scenario) {
  const std::string simulator = scenario.simulator.value_or("");
  return simulator == "Gazebo Classic" || simulator == "Gazebo Fortress" ||
         simulator == "Isaac Sim";
}

std::string wrapperTreeText(const sim2d::Human& human, const std::string& modelFile) {
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const std::string name = sim2d::behaviorName(type);
  const std::string reaction = reactionOf(type);
  const bool reacts = !reaction.empty();
  std::string body = "\n<include path=\"BTRegularNav.xml\" />\n\n\n";
  if (reacts) {
    body += "<!--<BehaviorTree ID=\"" + name + "NavTree\">-->\n";
  }
  body += "<BehaviorTree ID=\"DefaultTree\">\n  <Fallback name=\"" +
          (reacts ? name + "Fallback" : "MainFallback") + "\">\n" + goalSequence(human.goals) +
          (reacts ? reaction + kRegularCall : kRegular) +
          "  </Fallback>\n</BehaviorTree>\n\n\n\n</root>\n\n";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<root main_tree_to_execute=\"DefaultTree\" BTCPP_format=\"4\">\n  " +
         modelElement(modelFile) + "\n" + fillPlaceholders(std::move(body), human);
}

}  // namespace bt
