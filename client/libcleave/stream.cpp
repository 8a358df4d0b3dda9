// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/stream.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "idl/interface_name.hpp"
#include "libcleave/internal/dds.hpp"
#include "libcleave/internal/dds_log.hpp"
#include "libcleave/internal/own_interface.hpp"
#include "libcleave/internal/roudi/roudi_access.hpp"
#include "libcleave/internal/roudi/roudi_post.hpp"
#include "libcleave/types.hpp"

namespace cleave {
namespace {

constexpr std::uint32_t bulk_domain_offset = 100;
constexpr std::uint32_t max_domain = 99;

// Discovery by unicast between the processes of this machine; on another interface, by multicast.
std::string network_xml(const std::string& interface, const std::string& largest_sample) {
  const bool loopback = interface == "lo" || interface == "127.0.0.1";
  std::string xml = "<General><Interfaces><NetworkInterface ";
  xml += interface.find_first_not_of("0123456789.") == std::string::npos ? "address" : "name";
  xml += "=\"" + interface + "\"";
  xml += loopback ? " multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast>"
                  : "/></Interfaces>";
  // Large fragments: with the default ones a cloud of 3.7 MB loses pieces over loopback.
  xml +=
      "<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>65000B</FragmentSize></General>"
      "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
      "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>";
  if (loopback) xml += "<Peers><Peer address=\"127.0.0.1\"/></Peers>";
  xml +=
      "</Discovery><Internal><SocketReceiveBufferSize min=\"default\" max=\"4MB\"/>"
      // Larger ones are dropped at their first fragment, with a warning.
      "<MaxSampleSize>" +
      largest_sample +
      "</MaxSampleSize></Internal>"
      // Every QoS is announced: there are clients that do not know what a missing one means.
      "<Compatibility><ExplicitlyPublishQosSetToDefault>true</ExplicitlyPublishQosSetToDefault>"
      "</Compatibility>";
  return xml;
}

std::string shared_memory_xml(bool enabled, std::uint32_t domain) {
  if (!enabled) return "<SharedMemory><Enable>false</Enable></SharedMemory>";
  return "<SharedMemory><Enable>true</Enable><Prefix>CLEAVE_D" + std::to_string(domain) +
         "</Prefix><LogLevel>error</LogLevel></SharedMemory>";
}

// Lists and statuses are smaller by far; a large cloud is not.
constexpr char largest_public_sample[] = "4MB";
constexpr char largest_bulk_sample[] = "32MB";

dds::Entity open_domain(std::uint32_t id, const std::string& interface,
                        const std::string& largest_sample, bool shared_memory) {
  const std::string xml = "<CycloneDDS xmlns=\"https://cdds.io/config\"><Domain id=\"any\">" +
                          network_xml(interface, largest_sample) +
                          shared_memory_xml(shared_memory, id) + "</Domain></CycloneDDS>";
  return {dds_create_domain(id, xml.c_str()),
          "cannot open DDS domain " + std::to_string(id) + " on interface '" + interface +
              "' (does the interface exist? `ip address` lists them)"};
}

dds::Entity join(std::uint32_t id) {
  return {dds_create_participant(id, nullptr, nullptr),
          "cannot join DDS domain " + std::to_string(id) +
              " (more than 60 processes on it, or its UDP ports are taken)"};
}

// What every sensor's frames fit into. Whether there are chunks for the large types, too, is asked
// when the first is to be published.
constexpr std::uint32_t small_sample = std::max(sizeof(DepthCloud), sizeof(LabelMap));

// A busy machine's RouDi may take a moment.
constexpr std::chrono::seconds roudi_patience(2);

std::string why_no_shared_memory() {
  std::string obstacle = obstacle_to_joining(roudi_patience);
  if (!obstacle.empty()) return obstacle;
  (void)sign_off_the_dead();
  join_roudi();
  return may_write_to_roudi() ? obstacle_of_pools(small_sample) : "";
}

}  // namespace

StreamOptions with_environment(StreamOptions options) {
  if (const char* const interface = std::getenv("CLEAVE_INTERFACE")) {
    if (!is_interface_name(interface)) {
      throw std::invalid_argument(
          "CLEAVE_INTERFACE: expected the name or address of a network "
          "interface, found '" +
          std::string(interface) + "'");
    }
    options.public_interface = interface;
  }
  const char* const text = std::getenv("CLEAVE_DOMAIN");
  if (text == nullptr) return options;
  const char* const end = text + std::strlen(text);
  const auto [last, error] = std::from_chars(text, end, options.domain);
  if (error != std::errc{} || last != end || options.domain > max_domain) {
    throw std::invalid_argument("CLEAVE_DOMAIN: expected a number from 0 to 99, found '" +
                                std::string(text) + "'");
  }
  return options;
}

struct Stream::State {
  StreamOptions options;
  Transport transport = Transport::network;
  std::string reason;
  dds::Entity bulk_domain, public_domain;  // destroyed after their participants
  dds::Entity bulk_participant, public_participant;
};

Stream::Stream(const StreamOptions& options) : state_(std::make_unique<State>()) {
  if (options.domain > max_domain) {
    throw std::runtime_error("domain " + std::to_string(options.domain) + " is not from 0 to 99");
  }
  if (!is_interface_name(options.public_interface)) {
    throw std::runtime_error("'" + options.public_interface +
                             "' is no name or address of a network interface");
  }
  State& s = *state_;
  s.options = options;
  if (!options.shared_memory) {
    s.reason = "switched off by configuration";
  } else if (s.reason = why_no_shared_memory(); !s.reason.empty()) {
    spdlog::warn("no shared memory, clouds and label maps are copied over the network: {}",
                 s.reason);
  } else {
    s.transport = Transport::shared_memory;
    s.reason = "RouDi answers";
    if (roudi_drops_suspended()) {
      spdlog::warn(
          "RouDi drops who is suspended for more than 1.5 s, and iceoryx then ends them: start it "
          "with `-m off`");
    }
  }
  const std::uint32_t bulk = options.domain + bulk_domain_offset;
  dds::log_through_ours();
  s.bulk_domain =
      open_domain(bulk, "lo", largest_bulk_sample, s.transport == Transport::shared_memory);
  s.public_domain =
      open_domain(options.domain, options.public_interface, largest_public_sample, false);
  s.bulk_participant = join(bulk);
  s.public_participant = join(options.domain);
  hear_only("lo", bulk);
  hear_only(options.public_interface, options.domain);
}

Stream::~Stream() = default;

Transport Stream::transport() const {
  return state_->transport;
}
const std::string& Stream::transport_reason() const {
  return state_->reason;
}
const StreamOptions& Stream::options() const {
  return state_->options;
}
std::int32_t Stream::bulk_participant() const {
  return state_->bulk_participant.get();
}
std::int32_t Stream::public_participant() const {
  return state_->public_participant.get();
}

}  // namespace cleave
