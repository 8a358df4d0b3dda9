// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/dds.hpp"

#include <array>

namespace cleave::dds {

Qos qos_of(const Topic& topic, int depth) {
  Qos qos(dds_create_qos());
  // Not the standard's default of 100 ms: defaults are left out of discovery, and some clients
  // (@foxglove/rtps) refuse an endpoint without them.
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_MSECS(50));
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_durability(
      qos.get(), topic.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, DDS_SECS(1));
  return qos;
}

const char* policy_name(std::uint32_t policy_id) {
  static constexpr std::array names = {"none",
                                       "user data",
                                       "durability",
                                       "presentation",
                                       "deadline",
                                       "latency budget",
                                       "ownership",
                                       "ownership strength",
                                       "liveliness",
                                       "time-based filter",
                                       "partition",
                                       "reliability",
                                       "destination order",
                                       "history",
                                       "resource limits",
                                       "entity factory",
                                       "writer data lifecycle",
                                       "reader data lifecycle",
                                       "topic data",
                                       "group data",
                                       "transport priority",
                                       "lifespan",
                                       "durability service",
                                       "property",
                                       "type consistency",
                                       "data representation"};
  static_assert(names.size() == DDS_DATA_REPRESENTATION_QOS_POLICY_ID + 1);
  return policy_id < names.size() ? names.at(policy_id) : "unknown";
}

dds_entity_t participant_of(const Stream& stream, const Topic& topic) {
  return topic.domain == Domain::bulk ? stream.bulk_participant() : stream.public_participant();
}

Entity create_topic(dds_entity_t participant, const Topic& topic) {
  return {dds_create_topic(participant, topic.descriptor, topic.name.c_str(), nullptr, nullptr),
          "cannot create topic " + topic.name};
}

}  // namespace cleave::dds
