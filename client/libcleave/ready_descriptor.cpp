// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/ready_descriptor.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

namespace cleave {

ReadyDescriptor::ReadyDescriptor() : descriptor_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (descriptor_ < 0) {
    throw std::system_error(errno, std::generic_category(), "cannot open an event descriptor");
  }
}

ReadyDescriptor::~ReadyDescriptor() {
  ::close(descriptor_);
}

bool ReadyDescriptor::wait(std::chrono::milliseconds timeout) const {
  constexpr std::chrono::milliseconds longest(std::numeric_limits<int>::max());
  pollfd readable{descriptor_, POLLIN, 0};
  const auto ms = timeout.count() < 0 ? -1 : static_cast<int>(std::min(timeout, longest).count());
  const int count = ::poll(&readable, 1, ms);
  if (count < 0 && errno != EINTR) {
    throw std::system_error(errno, std::generic_category(), "cannot wait for samples");
  }
  return count > 0;
}

void ReadyDescriptor::raise() const {
  (void)::eventfd_write(descriptor_, 1);
}

// Fails where it is unreadable already, which is as well.
void ReadyDescriptor::drain() const {
  eventfd_t count = 0;
  (void)::eventfd_read(descriptor_, &count);
}

}  // namespace cleave
