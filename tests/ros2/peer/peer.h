/* Programs on Eclipse Cyclone DDS, as nodes on rmw_cyclonedds would be: nothing of them is ours but
   the names. Errors end the program. */
#ifndef HUNAV_PEER_H
#define HUNAV_PEER_H

#include <stdbool.h>

#include "dds/dds.h"
#include "ros2.h"

typedef struct {
  bool reliable, latched;
  int depth;
} PeerQos;

dds_entity_t peerParticipant(const char* domain);
/* `type`: the name on the wire, "geometry_msgs::msg::dds_::Twist_". */
dds_entity_t peerReader(dds_entity_t participant, const dds_topic_descriptor_t* descriptor,
                        const char* type, const char* topic, PeerQos qos);
dds_entity_t peerWriter(dds_entity_t participant, const dds_topic_descriptor_t* descriptor,
                        const char* type, const char* topic, PeerQos qos);
int peerReaders(dds_entity_t writer); /* that a writer has met */
int peerWriters(dds_entity_t reader); /* that a reader has met */

/* Both ends of a service, for requests or for answers. */
typedef struct {
  dds_entity_t writer, reader;
} PeerService;

/* `service`: "compute_agents"; `type`: "hunav_msgs::srv::dds_::ComputeAgents". */
PeerService peerClient(dds_entity_t participant, const char* service, const char* type,
                       const dds_topic_descriptor_t* request,
                       const dds_topic_descriptor_t* response);
PeerService peerServer(dds_entity_t participant, const char* service, const char* type,
                       const dds_topic_descriptor_t* request,
                       const dds_topic_descriptor_t* response);
/* Waits until a server is met, asks once and returns the answer, a loan of the reader. `request`
   and answer begin with the identity: guid, then number, which are filled in. */
const void* peerCall(PeerService service, void* request);

/* The standard input has ended. */
bool peerIsToEnd(void);

#endif
