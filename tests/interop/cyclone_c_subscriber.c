/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A client of Cyclone DDS's plain C API and idlc's types, with nothing of Cleave's but the
 * contract: prints a line for every segment list, and one for every node's first status. Usage:
 * cyclone_c_subscriber DOMAIN SENSOR COUNT   (exit 0 after COUNT lists, 1 after 60 s without)
 */
#include <dds/dds.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "cleave_v1.h"

/* Loopback without multicast: found by asking the ports of up to 60 processes. */
static const char configuration[] =
    "<CycloneDDS><Domain id=\"any\"><General><Interfaces>"
    "<NetworkInterface name=\"lo\" multicast=\"false\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

static dds_entity_t open_reader(dds_entity_t participant, const dds_topic_descriptor_t* type,
                                const char* name, int depth, dds_durability_kind_t durability) {
  dds_qos_t* const qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(50));
  dds_qset_durability(qos, durability);
  dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_SECS(1));
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  const dds_entity_t topic = dds_create_topic(participant, type, name, NULL, NULL);
  const dds_entity_t reader = topic < 0 ? topic : dds_create_reader(participant, topic, qos, NULL);
  dds_delete_qos(qos);
  return reader;
}

static void print_list(const cleave_v1_SegmentList* list) {
  uint64_t points = 0;
  for (uint32_t i = 0; i < list->segments._length; ++i) {
    points += list->segments._buffer[i].point_count;
  }
  printf("%s frame %" PRIu64 " segments %u borders %u points %" PRIu64 "\n", list->header.sensor,
         list->header.frame_id, list->segments._length, list->borders._length, points);
}

static void print_status(const cleave_v1_NodeStatus* status) {
  printf("%s of contract %s is process %u\n", status->node, status->contract, status->process_id);
}

/* 1 where a sample came. */
static int take_list(dds_entity_t reader) {
  void* sample = NULL;
  dds_sample_info_t info;
  const dds_return_t count = dds_take(reader, &sample, &info, 1, 1);
  if (count <= 0) return 0;
  if (info.valid_data) print_list(sample);
  (void)dds_return_loan(reader, &sample, count);
  return info.valid_data ? 1 : 0;
}

static void take_statuses(dds_entity_t reader) {
  void* sample = NULL;
  dds_sample_info_t info;
  dds_return_t count;
  while ((count = dds_take(reader, &sample, &info, 1, 1)) > 0) {
    if (info.valid_data && info.view_state == DDS_VST_NEW) print_status(sample);
    (void)dds_return_loan(reader, &sample, count);
    sample = NULL;
  }
}

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const dds_domainid_t domain = (dds_domainid_t)strtoul(argv[1], NULL, 10);
  char topic[128];
  if (snprintf(topic, sizeof topic, "cleave/%s/segments", argv[2]) >= (int)sizeof topic) return 2;
  if (dds_create_domain(domain, configuration) < 0) return 1;
  const dds_entity_t participant = dds_create_participant(domain, NULL, NULL);
  if (participant < 0) return 1;
  const dds_entity_t lists =
      open_reader(participant, &cleave_v1_SegmentList_desc, topic, 4, DDS_DURABILITY_VOLATILE);
  const dds_entity_t statuses = open_reader(participant, &cleave_v1_NodeStatus_desc,
                                            "cleave/status", 1, DDS_DURABILITY_TRANSIENT_LOCAL);
  if (lists < 0 || statuses < 0) return 1;
  (void)dds_set_status_mask(lists, DDS_DATA_AVAILABLE_STATUS);
  const dds_entity_t waiting = dds_create_waitset(participant);
  (void)dds_waitset_attach(waiting, lists, 0);

  long left = strtol(argv[3], NULL, 10);
  while (left > 0 && dds_waitset_wait(waiting, NULL, 0, DDS_SECS(60)) > 0) {
    while (left > 0 && take_list(lists)) --left;
  }
  take_statuses(statuses);
  (void)dds_delete(DDS_CYCLONEDDS_HANDLE);
  return left == 0 ? 0 : 1;
}
