#include "libcleave/roudi.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

namespace cleave {
namespace {

constexpr char socket_path[] = "/tmp/roudi";  // compiled into iceoryx 2

// Tells one RouDi's socket file from the next one's; 0 if there is none.
std::uint64_t socket_identity() {
  struct stat status {};
  if (::stat(socket_path, &status) != 0) return 0;
  const auto seconds = static_cast<std::uint64_t>(status.st_ctim.tv_sec);
  const auto nanoseconds = static_cast<std::uint64_t>(status.st_ctim.tv_nsec);
  return (status.st_ino << 32U) ^ (seconds * 1'000'000'000U + nanoseconds);
}

}  // namespace

bool roudi_answers() {
  const int fd = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, socket_path, sizeof socket_path);
  const bool answers =
      ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(fd);
  return answers;
}

RouDiWatch::RouDiWatch() : identity_(socket_identity()) {}

RouDiState RouDiWatch::check() {
  if (!roudi_answers()) return RouDiState::gone;
  return socket_identity() == identity_ ? RouDiState::present : RouDiState::replaced;
}

}  // namespace cleave
