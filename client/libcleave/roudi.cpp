// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/roudi.hpp"

#include <sys/stat.h>

#include "libcleave/internal/roudi_access.hpp"

namespace cleave {
namespace {

// Tells one RouDi's socket file from the next one's; 0 if there is none.
std::uint64_t socket_identity() {
  struct stat status {};
  if (::stat(RouDiPlace{}.socket.c_str(), &status) != 0) return 0;
  const auto seconds = static_cast<std::uint64_t>(status.st_ctim.tv_sec);
  const auto nanoseconds = static_cast<std::uint64_t>(status.st_ctim.tv_nsec);
  return (status.st_ino << 32U) ^ (seconds * 1'000'000'000U + nanoseconds);
}

}  // namespace

bool roudi_answers() {
  return connection_error(RouDiPlace{}.socket) == 0;
}

RouDiWatch::RouDiWatch() : identity_(socket_identity()) {}

RouDiState RouDiWatch::check() {
  if (!roudi_answers()) return RouDiState::gone;
  return socket_identity() == identity_ ? RouDiState::present : RouDiState::replaced;
}

}  // namespace cleave
