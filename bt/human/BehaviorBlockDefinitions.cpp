#include "bt/human/BehaviorBlocks.h"
#include "bt/human/TreeGenerator.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace bt {

namespace {

/// Block definitions, one item per line, fields separated by bars. `nodes MODE` is followed by one
/// node per line; "A>B": B inside the decorator A; a line with a star is repeated for each person,
/// whose id is "$each". Approach distances are omitted in nodes for which HuNavSim's manager
/// rejects them.
constexpr const char* kBlocks = R"(
block EngageRobot|Robot interaction|Turns to the robot when it is in sight and approaches it
number detection|Sees within|m|1|20|5
number distance|Stops at|m|0.5|5|1.5
number speed|Speed|m/s|0.1|3|1.8
number duration|Lasts|s|5|120|30
nodes
IsRobotVisible agent_id={id} distance=$detection
LookAtRobot agent_id={id} yaw_tolerance=0.1
ApproachRobot agent_id={id} time_step={dt} closest_dist=$distance max_vel=$speed duration=$duration

block TalkInteract|Conversation|Stands together with others at a goal and talks
choice mode|With|nearest,specific|nearest
people people|People|2|specific
goal goal|Meets at goal|1
number detection|Sees within|m|2|20|10
number threshold|Closer than|m|0.5|10|2|specific
number duration|Lasts|s|10|180|30
nodes nearest
FindNearestAgent agent_id={id} target_agent_id={target_agent_id}
IsAgentVisible observer_id={id} agent_id={target_agent_id} distance=$detection field_of_view=3.14
LookAtAgent observer_id={id} target_id={target_agent_id} yaw_tolerance=0.1
ConversationFormation main_agent_id={id} goal_id=$goal conversation_duration=$duration time_step={dt} non_main_agent_ids={target_agent_id}
nodes specific
*IsAgentVisible observer_id={id} agent_id=$each distance=$detection field_of_view=3.14
*IsAgentClose observer_id={id} target_agent_id=$each threshold=$threshold
ConversationFormation main_agent_id={id} goal_id=$goal conversation_duration=$duration time_step={dt} non_main_agent_ids=$people

block RobotAvoidance|Robot awareness|Stops and looks while the robot is near, then walks on
number detection|Sees within|m|1|15|5
number stop|Stops within|m|0.5|5|2
nodes
IsRobotVisible agent_id={id} distance=$detection
IsRobotClose agent_id={id} threshold=$stop
StopMovement agent_id={id}
LookAtRobot agent_id={id} yaw_tolerance=0.1
RetryUntilSuccessful num_attempts=-1>Inverter>IsRobotClose agent_id={id} threshold=$stop
ResumeMovement agent_id={id}

block FollowAgent|Follow a person|Follows another person for some time
choice mode|Follows|nearest,specific|nearest
person target|Person|2|specific
number detection|Sees within|m|2|20|10
number close|Starts within|m|0.5|8|3
number distance|Keeps at|m|0.5|5|1.5
number speed|Speed|m/s|0.1|3|1.5
number duration|Lasts|s|10|300|60
nodes nearest
FindNearestAgent agent_id={id} target_agent_id={target_agent_id}
IsAgentVisible observer_id={id} agent_id={target_agent_id} distance=$detection field_of_view=3.14
IsAgentClose observer_id={id} target_agent_id={target_agent_id} threshold=$close
FollowAgent agent_id={id} target_agent_id={target_agent_id} time_step={dt} closest_dist=$distance max_vel=$speed duration=$duration
nodes specific
IsAgentVisible observer_id={id} agent_id=$target distance=$detection field_of_view=3.14
IsAgentClose observer_id={id} target_agent_id=$target threshold=$close
FollowAgent agent_id={id} target_agent_id=$target time_step={dt} closest_dist=$distance max_vel=$speed duration=$duration

block BlockingBehavior|Robot blocking|Steps into the path of the robot and stays there
number detection|Sees within|m|2|20|8
number front|Stands in front|m|0.5|5|2
number duration|Lasts|s|5|120|30
nodes
IsRobotVisible agent_id={id} distance=$detection
LookAtRobot agent_id={id} yaw_tolerance=0.1
BlockRobot agent_id={id} time_step={dt} front_dist=$front duration=$duration

block GroupFormation|Walk together|Walks in a group with the nearest person
number duration|Lasts|s|10|600|30
nodes
FindNearestAgent agent_id={id} target_agent_id={target_agent_id}
SetGroupWalk main_agent_id={id} time_step={dt} duration=$duration non_main_agent_ids={target_agent_id}

block SpeechDetection|Answer a call|Walks to a person who speaks and starts a conversation
number hearing|Hears within|m|2|20|8
number listening|Listens for|s|1|30|5
number approach|Approaches for|s|5|60|15
goal goal|Meets at goal|1
number duration|Talks for|s|10|180|45
nodes
IsAnyoneSpeaking agent_id={id} time_step={dt} distance_threshold=$hearing duration=$listening speaker_id={speaker_id}
ApproachAgent agent_id={id} target_agent_id={speaker_id} time_step={dt} duration=$approach
ConversationFormation main_agent_id={id} goal_id=$goal conversation_duration=$duration time_step={dt} non_main_agent_ids={speaker_id}

block AttentionSeeking|Answer a look|Looks back at an observer and says something
choice mode|Looked at by|people,robot|people
number distance|Within|m|2|15|6
number duration|Waits for|s|1|30|5|people
text message|Says|I see you looking at me!
nodes people
IsAnyoneLookingAtMe agent_id={id} time_step={dt} distance_threshold=$distance angle_threshold=0.2 duration=$duration observer_id={observer_id}
LookAtAgent observer_id={id} target_id={observer_id} yaw_tolerance=0.1
SaySomething agent_id={id} message=$message
nodes robot
IsRobotVisible agent_id={id} distance=$distance
IsRobotFacingAgent agent_id={id}
LookAtRobot agent_id={id} yaw_tolerance=0.1
SaySomething agent_id={id} message=$message

block GreetingInitiator|Greeting|Turns to the robot or a person in sight and greets
choice mode|Greets|robot,specific,nearest|robot
person target|Person|2|specific
number distance|Within|m|2|15|6
text message|Says|Hello there!
nodes robot
IsRobotVisible agent_id={id} distance=$distance
LookAtRobot agent_id={id} yaw_tolerance=0.1
SaySomething agent_id={id} message=$message
nodes specific
IsAgentVisible observer_id={id} agent_id=$target distance=$distance field_of_view=3.14
LookAtAgent observer_id={id} target_id=$target yaw_tolerance=0.1
SaySomething agent_id={id} message=$message
nodes nearest
FindNearestAgent agent_id={id} target_agent_id={target_agent_id}
IsAgentVisible observer_id={id} agent_id={target_agent_id} distance=$distance field_of_view=3.14
LookAtAgent observer_id={id} target_id={target_agent_id} yaw_tolerance=0.1
SaySomething agent_id={id} message=$message

block ProtectiveGuardian|Guardian|Steps between the robot and a person that it approaches
choice mode|Guards|nearest,specific|nearest
person target|Person|2|specific
number robot|Sees the robot|m|5|25|15
number detection|Sees people|m|3|20|10
number threat|Robot nearer than|m|1|8|3
number approach|Approaches for|s|1|30|5
number front|Stands in front|m|0.5|3|1.2
number duration|Blocks for|s|5|60|20
nodes nearest
IsRobotVisible agent_id={id} distance=$robot
FindNearestAgent agent_id={id} target_agent_id={target_agent_id}
IsAgentVisible observer_id={id} agent_id={target_agent_id} distance=$detection field_of_view=3.14
IsRobotClose agent_id={target_agent_id} threshold=$threat
LookAtAgent observer_id={id} target_id={target_agent_id} yaw_tolerance=0.1
ApproachAgent agent_id={id} target_agent_id={target_agent_id} time_step={dt} duration=$approach
BlockRobot agent_id={id} time_step={dt} front_dist=$front duration=$duration
nodes specific
IsRobotVisible agent_id={id} distance=$robot
IsAgentVisible observer_id={id} agent_id=$target distance=$detection field_of_view=3.14
IsRobotClose agent_id=$target threshold=$threat
LookAtAgent observer_id={id} target_id=$target yaw_tolerance=0.1
ApproachAgent agent_id={id} target_agent_id=$target time_step={dt} duration=$approach
BlockRobot agent_id={id} time_step={dt} front_dist=$front duration=$duration
)";

using Fields = std::vector<std::string>;

BlockParameter parameterOf(const std::string& word, const std::string& key, const Fields& fields) {
  using Kind = BlockParameter::Kind;
  static const std::map<std::string, Kind> kKinds = {
      {"number", Kind::Number}, {"choice", Kind::Choice}, {"text", Kind::Text},
      {"person", Kind::Person}, {"people", Kind::People}, {"goal", Kind::Goal}};
  BlockParameter parameter;
  parameter.key = key;
  parameter.label = fields[1];
  parameter.kind = kKinds.at(word);
  if (parameter.kind == Kind::Number) {
    parameter.unit = fields[2];
    parameter.min = base::parseDouble(fields[3]).value_or(0.0);
    parameter.max = base::parseDouble(fields[4]).value_or(0.0);
    parameter.initial = fields[5];
    parameter.mode = fields[6];
  } else if (parameter.kind == Kind::Choice) {
    parameter.choices = base::split(fields[2], ',');
    parameter.initial = fields[3];
  } else {
    parameter.initial = fields[2];
    parameter.mode = fields[3];
  }
  return parameter;
}

std::vector<BlockType> readKinds() {
  std::vector<BlockType> kinds;
  std::vector<std::string>* nodes = nullptr;
  for (const std::string& line : base::split(kBlocks, '\n')) {
    const std::size_t blank = line.find(' ');
    const std::string word = line.substr(0, blank);
    Fields fields = base::split(blank == std::string::npos ? "" : line.substr(blank + 1), '|');
    fields.resize(7);
    if (word.empty()) {
      nodes = nullptr;
    } else if (word == "block") {
      kinds.push_back({fields[0], fields[1], fields[2], {}, {}});
    } else if (word == "nodes") {
      nodes = &kinds.back().nodes[fields[0]];
    } else if (nodes != nullptr) {
      nodes->push_back(line);
    } else {
      kinds.back().parameters.push_back(parameterOf(word, fields[0], fields));
    }
  }
  return kinds;
}

}  // namespace

const std::vector<BlockType>& blockTypes() {
  static const std::vector<BlockType> kKinds = readKinds();
  return kKinds;
}

const BlockType* blockType(const std::string& id) {
  return base::findBy(blockTypes(), &BlockType::id, id);
}

const BlockParameter* BlockType::parameter(const std::string& key) const {
  return base::findBy(parameters, &BlockParameter::key, key);
}

std::vector<NodeSpec> BlockType::children(const std::string& mode,
                                          const std::vector<std::string>& people) const {
  std::vector<NodeSpec> result;
  const auto lines = nodes.find(mode);
  if (lines == nodes.end()) {
    return result;
  }
  for (const std::string& line : lines->second) {
    if (line[0] != '*') {
      result.push_back(parseNodeText(line));
      continue;
    }
    for (const std::string& person : people) {
      NodeSpec node = parseNodeText(line.substr(1));
      for (Attribute& port : node.ports) {
        port.text = port.text == "$each" ? person : port.text;
      }
      result.push_back(std::move(node));
    }
  }
  return result;
}

}  // namespace bt
