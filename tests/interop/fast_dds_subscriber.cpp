// SPDX-License-Identifier: BSD-3-Clause
// A subscriber of another vendor's: prints a line for every segment list that it receives.
// Usage: fast_dds_subscriber DOMAIN SENSOR COUNT   (exit 0 after COUNT lists, 1 after 60 s without)
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <cstdint>
#include <iostream>
#include <string>

#include "cleave_v1PubSubTypes.h"
#include "tests/interop/fast_dds_on_loopback.hpp"

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

fast::DataReader* open_reader(fast::DomainParticipant& participant, const std::string& sensor) {
  const auto type = cleave::test::plain_type<cleave::v1::SegmentListPubSubType>(participant);
  auto* const topic = participant.create_topic("cleave/" + sensor + "/segments",
                                               type.get_type_name(), fast::TOPIC_QOS_DEFAULT);
  auto* const subscriber = participant.create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT);
  fast::DataReaderQos qos;
  qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
  qos.history().depth = 4;
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return subscriber->create_datareader(topic, qos);
}

void print(const cleave::v1::SegmentList& list) {
  std::uint64_t points = 0;
  for (const auto& segment : list.segments()) points += segment.point_count();
  std::cout << list.header().sensor().data() << " frame " << list.header().frame_id()
            << " segments " << list.segments().size() << " borders " << list.borders().size()
            << " points " << points << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto domain = static_cast<std::uint32_t>(std::stoul(argv[1]));
  auto* const factory = fast::DomainParticipantFactory::get_instance();
  fast::DomainParticipant* const participant =
      factory->create_participant(domain, cleave::test::loopback_qos(domain));
  if (participant == nullptr) return 1;
  fast::DataReader* const reader = open_reader(*participant, argv[2]);

  int left = std::stoi(argv[3]);
  while (left > 0 && reader->wait_for_unread_message({60, 0})) {
    cleave::v1::SegmentList list;
    fast::SampleInfo info;
    while (left > 0 && reader->take_next_sample(&list, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      print(list);
      --left;
    }
  }
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return left == 0 ? 0 : 1;
}
