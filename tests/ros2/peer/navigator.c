/* cyclone_navigator DOMAIN [best_effort]: Nav2's action navigate_to_pose for a robot that is driven by /cmd_vel:
   takes a goal, turns and drives towards it by /odom, says that it has succeeded. Prints "ready" when the
   robot is met, "goal X Y", "arrived X Y" and, when its input ends, "cancels N". Its
   commands are reliable, or best effort. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "peer.h"

enum { kSucceeded = 4 };

typedef struct {
  PeerService send, result, cancel;
  dds_entity_t odometry, commands;
  bool hasGoal, isArrived, isAsked;
  double x, y;
  nav2_msgs_action_GetResultRequest asked; /* for the result */
  int cancels;
} Navigator;

static PeerService serverOf(dds_entity_t participant, const char* part, const char* type,
                            const dds_topic_descriptor_t* request,
                            const dds_topic_descriptor_t* response) {
  char service[128];
  snprintf(service, sizeof service, "navigate_to_pose/_action/%s", part);
  return peerServer(participant, service, type, request, response);
}

static void takeGoals(Navigator* self) {
  void* sample = NULL;
  dds_sample_info_t info;
  while (dds_take(self->send.reader, &sample, &info, 1, 1) > 0) {
    const nav2_msgs_action_SendGoalRequest* goal = sample;
    if (info.valid_data) {
      nav2_msgs_action_SendGoalResponse response;
      memset(&response, 0, sizeof response);
      response.guid = goal->guid;
      response.seq = goal->seq;
      response.accepted = true;
      self->x = goal->pose.pose.position.x;
      self->y = goal->pose.pose.position.y;
      self->hasGoal = true;
      self->isArrived = false;
      printf("goal %.6f %.6f %s\n", self->x, self->y, goal->pose.header.frame_id);
      fflush(stdout);
      dds_write(self->send.writer, &response);
    }
    dds_return_loan(self->send.reader, &sample, 1);
    sample = NULL;
  }
  while (dds_take(self->result.reader, &sample, &info, 1, 1) > 0) {
    if (info.valid_data) {
      self->asked = *(const nav2_msgs_action_GetResultRequest*)sample;
      self->isAsked = true;
    }
    dds_return_loan(self->result.reader, &sample, 1);
    sample = NULL;
  }
  while (dds_take(self->cancel.reader, &sample, &info, 1, 1) > 0) {
    const action_msgs_srv_CancelGoalRequest* wanted = sample;
    if (info.valid_data) {
      action_msgs_srv_CancelGoalResponse response;
      memset(&response, 0, sizeof response);
      response.guid = wanted->guid;
      response.seq = wanted->seq;
      dds_write(self->cancel.writer, &response);
      self->hasGoal = false;
      ++self->cancels;
    }
    dds_return_loan(self->cancel.reader, &sample, 1);
    sample = NULL;
  }
}

/* The odometry begins at the origin with the heading of the start: in these tests map and odom are
   one. */
static void drive(Navigator* self, const nav_msgs_msg_Odometry* odometry) {
  const geometry_msgs_msg_Pose* pose = &odometry->pose.pose;
  const double yaw = 2.0 * atan2(pose->orientation.z, pose->orientation.w);
  const double dx = self->x - pose->position.x;
  const double dy = self->y - pose->position.y;
  const double turn = remainder(atan2(dy, dx) - yaw, 2.0 * M_PI);
  geometry_msgs_msg_Twist command;
  memset(&command, 0, sizeof command);
  self->isArrived = self->isArrived || hypot(dx, dy) < 0.15;
  if (self->hasGoal && !self->isArrived) {
    command.linear.x = fabs(turn) < 0.5 ? fmin(0.5, hypot(dx, dy)) : 0.0;
    command.angular.z = fmax(-1.0, fmin(1.0, 2.0 * turn));
  }
  dds_write(self->commands, &command);
  if (self->isArrived && self->isAsked) {
    nav2_msgs_action_GetResultResponse response;
    memset(&response, 0, sizeof response);
    response.guid = self->asked.guid;
    response.seq = self->asked.seq;
    response.status = kSucceeded;
    dds_write(self->result.writer, &response);
    self->isAsked = false;
    printf("arrived %.3f %.3f\n", pose->position.x, pose->position.y);
    fflush(stdout);
  }
}

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    return 64;
  }
  const dds_entity_t participant = peerParticipant(argv[1]);
  const PeerQos plain = {true, false, 10};
  const PeerQos ofCommands = {argc == 2 || strcmp(argv[2], "best_effort") != 0, false, 10};
  Navigator self;
  memset(&self, 0, sizeof self);
  self.send = serverOf(participant, "send_goal", "nav2_msgs::action::dds_::NavigateToPose_SendGoal",
                       &nav2_msgs_action_SendGoalRequest_desc, &nav2_msgs_action_SendGoalResponse_desc);
  self.result =
      serverOf(participant, "get_result", "nav2_msgs::action::dds_::NavigateToPose_GetResult",
               &nav2_msgs_action_GetResultRequest_desc, &nav2_msgs_action_GetResultResponse_desc);
  self.cancel = serverOf(participant, "cancel_goal", "action_msgs::srv::dds_::CancelGoal",
                         &action_msgs_srv_CancelGoalRequest_desc,
                         &action_msgs_srv_CancelGoalResponse_desc);
  self.odometry = peerReader(participant, &nav_msgs_msg_Odometry_desc,
                             "nav_msgs::msg::dds_::Odometry_", "rt/odom", plain);
  self.commands = peerWriter(participant, &geometry_msgs_msg_Twist_desc,
                             "geometry_msgs::msg::dds_::Twist_", "rt/cmd_vel", ofCommands);
  bool isReady = false;
  while (!peerIsToEnd()) {
    void* sample = NULL;
    dds_sample_info_t info;
    if (!isReady && peerWriters(self.odometry) > 0 && peerReaders(self.commands) > 0 &&
        peerWriters(self.send.reader) > 0 && peerReaders(self.send.writer) > 0) {
      isReady = true;
      puts("ready");
      fflush(stdout);
    }
    takeGoals(&self);
    while (dds_take(self.odometry, &sample, &info, 1, 1) > 0) {
      if (info.valid_data) {
        drive(&self, sample);
      }
      dds_return_loan(self.odometry, &sample, 1);
      sample = NULL;
    }
    dds_sleepfor(DDS_MSECS(1));
  }
  printf("cancels %d\n", self.cancels);
  dds_delete(participant);
  return 0;
}
