// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/sensor_lock.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace cleave {
namespace {

struct Address {
  sockaddr_un address{};
  socklen_t length = 0;
  [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address); }
};

// An abstract name begins with a NUL and is not a file. The longest, with a sensor's 63 characters,
// is 74 of the 107 that fit.
Address address_of(std::uint32_t domain, const std::string& sensor) {
  const std::string name = "cleave/" + std::to_string(domain) + "/" + sensor;
  Address result;
  result.address.sun_family = AF_UNIX;
  name.copy(result.address.sun_path + 1, sizeof result.address.sun_path - 1);
  result.length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  return result;
}

int open_socket() {
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0)
    throw std::runtime_error(std::string("cannot open a socket: ") + std::strerror(errno));
  return fd;
}

// The process that listens there; 0 if it has just gone.
pid_t owner_of(const Address& address) {
  const int fd = open_socket();
  ucred peer{};
  socklen_t length = sizeof peer;
  const bool known = ::connect(fd, address.get(), address.length) == 0 &&
                     ::getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &length) == 0;
  ::close(fd);
  return known ? peer.pid : 0;
}

}  // namespace

SensorLock::SensorLock(std::uint32_t domain, const std::string& sensor) : socket_(open_socket()) {
  const Address address = address_of(domain, sensor);
  if (::bind(socket_, address.get(), address.length) == 0 && ::listen(socket_, 1) == 0) return;
  const int error = errno;
  ::close(socket_);
  if (error != EADDRINUSE) {
    throw std::runtime_error("cannot reserve sensor '" + sensor + "': " + std::strerror(error));
  }
  const pid_t owner = owner_of(address);
  throw std::runtime_error("sensor '" + sensor + "' is already published by " +
                           (owner > 0 ? "process " + std::to_string(owner) : "another process") +
                           "; give this one another name (--sensor), or end that one");
}

SensorLock::~SensorLock() {
  ::close(socket_);
}

}  // namespace cleave
