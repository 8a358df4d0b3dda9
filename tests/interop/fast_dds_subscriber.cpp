// SPDX-License-Identifier: BSD-3-Clause
// A subscriber of another vendor's: prints a line for every segment list that it receives.
// Usage: fast_dds_subscriber DOMAIN SENSOR COUNT   (exit 0 after COUNT lists, 1 after 60 s without)
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <cstdint>
#include <iostream>
#include <memory>
#include <string>

#include "cleave_v1PubSubTypes.h"

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

// Loopback only, and the ports of the first 60 participants as peers: Cleave's domains do not use
// multicast on loopback.
fast::DomainParticipantQos loopback_qos(std::uint32_t domain) {
  fast::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  udp->maxInitialPeersRange = 60;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  for (std::uint32_t i = 0; i < 60; ++i) {
    rtps::Locator_t peer;
    peer.kind = LOCATOR_KIND_UDPv4;
    rtps::IPLocator::setIPv4(peer, "127.0.0.1");
    peer.port = 7410 + 250 * domain + 2 * i;
    qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  }
  return qos;
}

fast::DataReader* open_reader(fast::DomainParticipant& participant, const std::string& sensor) {
  fast::TypeSupport type(new cleave::v1::SegmentListPubSubType());
  // Cyclone does not understand Fast DDS 2.9's type objects and would refuse the reader.
  type->auto_fill_type_information(false);
  type->auto_fill_type_object(false);
  type.register_type(&participant);
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
      factory->create_participant(domain, loopback_qos(domain));
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
