/* cyclone_services DOMAIN: calls every service of an agent manager, a loader and a generator of
   agents once and prints a line for each: "SERVICE VALUES" of its answer. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "peer.h"

static const void* called(const char* name, PeerService service, void* request) {
  const void* const answer = peerCall(service, request);
  if (answer == NULL) {
    printf("%s no answer\n", name);
    exit(1);
  }
  printf("%s", name);
  return answer;
}

static void sayAgent(const hunav_msgs_msg_Agent* agent) {
  printf(" %d %s %.6f", agent->id, agent->name, agent->position.position.x);
}

static hunav_msgs_msg_Agent agentAt(int id, int type, char* name, double x) {
  hunav_msgs_msg_Agent agent;
  memset(&agent, 0, sizeof agent);
  agent.id = id;
  agent.type = (uint8_t)type;
  agent.name = name;
  agent.group_id = -1;
  agent.position.position.x = x;
  agent.position.orientation.w = 1.0;
  agent.desired_velocity = 1.5F;
  agent.radius = 0.4F;
  agent.behavior.type = 1;
  return agent;
}

#define CLIENT(service, package, type, request, response)                          \
  peerClient(participant, service, #package "::srv::dds_::" type,                  \
             &package##_srv_##request##_desc, &package##_srv_##response##_desc)

static void callManager(dds_entity_t participant) {
  hunav_msgs_msg_Agent person = agentAt(1, 1, "person1", 0.0);
  hunav_msgs_srv_ComputeAgentsRequest whole;
  memset(&whole, 0, sizeof whole);
  whole.current_agents.header.frame_id = "map";
  whole.current_agents.agents._length = whole.current_agents.agents._maximum = 1;
  whole.current_agents.agents._buffer = &person;
  whole.robot = agentAt(9, 2, "robot", 20.0);
  const PeerService compute =
      CLIENT("compute_agents", hunav_msgs, "ComputeAgents", ComputeAgentsRequest, ComputeAgentsResponse);
  for (int call = 0; call < 2; ++call) {
    whole.current_agents.header.stamp.sec = 100;
    whole.current_agents.header.stamp.nanosec = (uint32_t)call * 50000000U;
    const hunav_msgs_srv_ComputeAgentsResponse* computed = called("compute_agents", compute, &whole);
    sayAgent(&computed->updated_agents.agents._buffer[0]);
    putchar('\n');
  }
  hunav_msgs_srv_ComputeAgentRequest one;
  memset(&one, 0, sizeof one);
  one.id = 1;
  const hunav_msgs_srv_ComputeAgentResponse* ticked =
      called("compute_agent",
             CLIENT("compute_agent", hunav_msgs, "ComputeAgent", ComputeAgentRequest, ComputeAgentResponse),
             &one);
  printf(" %d %s\n", ticked->updated_agent.id, ticked->updated_agent.name);
  hunav_msgs_srv_MoveAgentRequest move;
  memset(&move, 0, sizeof move);
  move.current_agents = whole.current_agents;
  move.robot = whole.robot;
  move.agent_id = 1;
  const hunav_msgs_srv_MoveAgentResponse* moved = called(
      "move_agent", CLIENT("move_agent", hunav_msgs, "MoveAgent", MoveAgentRequest, MoveAgentResponse),
      &move);
  printf(" %d %s\n", moved->updated_agent.id, moved->updated_agent.name);
  hunav_msgs_srv_ResetAgentsRequest reset;
  memset(&reset, 0, sizeof reset);
  reset.current_agents = whole.current_agents;
  reset.robot = whole.robot;
  const hunav_msgs_srv_ResetAgentsResponse* isReset =
      called("reset_agents",
             CLIENT("reset_agents", hunav_msgs, "ResetAgents", ResetAgentsRequest, ResetAgentsResponse),
             &reset);
  printf(" %d\n", isReset->ok);
}

static void callLoader(dds_entity_t participant) {
  hunav_msgs_srv_GetAgentsRequest ask;
  memset(&ask, 0, sizeof ask);
  const hunav_msgs_srv_GetAgentsResponse* agents = called(
      "get_agents", CLIENT("get_agents", hunav_msgs, "GetAgents", GetAgentsRequest, GetAgentsResponse),
      &ask);
  sayAgent(&agents->agents.agents._buffer[0]);
  hunav_msgs_srv_GetParametersRequest nothing;
  memset(&nothing, 0, sizeof nothing);
  putchar('\n');
  const hunav_msgs_srv_GetParametersResponse* summary =
      called("get_parameters",
             CLIENT("get_parameters", hunav_msgs, "GetParameters", GetParametersRequest,
                    GetParametersResponse),
             &nothing);
  printf(" %d %lld %.3f\n", summary->publish_people, (long long)summary->goal_ids._buffer[0],
         summary->goal_x_coords._buffer[0]);
}

static void callParameters(dds_entity_t participant) {
  char* names[] = {"publish_tf", "use_sim_time"};
  rcl_interfaces_srv_NamesRequest of;
  memset(&of, 0, sizeof of);
  of.names._length = of.names._maximum = 2;
  of.names._buffer = names;
  const rcl_interfaces_srv_GetParametersResponse* got =
      called("get",
             CLIENT("hunav_agent_manager/get_parameters", rcl_interfaces, "GetParameters", NamesRequest,
                    GetParametersResponse),
             &of);
  printf(" %d %d\n", got->values._buffer[0].bool_value, got->values._buffer[1].bool_value);
  const rcl_interfaces_srv_GetParameterTypesResponse* types =
      called("types",
             CLIENT("hunav_agent_manager/get_parameter_types", rcl_interfaces, "GetParameterTypes",
                    NamesRequest, GetParameterTypesResponse),
             &of);
  printf(" %d %d\n", types->types._buffer[0], types->types._buffer[1]);
  const rcl_interfaces_srv_DescribeParametersResponse* described =
      called("describe",
             CLIENT("hunav_agent_manager/describe_parameters", rcl_interfaces, "DescribeParameters",
                    NamesRequest, DescribeParametersResponse),
             &of);
  printf(" %s %d\n", described->descriptors._buffer[1].name, described->descriptors._buffer[1].type);
  rcl_interfaces_srv_ListParametersRequest all;
  memset(&all, 0, sizeof all);
  const rcl_interfaces_srv_ListParametersResponse* listed =
      called("list",
             CLIENT("hunav_agent_manager/list_parameters", rcl_interfaces, "ListParameters",
                    ListParametersRequest, ListParametersResponse),
             &all);
  for (uint32_t i = 0; i < listed->result.names._length; ++i) {
    printf(" %s", listed->result.names._buffer[i]);
  }
  putchar('\n');
  rcl_interfaces_msg_Parameter parameter;
  memset(&parameter, 0, sizeof parameter);
  parameter.name = "publish_tf";
  parameter.value.type = 1;
  parameter.value.string_value = "";
  rcl_interfaces_srv_SetParametersRequest set;
  memset(&set, 0, sizeof set);
  set.parameters._length = set.parameters._maximum = 1;
  set.parameters._buffer = &parameter;
  const rcl_interfaces_srv_SetParametersResponse* results =
      called("set",
             CLIENT("hunav_agent_manager/set_parameters", rcl_interfaces, "SetParameters",
                    SetParametersRequest, SetParametersResponse),
             &set);
  printf(" %d\n", results->results._buffer[0].successful);
  parameter.name = "no_such_thing";
  const rcl_interfaces_srv_SetParametersAtomicallyResponse* result =
      called("set_atomically",
             CLIENT("hunav_agent_manager/set_parameters_atomically", rcl_interfaces,
                    "SetParametersAtomically", SetParametersRequest, SetParametersAtomicallyResponse),
             &set);
  printf(" %d %d\n", result->result.successful, result->result.reason[0] != '\0');
}

int main(int argc, char** argv) {
  if (argc != 2) {
    return 64;
  }
  const dds_entity_t participant = peerParticipant(argv[1]);
  callLoader(participant);
  callManager(participant);
  callParameters(participant);
  dds_delete(participant);
  return 0;
}
