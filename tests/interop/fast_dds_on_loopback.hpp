// SPDX-License-Identifier: BSD-3-Clause
// What Fast DDS needs to be told to meet Cleave on its own machine.
#pragma once

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <cstdint>
#include <memory>

namespace cleave::test {

// Loopback only, and the ports of the first 60 participants as peers: Cleave's domains do not use
// multicast on loopback.
inline eprosima::fastdds::dds::DomainParticipantQos loopback_qos(std::uint32_t domain) {
  eprosima::fastdds::dds::DomainParticipantQos qos;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList.emplace_back("127.0.0.1");
  udp->maxInitialPeersRange = 60;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp);
  for (std::uint32_t i = 0; i < 60; ++i) {
    eprosima::fastrtps::rtps::Locator_t peer;
    peer.kind = LOCATOR_KIND_UDPv4;
    eprosima::fastrtps::rtps::IPLocator::setIPv4(peer, "127.0.0.1");
    peer.port = 7410 + 250 * domain + 2 * i;
    qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  }
  return qos;
}

// Cyclone does not understand Fast DDS 2.9's type objects and would refuse the reader or writer.
template <class PubSubType>
eprosima::fastdds::dds::TypeSupport plain_type(
    eprosima::fastdds::dds::DomainParticipant& participant) {
  eprosima::fastdds::dds::TypeSupport type(new PubSubType());
  type->auto_fill_type_information(false);
  type->auto_fill_type_object(false);
  type.register_type(&participant);
  return type;
}

}  // namespace cleave::test
