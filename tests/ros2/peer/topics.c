/* cyclone_topics DOMAIN: hears all that a run publishes, in the ways in which nodes of ROS 2 ask for
   it. Prints "ready" when all publishers are met, "kept" when each that is latched has said something,
   "hearing" when each of the others has; when its input ends, one line per topic: "TOPIC COUNT VALUES" with the values of the last message. */
#include <stdio.h>
#include <stdlib.h>

#include "peer.h"

static double seconds(builtin_interfaces_msg_Time stamp) {
  return stamp.sec + 1e-9 * stamp.nanosec;
}
static void sayClock(const void* from) {
  printf("%.9f", seconds(((const rosgraph_msgs_msg_Clock*)from)->clock_));
}
static void sayTransforms(const void* from) {
  const tf2_msgs_msg_TFMessage* all = from;
  for (uint32_t i = 0; i < all->transforms._length; ++i) {
    const geometry_msgs_msg_TransformStamped* each = &all->transforms._buffer[i];
    printf("%s>%s:%.6f,%.6f ", each->header.frame_id, each->child_frame_id,
           each->transform.translation.x, each->transform.translation.y);
  }
}
static void sayMap(const void* from) {
  const nav_msgs_msg_OccupancyGrid* map = from;
  int occupied = 0;
  for (uint32_t i = 0; i < map->data._length; ++i) {
    occupied += map->data._buffer[i] == 100;
  }
  printf("%u %u %.6f %d", map->info.width, map->info.height, map->info.resolution, occupied);
}
static void sayMarkers(const void* from) {
  const visualization_msgs_msg_MarkerArray* all = from;
  printf("%u", all->markers._length);
  for (uint32_t i = 0; i < all->markers._length; ++i) {
    if (all->markers._buffer[i].text[0] != '\0') {
      printf(" %s", all->markers._buffer[i].text);
    }
  }
}
static void sayAgent(const hunav_msgs_msg_Agent* agent) {
  printf("%d %s %.9f %.9f %.6f ", agent->id, agent->name, agent->position.position.x,
         agent->position.position.y, (double)agent->yaw);
}
static void sayAgents(const void* from) {
  const hunav_msgs_msg_Agents* all = from;
  printf("%s ", all->header.frame_id);
  for (uint32_t i = 0; i < all->agents._length; ++i) {
    sayAgent(&all->agents._buffer[i]);
  }
}
static void sayRobot(const void* from) {
  sayAgent(from);
}
static void sayPeople(const void* from) {
  const people_msgs_msg_People* all = from;
  for (uint32_t i = 0; i < all->people._length; ++i) {
    printf("%s %.9f %u ", all->people._buffer[i].name, all->people._buffer[i].position.x,
           all->people._buffer[i].tags._length);
  }
}
static void sayOdometry(const void* from) {
  const nav_msgs_msg_Odometry* odometry = from;
  printf("%s %s %.9f %.9f", odometry->header.frame_id, odometry->child_frame_id,
         odometry->pose.pose.position.x, odometry->twist.twist.linear.x);
}
static void sayScan(const void* from) {
  const sensor_msgs_msg_LaserScan* scan = from;
  printf("%s %u %.6f", scan->header.frame_id, scan->ranges._length, (double)scan->range_max);
}
static void sayPath(const void* from) {
  const nav_msgs_msg_Path* path = from;
  printf("%u", path->poses._length);
  if (path->poses._length > 0) {
    printf(" %.6f", path->poses._buffer[path->poses._length - 1].pose.position.x);
  }
}
static void sayGoal(const void* from) {
  const geometry_msgs_msg_PoseStamped* goal = from;
  printf("%s %.9f %.9f", goal->header.frame_id, goal->pose.position.x, goal->pose.position.y);
}

int main(int argc, char** argv) {
  if (argc != 2) {
    return 64;
  }
  const PeerQos plain = {true, false, 100};
  const PeerQos sensor = {false, false, 5};
  const PeerQos latched = {true, true, 100};
  struct {
    const char *name, *type;
    const dds_topic_descriptor_t* descriptor;
    PeerQos qos;
    void (*say)(const void*);
    dds_entity_t reader;
    int count;
    void* last;
  } topics[] = {
      {"/clock", "rosgraph_msgs::msg::dds_::Clock_", &rosgraph_msgs_msg_Clock_desc, {false, false, 1},
       sayClock, 0, 0, NULL},
      {"/tf", "tf2_msgs::msg::dds_::TFMessage_", &tf2_msgs_msg_TFMessage_desc, plain, sayTransforms,
       0, 0, NULL},
      {"/tf_static", "tf2_msgs::msg::dds_::TFMessage_", &tf2_msgs_msg_TFMessage_desc, latched,
       sayTransforms, 0, 0, NULL},
      {"/map", "nav_msgs::msg::dds_::OccupancyGrid_", &nav_msgs_msg_OccupancyGrid_desc, latched,
       sayMap, 0, 0, NULL},
      {"/obstacles", "visualization_msgs::msg::dds_::MarkerArray_",
       &visualization_msgs_msg_MarkerArray_desc, latched, sayMarkers, 0, 0, NULL},
      {"/markers", "visualization_msgs::msg::dds_::MarkerArray_",
       &visualization_msgs_msg_MarkerArray_desc, plain, sayMarkers, 0, 0, NULL},
      {"/human_states", "hunav_msgs::msg::dds_::Agents_", &hunav_msgs_msg_Agents_desc, plain,
       sayAgents, 0, 0, NULL},
      {"/people", "people_msgs::msg::dds_::People_", &people_msgs_msg_People_desc, plain, sayPeople,
       0, 0, NULL},
      {"/robot_states", "hunav_msgs::msg::dds_::Agent_", &hunav_msgs_msg_Agent_desc, plain, sayRobot,
       0, 0, NULL},
      {"/odom", "nav_msgs::msg::dds_::Odometry_", &nav_msgs_msg_Odometry_desc, plain, sayOdometry, 0,
       0, NULL},
      {"/scan", "sensor_msgs::msg::dds_::LaserScan_", &sensor_msgs_msg_LaserScan_desc, sensor,
       sayScan, 0, 0, NULL},
      {"/plan", "nav_msgs::msg::dds_::Path_", &nav_msgs_msg_Path_desc, latched, sayPath, 0, 0, NULL},
      {"/goal_pose", "geometry_msgs::msg::dds_::PoseStamped_", &geometry_msgs_msg_PoseStamped_desc,
       latched, sayGoal, 0, 0, NULL},
  };
  const int count = (int)(sizeof topics / sizeof *topics);
  const dds_entity_t participant = peerParticipant(argv[1]);
  for (int i = 0; i < count; ++i) {
    char topic[64];
    snprintf(topic, sizeof topic, "rt%s", topics[i].name);
    topics[i].reader =
        peerReader(participant, topics[i].descriptor, topics[i].type, topic, topics[i].qos);
  }
  bool isReady = false;
  bool hasKept = false;
  bool isHearing = false;
  for (bool isOver = false; !isOver;) {
    isOver = peerIsToEnd(); /* and once more, for what is there */
    int met = 0;
    int missing = 0; /* of the latched ones */
    int silent = 0;  /* of the others */
    for (int i = 0; i < count; ++i) {
      void* sample = NULL;
      dds_sample_info_t info;
      met += peerWriters(topics[i].reader) > 0;
      while (dds_take(topics[i].reader, &sample, &info, 1, 1) > 0) {
        if (info.valid_data) {
          if (topics[i].last != NULL) {
            dds_return_loan(topics[i].reader, &topics[i].last, 1);
          }
          topics[i].last = sample;
          ++topics[i].count;
        } else {
          dds_return_loan(topics[i].reader, &sample, 1);
        }
        sample = NULL;
      }
      missing += topics[i].qos.latched && topics[i].count == 0;
      silent += !topics[i].qos.latched && topics[i].count == 0;
    }
    if (!hasKept && missing == 0) {
      hasKept = true;
      puts("kept");
      fflush(stdout);
    }
    if (!isHearing && silent == 0) {
      isHearing = true;
      puts("hearing");
      fflush(stdout);
    }
    if (!isReady && met == count) {
      isReady = true;
      puts("ready");
      fflush(stdout);
    }
    dds_sleepfor(DDS_MSECS(2));
  }
  for (int i = 0; i < count; ++i) {
    printf("%s %d ", topics[i].name, topics[i].count);
    if (topics[i].last != NULL) {
      topics[i].say(topics[i].last);
    }
    putchar('\n');
  }
  dds_delete(participant);
  return 0;
}
