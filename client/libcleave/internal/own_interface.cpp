// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/own_interface.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/filter.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace cleave {
namespace {

// The ports of a domain by the RTPS standard: two for multicast, then from 10 on two a participant.
constexpr std::uint32_t first_port = 7400;
constexpr std::uint32_t ports_a_domain = 250;

// 0: there is none.
std::uint32_t index_of(const std::string& interface) {
  in_addr address{};
  if (::inet_pton(AF_INET, interface.c_str(), &address) != 1) {
    return ::if_nametoindex(interface.c_str());
  }
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return 0;
  std::uint32_t index = 0;
  for (const ifaddrs* i = all; i != nullptr; i = i->ifa_next) {
    if (i->ifa_addr == nullptr || i->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in own{};
    std::memcpy(&own, i->ifa_addr, sizeof own);
    if (own.sin_addr.s_addr == address.s_addr) index = ::if_nametoindex(i->ifa_name);
  }
  ::freeifaddrs(all);
  return index;
}

// 0: no UDP socket over IPv4, or not bound.
std::uint32_t udp_port(int descriptor) {
  int type = 0;
  socklen_t length = sizeof type;
  if (::getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &length) != 0 || type != SOCK_DGRAM) {
    return 0;
  }
  sockaddr_storage bound{};
  length = sizeof bound;
  if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&bound), &length) != 0) return 0;
  if (bound.ss_family != AF_INET) return 0;
  sockaddr_in address{};
  std::memcpy(&address, &bound, sizeof address);
  return ntohs(address.sin_port);
}

std::vector<int> sockets_of(std::uint32_t domain) {
  const std::uint32_t first = first_port + ports_a_domain * domain;
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const std::string name = entry.path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    const std::uint32_t port = udp_port(descriptor);
    if (port >= first && port < first + ports_a_domain) found.push_back(descriptor);
  }
  return found;
}

bool attach_filter(int descriptor, std::uint32_t own, std::uint32_t loopback) {
  constexpr auto arriving_at = static_cast<std::uint32_t>(SKF_AD_OFF + SKF_AD_IFINDEX);
  constexpr std::uint32_t all_bytes = 0xffffffff;
  std::array<sock_filter, 5> code{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, arriving_at),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 1, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, loopback, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, all_bytes),
      BPF_STMT(BPF_RET | BPF_K, 0),
  }};
  const sock_fprog program{code.size(), code.data()};
  return ::setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

}  // namespace

void hear_only(const std::string& interface, std::uint32_t domain) {
  const std::string task =
      "cannot keep DDS domain " + std::to_string(domain) + " to interface '" + interface + "': ";
  const std::uint32_t own = index_of(interface);
  const std::uint32_t loopback = ::if_nametoindex("lo");
  if (own == 0 || loopback == 0) throw std::runtime_error(task + "it or 'lo' is not there");
  const std::vector<int> sockets = sockets_of(domain);
  if (sockets.empty()) throw std::runtime_error(task + "its sockets are not at the usual ports");
  for (const int descriptor : sockets) {
    if (!attach_filter(descriptor, own, loopback)) {
      throw std::runtime_error(task + "no filter on its socket: " + std::strerror(errno));
    }
  }
}

}  // namespace cleave
