#include "peer.h"

#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const PeerQos kService = {true, false, 10};

static dds_entity_t checked(dds_entity_t made, const char* what) {
  if (made < 0) {
    fprintf(stderr, "%s: %s\n", what, dds_strretcode(-made));
    exit(1);
  }
  return made;
}

dds_entity_t peerParticipant(const char* domain) {
  return checked(dds_create_participant((dds_domainid_t)atoi(domain), NULL, NULL), "participant");
}

static dds_entity_t topicOf(dds_entity_t participant, const dds_topic_descriptor_t* descriptor,
                            const char* type, const char* name) {
  dds_topic_descriptor_t renamed = *descriptor;
  renamed.m_typename = strdup(type); /* stays as long as the program */
  return checked(dds_create_topic(participant, &renamed, name, NULL, NULL), name);
}

static dds_qos_t* qosOf(PeerQos from) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, from.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_SECS(1));
  dds_qset_durability(qos, from.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, from.depth);
  return qos;
}

dds_entity_t peerReader(dds_entity_t participant, const dds_topic_descriptor_t* descriptor,
                        const char* type, const char* topic, PeerQos from) {
  dds_qos_t* qos = qosOf(from);
  const dds_entity_t on = topicOf(participant, descriptor, type, topic);
  const dds_entity_t reader = checked(dds_create_reader(participant, on, qos, NULL), topic);
  dds_delete_qos(qos);
  return reader;
}

dds_entity_t peerWriter(dds_entity_t participant, const dds_topic_descriptor_t* descriptor,
                        const char* type, const char* topic, PeerQos from) {
  dds_qos_t* qos = qosOf(from);
  const dds_entity_t on = topicOf(participant, descriptor, type, topic);
  const dds_entity_t writer = checked(dds_create_writer(participant, on, qos, NULL), topic);
  dds_delete_qos(qos);
  return writer;
}

int peerReaders(dds_entity_t writer) {
  dds_publication_matched_status_t status;
  dds_get_publication_matched_status(writer, &status);
  return (int)status.current_count;
}

int peerWriters(dds_entity_t reader) {
  dds_subscription_matched_status_t status;
  dds_get_subscription_matched_status(reader, &status);
  return (int)status.current_count;
}

enum { kLongest = 256 };

/* "rq/NAMERequest" with "TYPE_Request_", or the same of answers. */
typedef struct {
  char topic[kLongest], type[kLongest];
} EndName;

static EndName requestsOf(const char* service, const char* type) {
  EndName end;
  snprintf(end.topic, sizeof end.topic, "rq/%sRequest", service);
  snprintf(end.type, sizeof end.type, "%s_Request_", type);
  return end;
}

static EndName answersOf(const char* service, const char* type) {
  EndName end;
  snprintf(end.topic, sizeof end.topic, "rr/%sReply", service);
  snprintf(end.type, sizeof end.type, "%s_Response_", type);
  return end;
}

PeerService peerClient(dds_entity_t participant, const char* service, const char* type,
                       const dds_topic_descriptor_t* request,
                       const dds_topic_descriptor_t* response) {
  const EndName out = requestsOf(service, type);
  const EndName in = answersOf(service, type);
  const PeerService made = {
      peerWriter(participant, request, out.type, out.topic, kService),
      peerReader(participant, response, in.type, in.topic, kService),
  };
  return made;
}

PeerService peerServer(dds_entity_t participant, const char* service, const char* type,
                       const dds_topic_descriptor_t* request,
                       const dds_topic_descriptor_t* response) {
  const EndName out = answersOf(service, type);
  const EndName in = requestsOf(service, type);
  const PeerService made = {
      peerWriter(participant, response, out.type, out.topic, kService),
      peerReader(participant, request, in.type, in.topic, kService),
  };
  return made;
}

typedef struct {
  unsigned long long guid;
  long long number;
} CallId;

const void* peerCall(PeerService service, void* request) {
  static long long number = 0;
  CallId* const id = request;
  for (int wait = 0;
       wait < 2000 && (peerReaders(service.writer) == 0 || peerWriters(service.reader) == 0);
       ++wait) {
    dds_sleepfor(DDS_MSECS(10));
  }
  dds_sleepfor(DDS_MSECS(300)); /* the other side sees both ends a little later */
  id->guid = 0x1122334455667788ULL;
  id->number = ++number;
  dds_write(service.writer, request);
  for (int wait = 0; wait < 10000; ++wait) {
    void* sample = NULL;
    dds_sample_info_t info;
    while (dds_take(service.reader, &sample, &info, 1, 1) > 0) {
      const CallId* const answered = sample;
      if (info.valid_data && answered->guid == id->guid && answered->number == id->number) {
        return sample;
      }
      dds_return_loan(service.reader, &sample, 1);
      sample = NULL;
    }
    dds_sleepfor(DDS_MSECS(1));
  }
  return NULL;
}

bool peerIsToEnd(void) {
  struct pollfd input = {0, POLLIN, 0};
  return poll(&input, 1, 0) != 0;
}
