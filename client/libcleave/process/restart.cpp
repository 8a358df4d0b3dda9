// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/restart.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace cleave {

void restart_in_place(char** arguments) {
  spdlog::warn("restarting in place");
  // Sockets and locks of the old RouDi's runtime must not live on in the new program.
  if (::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC) != 0) {
    spdlog::warn("cannot close the files of the old process: {}", std::strerror(errno));
  }
  ::execv("/proc/self/exe", arguments);
  throw std::runtime_error(std::string("cannot restart /proc/self/exe: ") + std::strerror(errno));
}

}  // namespace cleave
