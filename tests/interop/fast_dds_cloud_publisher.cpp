// SPDX-License-Identifier: BSD-3-Clause
// A camera of another vendor's DDS: publishes clouds of 80 x 60 points, ten a second, over the
// network, once somebody reads them. Usage: fast_dds_cloud_publisher DOMAIN SENSOR COUNT
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "cleave_v1PubSubTypes.h"
#include "tests/integration/support/small_clouds.hpp"
#include "tests/interop/fast_dds_on_loopback.hpp"

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

constexpr std::uint32_t bulk_domain_offset =
    100;  // clouds and label maps have a domain of their own

fast::DataWriter* open_writer(fast::DomainParticipant& participant, const std::string& sensor) {
  const auto type = cleave::test::plain_type<cleave::v1::DepthCloudPubSubType>(participant);
  auto* const topic = participant.create_topic("cleave/" + sensor + "/cloud", type.get_type_name(),
                                               fast::TOPIC_QOS_DEFAULT);
  auto* const publisher = participant.create_publisher(fast::PUBLISHER_QOS_DEFAULT);
  fast::DataWriterQos qos;
  qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = fast::VOLATILE_DURABILITY_QOS;
  qos.liveliness().lease_duration = {1, 0};
  qos.liveliness().announcement_period = {0, 300'000'000};
  qos.history().depth = 2;
  qos.publish_mode().kind = fast::ASYNCHRONOUS_PUBLISH_MODE;  // 3.7 MB go in many pieces
  qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return publisher->create_datawriter(topic, qos);
}

std::int64_t now_ns(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void describe(cleave::v1::FrameHeader& header, const std::string& sensor) {
  header.width(80);
  header.height(60);
  std::ranges::copy(sensor, header.sensor().begin());
  std::ranges::copy(sensor + "_optical", header.coordinate_frame().begin());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::uint32_t domain = static_cast<std::uint32_t>(std::stoul(argv[1])) + bulk_domain_offset;
  auto* const factory = fast::DomainParticipantFactory::get_instance();
  fast::DomainParticipant* const participant =
      factory->create_participant(domain, cleave::test::loopback_qos(domain));
  if (participant == nullptr) return 1;
  fast::DataWriter* const writer = open_writer(*participant, argv[2]);
  if (writer == nullptr) return 1;

  using namespace std::chrono_literals;
  fast::PublicationMatchedStatus matched;
  while (matched.current_count == 0) {
    std::this_thread::sleep_for(10ms);
    writer->get_publication_matched_status(matched);
  }
  const auto cloud = std::make_unique<cleave::v1::DepthCloud>();
  describe(cloud->header(), argv[2]);
  std::ranges::copy(cleave::test::corner_points(80, 60), cloud->xyz().begin());
  for (std::uint64_t id = 1; id <= std::stoull(argv[3]); ++id) {
    cloud->header().frame_id(id);
    cloud->header().capture_time_ns(now_ns(CLOCK_REALTIME));
    cloud->header().arrival_time_ns(now_ns(CLOCK_MONOTONIC));
    cloud->header().publication_time_ns(now_ns(CLOCK_MONOTONIC));
    if (!writer->write(cloud.get())) return 1;
    std::this_thread::sleep_for(100ms);
  }
  writer->wait_for_acknowledgments({5, 0});
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return 0;
}
