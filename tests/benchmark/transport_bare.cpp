// SPDX-License-Identifier: BSD-3-Clause
// The same with Cyclone DDS alone: a loan, dds_takecdr, and nothing else. See transport.hpp.
#include <dds/dds.h>
#include <dds/ddsc/dds_loan_api.h>
#include <dds/ddsi/ddsi_serdata.h>

#include "tests/benchmark/transport.hpp"

namespace {

using namespace cleave;
using namespace cleave::benchmark;

constexpr dds_domainid_t domain = 220;  // not Cleave's, with a prefix of its own
constexpr char configuration[] =
    "<CycloneDDS><Domain id=\"any\"><General><Interfaces><NetworkInterface name=\"lo\" "
    "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>60"
    "</MaxAutoParticipantIndex><Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>"
    "<SharedMemory><Enable>true</Enable><Prefix>BARE</Prefix><LogLevel>error</LogLevel>"
    "</SharedMemory></Domain></CycloneDDS>";

unsigned matched(dds_entity_t writer) {
  dds_publication_matched_status_t status;
  return dds_get_publication_matched_status(writer, &status) == 0 ? status.current_count : 0;
}

int write(dds_entity_t writer, const TransportRole& role) {
  while (matched(writer) < role.readers) std::this_thread::sleep_for(transport_period);
  std::this_thread::sleep_for(connecting);
  for (int id = 0; id < role.clouds; ++id) {
    void* cloud = nullptr;
    if (dds_loan_sample(writer, &cloud) != DDS_RETCODE_OK) return 1;
    stamp(*static_cast<DepthCloud*>(cloud), id);
    if (dds_write(writer, cloud) != DDS_RETCODE_OK) return 1;
    std::this_thread::sleep_for(transport_period);
  }
  std::this_thread::sleep_for(connecting);
  return 0;
}

int read(dds_entity_t participant, dds_entity_t reader, const TransportRole& role) {
  const dds_entity_t wait_set = dds_create_waitset(participant);
  dds_waitset_attach(wait_set, dds_create_readcondition(reader, DDS_ANY_STATE), 0);
  int left = role.clouds;
  while (left > 0) {
    const auto silence = DDS_SECS(transport_silence.count());
    if (dds_waitset_wait(wait_set, nullptr, 0, silence) <= 0) break;
    ddsi_serdata* sample = nullptr;
    dds_sample_info_t info;
    while (dds_takecdr(reader, &sample, 1, &info, DDS_ANY_STATE) > 0) {
      if (info.valid_data && sample->iox_chunk != nullptr) {
        say_latency(*static_cast<const DepthCloud*>(sample->iox_chunk));
        --left;
      }
      ddsi_serdata_unref(sample);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto role = transport_role(argc, argv);
  if (!role) return 2;
  if (dds_create_domain(domain, configuration) < 0) return 1;
  const dds_entity_t participant = dds_create_participant(domain, nullptr, nullptr);
  const dds_entity_t topic =
      dds_create_topic(participant, &cleave_v1_DepthCloud_desc, "bare", nullptr, nullptr);
  dds_qos_t* const qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 2);
  if (role->writes) return write(dds_create_writer(participant, topic, qos, nullptr), *role);
  return read(participant, dds_create_reader(participant, topic, qos, nullptr), *role);
}
