/* A client of compute_agents and subscriber of human_states.
   cyclone_compute DOMAIN CALLS: one agent (id 1) walks along x with 20 steps a second; prints one line
   "answer K X VX FRAME" per call and "states K X" per sample of human_states. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "peer.h"

static void fillAgent(hunav_msgs_msg_Agent* agent, int id, int type, char* name) {
  memset(agent, 0, sizeof *agent);
  agent->id = id;
  agent->type = (uint8_t)type;
  agent->name = name;
  agent->group_id = -1;
  agent->position.orientation.w = 1.0;
  agent->desired_velocity = 1.5F;
  agent->radius = 0.4F;
  agent->goal_radius = 0.3F;
  agent->behavior.type = 1;
  agent->behavior.social_force_factor = 5.0F;
  agent->behavior.goal_force_factor = 2.0F;
  agent->behavior.obstacle_force_factor = 10.0F;
  agent->behavior.other_force_factor = 20.0F;
}

int main(int argc, char** argv) {
  if (argc != 3) {
    return 64;
  }
  const int calls = atoi(argv[2]);
  const dds_entity_t participant = peerParticipant(argv[1]);
  const PeerService service = peerClient(
      participant, "compute_agents", "hunav_msgs::srv::dds_::ComputeAgents",
      &hunav_msgs_srv_ComputeAgentsRequest_desc, &hunav_msgs_srv_ComputeAgentsResponse_desc);
  const dds_entity_t writer = service.writer;
  const dds_entity_t reader = service.reader;
  const PeerQos plain = {true, false, 10};
  const dds_entity_t states = peerReader(participant, &hunav_msgs_msg_Agents_desc,
                                         "hunav_msgs::msg::dds_::Agents_", "rt/human_states", plain);
  for (int wait = 0; wait < 2000 && (peerReaders(writer) == 0 || peerWriters(reader) == 0 ||
                                     peerWriters(states) == 0);
       ++wait) {
    dds_sleepfor(DDS_MSECS(10));
  }
  dds_sleepfor(DDS_MSECS(500)); /* the other side sees both ends a little later */

  hunav_msgs_srv_ComputeAgentsRequest asked;
  memset(&asked, 0, sizeof asked);
  hunav_msgs_msg_Agent person;
  geometry_msgs_msg_Pose goal;
  memset(&goal, 0, sizeof goal);
  goal.position.x = 5.0;
  goal.orientation.w = 1.0;
  fillAgent(&person, 1, 1, "anna");
  person.goals._length = person.goals._maximum = 1;
  person.goals._buffer = &goal;
  fillAgent(&asked.robot, 0, 0, "");
  asked.current_agents.header.frame_id = "map";
  asked.current_agents.agents._length = asked.current_agents.agents._maximum = 1;
  asked.current_agents.agents._buffer = &person;
  asked.guid = 0x1122334455667788ULL;
  int answers = 0;
  for (int call = 0; call < calls; ++call) {
    asked.seq = call + 1;
    asked.current_agents.header.stamp.sec = 100 + call / 20;
    asked.current_agents.header.stamp.nanosec = (unsigned)(call % 20) * 50000000U;
    dds_write(writer, &asked);
    int isAnswered = 0;
    for (int wait = 0; wait < 5000 && !isAnswered; ++wait) {
      void* sample = NULL;
      dds_sample_info_t info;
      while (!isAnswered && dds_take(reader, &sample, &info, 1, 1) > 0) {
        const hunav_msgs_srv_ComputeAgentsResponse* reply = sample;
        if (info.valid_data && reply->guid == asked.guid && reply->seq == asked.seq &&
            reply->updated_agents.agents._length == 1) {
          const hunav_msgs_msg_Agent* moved = &reply->updated_agents.agents._buffer[0];
          person.position = moved->position;
          person.velocity = moved->velocity;
          person.yaw = moved->yaw;
          printf("answer %d %.9f %.9f %s\n", call + 1, moved->position.position.x,
                 moved->velocity.linear.x, reply->updated_agents.header.frame_id);
          isAnswered = 1;
          ++answers;
        }
        dds_return_loan(reader, &sample, 1);
      }
      if (!isAnswered) {
        dds_sleepfor(DDS_MSECS(1));
      }
    }
    void* sample = NULL;
    dds_sample_info_t info;
    dds_sleepfor(DDS_MSECS(5));
    while (dds_take(states, &sample, &info, 1, 1) > 0) {
      const hunav_msgs_msg_Agents* seen = sample;
      if (info.valid_data && seen->agents._length == 1) {
        printf("states %d %.9f\n", call + 1, seen->agents._buffer[0].position.position.x);
      }
      dds_return_loan(states, &sample, 1);
    }
  }
  dds_delete(participant);
  return answers == calls ? 0 : 1;
}
